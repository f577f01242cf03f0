#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>

#include "gmcr/io.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::TemporaryFolder;

const Points kThree{{1, 4, 7}, {2, 5.25, 8}, {3, -6, 0.09375}};

std::string float_bytes(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

class WritableCloud : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Extensions, WritableCloud,
                         testing::Values("ply", "pcd", "xyz", "txt", "asc", "csv", "npy", "PLY"),
                         [](const auto& extension) { return std::string(extension.param); });

TEST_P(WritableCloud, IsReadBackBitForBit) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("cloud.") + GetParam());
  rc::check([&](std::vector<double> values) {
    for (double& value : values) {
      // PCD holds float32
      if (path.extension() == ".pcd") value = static_cast<float>(value);
      if (!std::isfinite(value) || value == 0) value = 0.5;  // (0, 0, 0) may mark no return
      // and what is a billion times as far as the others does
      int exponent = 0;
      value = std::frexp(value, &exponent);
      value = std::ldexp(value, exponent % 14);
    }
    values.resize(3 * (values.size() / 3 + 1), 0.375);
    const Points points =
        Eigen::Map<const Points>(values.data(), 3, static_cast<Index>(values.size()) / 3);
    write_cloud(path, points);
    const Cloud cloud = read_cloud(path);
    RC_ASSERT(cloud.num_dropped == 0);
    RC_ASSERT(cloud.points == points);
  });
}

TEST_P(WritableCloud, ThatHoldsNonFinitePointsLosesAndCountsThem) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("cloud.") + GetParam());
  Points points = kThree;
  points(1, 0) = std::numeric_limits<double>::quiet_NaN();
  points(2, 2) = -std::numeric_limits<double>::infinity();
  write_cloud(path, points);
  const Cloud cloud = read_cloud(path);
  EXPECT_EQ(cloud.num_dropped, 2);
  EXPECT_EQ(cloud.points, Points(kThree.col(1)));
}

TEST_P(WritableCloud, IsTheSameInALocaleWithDecimalCommas) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("cloud.") + GetParam());
  const std::string before = std::setlocale(LC_ALL, nullptr);
  bool has_locale = false;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
    has_locale = has_locale || std::setlocale(LC_ALL, name);
  }
  write_cloud(path, kThree);
  const Cloud cloud = read_cloud(path);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(cloud.points, kThree);
  if (!has_locale) GTEST_SKIP() << "no locale with a decimal comma is installed";
}

TEST(ReadCloud, TakesAsciiPlyWithExtraPropertiesAndFaces) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 3\nproperty uchar red\n"
      "property float x\nproperty float y\nproperty double z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n9 1 2 3\n9 4 5.25 -6\n9 7 8 9\n3 0 1 "
      "2\n");
  EXPECT_EQ(read_cloud(path, {.mesh_points = 0}).points,
            (Points{{1, 4, 7}, {2, 5.25, 8}, {3, -6, 9}}));
}

TEST(ReadCloud, TakesAsciiPcdWithExtraFields) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "a.pcd",
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 "
      "1\n"
      "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA ascii\n1 2 3 7\nnan nan nan 7\n"
      "4 5.25 -6 7\n");
  const Cloud cloud = read_cloud(path);
  EXPECT_EQ(cloud.num_dropped, 1);
  EXPECT_EQ(cloud.points, (Points{{1, 4}, {2, 5.25}, {3, -6}}));
}

TEST(ReadCloud, IgnoresFurtherColumnsOfXyz) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.xyz", "1 2 3 0 0 1\r\n\n# a comment\n+4\t5.25 -6 0 0 1");
  EXPECT_EQ(read_cloud(path).points, (Points{{1, 4}, {2, 5.25}, {3, -6}}));
}

TEST(ReadCloud, TakesPtsWithIntensityAndColour) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.pts", "2\n1 2 3 -100 1 2 3\n4 5.25 -6 20 1 2 3\n");
  EXPECT_EQ(read_cloud(path).points, (Points{{1, 4}, {2, 5.25}, {3, -6}}));
}

TEST(ReadCloud, TakesEveryCommonSeparatorOfCsv) {
  const TemporaryFolder folder;
  const Points expected{{1, 4}, {2, 5.25}, {3, -6}};
  for (const char* text : {"1,2,3\n4,5.25,-6\n", "1; 2; 3\n4; 5.25; -6\n", "1 2  3\n4\t5.25 -6\n",
                           "x,y,z\n1,2,3\n4,5.25,-6\n", "\xEF\xBB\xBFX;Y;Z\r\n1;2;3\r\n4;5.25;-6",
                           "# no header\n1,2,3\n4,5.25,-6\n"}) {
    EXPECT_EQ(read_cloud(folder.write("a.csv", text)).points, expected) << text;
  }
}

TEST(ReadCloud, FindsTheColumnsOfCsvByName) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.csv", "label,\"z\",x,Y\nchair,3,1,2\ntable,-6,4,5.25\n");
  EXPECT_EQ(read_cloud(path).points, (Points{{1, 4}, {2, 5.25}, {3, -6}}));
}

TEST(ReadCloud, TakesKittiAndNuScenesScans) {
  const TemporaryFolder folder;
  const Points expected{{1, 4}, {2, 5.25}, {3, -6}};
  EXPECT_EQ(read_cloud(folder.write("a.bin", float_bytes({1, 2, 3, 0.5, 4, 5.25, -6, 0.5}))).points,
            expected);
  EXPECT_EQ(
      read_cloud(folder.write("a.pcd.bin", float_bytes({1, 2, 3, 9, 0, 4, 5.25, -6, 9, 1}))).points,
      expected);
}

TEST(ReadCloud, TakesPcdOfDoublesAndIntegersInAnyOrder) {
  const TemporaryFolder folder;
  std::string bytes =
      "FIELDS z i x y\nSIZE 8 1 2 4\nTYPE F U I U\nCOUNT 1 2 1 1\nPOINTS 1\nDATA binary\n";
  const double z = 1e7 + 1.0 / 3;
  const std::int16_t x = -7;
  const std::uint32_t y = 3000000000u;
  bytes.append(reinterpret_cast<const char*>(&z), 8).append("ii");
  bytes.append(reinterpret_cast<const char*>(&x), 2).append(reinterpret_cast<const char*>(&y), 4);
  EXPECT_EQ(read_cloud(folder.write("a.pcd", bytes)).points, Points(Eigen::Vector3d(-7, 3e9, z)));
}

std::string npy(const std::string& dictionary, const std::string& data, char version = 1) {
  std::string bytes = std::string("\x93NUMPY") + version + '\0';
  bytes += static_cast<char>(dictionary.size());
  bytes += '\0';
  if (version > 1) bytes += std::string(2, '\0');
  return bytes + dictionary + data;
}

TEST(ReadCloud, TakesBothOrdersAndTypesOfNpy) {
  const TemporaryFolder folder;
  const Points expected{{1, 4}, {2, 5.25}, {3, -6}};
  const std::string c_order = float_bytes({1, 2, 3, 4, 5.25, -6});
  const std::string fortran_order = float_bytes({1, 4, 2, 5.25, 3, -6});
  const auto read = [&](const std::string& bytes) {
    return read_cloud(folder.write("a.npy", bytes)).points;
  };
  EXPECT_EQ(read(npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }\n", c_order)),
            expected);
  EXPECT_EQ(read(npy("{'descr':'<f4','fortran_order':True,'shape':(2,3)}\n", fortran_order)),
            expected);
  EXPECT_EQ(read(npy("{\"shape\": (2, 3), 'descr': '<f4', 'fortran_order': False}", c_order, 2)),
            expected);
}

TEST_P(WritableCloud, LosesPointsABillionTimesAsFarAsTheOthers) {
  const TemporaryFolder folder;
  const auto path = folder / (std::string("cloud.") + GetParam());
  for (const double far : {3.4028234663852886e38, 1e20, -1e12}) {
    Points points(3, 5);
    points << kThree, Points::Constant(3, 2, far);
    points(0, 4) = 1;  // one coordinate is enough
    write_cloud(path, points);
    const Cloud cloud = read_cloud(path);
    EXPECT_EQ(cloud.num_dropped, 2) << far;
    EXPECT_TRUE(cloud.points.isApprox(kThree, 1e-6)) << far;
    EXPECT_EQ(cloud.notes, std::vector<std::string>{"dropped 2 points that are not finite, or a "
                                                    "billion times as far as the others"});
  }
  // a cloud may be as large as it likes, and have a point far off
  for (const double scale : {1e15, 1e-15}) {
    Points points(3, 4);
    points << kThree, Points::Constant(3, 1, 1e8);
    write_cloud(path, scale * points);
    EXPECT_EQ(read_cloud(path).points.cols(), 4) << scale;
  }
}

TEST(Npy, OfMoreColumnsInMoreRowsIsACloudOfTheFirstThree) {
  const TemporaryFolder folder;
  const Points points = Points::Random(3, 8);
  write_matches(folder / "a.npy", points, points);  // (8, 6)
  const Cloud cloud = read_cloud(folder / "a.npy");
  EXPECT_EQ(cloud.points, points);
  EXPECT_EQ(cloud.notes, std::vector<std::string>{"x, y, z are the first 3 of 6 columns"});
  write_matches(folder / "b.npy", points.leftCols(6), points.leftCols(6));
  EXPECT_THROW(read_cloud(folder / "b.npy"), IoError);
}

}  // namespace
}  // namespace gmcr::io
