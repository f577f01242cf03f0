#include <gtest/gtest.h>
#include <lzf.h>

#include <cmath>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/file_bytes.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::bytes_of;
using test::TemporaryFolder;

const Points kTwoPoints{{1, 4}, {2, 5}, {3, 6}};

std::string header(const std::string& size, const std::string& type, const std::string& data,
                   int count = 2) {
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE " + size + " " + size + " " + size +
         "\nTYPE " + type + " " + type + " " + type + "\nCOUNT 1 1 1\nWIDTH " +
         std::to_string(count) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(count) + "\nDATA " + data + "\n";
}

/// Sizes and packed bytes of binary_compressed.
std::string compressed(const std::string& columns) {
  std::string packed(columns.size() + 100, '\0');
  packed.resize(lzf_compress(columns.data(), static_cast<unsigned>(columns.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  return bytes_of(static_cast<std::uint32_t>(packed.size())) +
         bytes_of(static_cast<std::uint32_t>(columns.size())) + packed;
}

template <typename Number>
void expect_type(const std::string& type) {
  const TemporaryFolder folder;
  const std::string size = std::to_string(sizeof(Number));
  const std::string rows = bytes_of(std::vector<Number>{1, 2, 3, 4, 5, 6});
  const std::string columns = bytes_of(std::vector<Number>{1, 4, 2, 5, 3, 6});
  const auto sizes = bytes_of(static_cast<std::uint32_t>(columns.size()));
  for (const auto& [data, body] : {std::pair{std::string("ascii"), std::string("1 2 3\n4 5 6\n")},
                                   {"binary", rows},
                                   {"binary_compressed", compressed(columns)},
                                   {"binary_compressed", sizes + sizes + columns}}) {
    const auto path = folder.write("a.pcd", header(size, type, data) + body);
    EXPECT_EQ(read_cloud(path).points, kTwoPoints) << type << size << " " << data;
  }
}

TEST(Pcd, OfEveryTypeAndEncodingIsRead) {
  expect_type<std::int8_t>("I");
  expect_type<std::int16_t>("I");
  expect_type<std::int32_t>("I");
  expect_type<std::int64_t>("I");
  expect_type<std::uint8_t>("U");
  expect_type<std::uint16_t>("U");
  expect_type<std::uint32_t>("U");
  expect_type<std::uint64_t>("U");
  expect_type<float>("F");
  expect_type<double>("F");
}

TEST(Pcd, TakesFieldsOfSeveralValuesAmongTheCoordinates) {
  const TemporaryFolder folder;
  const std::string start =
      "FIELDS _ z n y x\nSIZE 1 4 4 8 4\nTYPE U F F F I\nCOUNT 3 1 3 1 1\nWIDTH 2\nHEIGHT 1\n";
  const auto row = [](float z, double y, std::int32_t x) {
    return std::string("abc") + bytes_of(z) + std::string(12, 'n') + bytes_of(y) + bytes_of(x);
  };
  EXPECT_EQ(read_cloud(folder.write("a.pcd", start + "DATA binary\n" + row(3, 2, 1) + row(6, 5, 4)))
                .points,
            kTwoPoints);
  const std::string columns = "abcabc" + bytes_of(std::vector<float>{3, 6}) + std::string(24, 'n') +
                              bytes_of(std::vector<double>{2, 5}) +
                              bytes_of(std::vector<std::int32_t>{1, 4});
  EXPECT_EQ(
      read_cloud(folder.write("b.pcd", start + "DATA binary_compressed\n" + compressed(columns)))
          .points,
      kTwoPoints);
  EXPECT_EQ(read_cloud(folder.write("c.pcd", start + "DATA ASCII\n9 9 9 3 0 0 1 2 1\n"
                                                     "9 9 9 6 0 0 1 5 4\n"))
                .points,
            kTwoPoints);
}

TEST(Pcd, OrganisedHasNoReturnWhereItIsZero) {
  const TemporaryFolder folder;
  const std::string start = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 2\nDATA ascii\n";
  const Cloud cloud =
      read_cloud(folder.write("a.pcd", start + "1 2 3\n0 0 0\nnan nan nan\n4 5 6\n"));
  EXPECT_EQ(cloud.points, kTwoPoints);
  EXPECT_EQ(cloud.num_dropped, 2);
  ASSERT_EQ(cloud.notes.size(), 2U);
  EXPECT_EQ(cloud.notes[1], "dropped 1 points at (0, 0, 0), which mark no return");
  const std::string flat = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 3\nHEIGHT 1\nDATA ascii\n";
  EXPECT_EQ(read_cloud(folder.write("b.pcd", flat + "1 2 3\n0 0 0\n4 5 6\n")).points.cols(), 3);
}

TEST(Pcd, ThatIsMalformedIsAnError) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& text, std::size_t line, const std::string& words) {
    const auto path = folder.write("a.pcd", text);
    test::expect_io_error([&] { read_cloud(path); }, path, line, words);
  };
  const std::string xyz = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";
  const std::string body = compressed(bytes_of(std::vector<float>{1, 2, 3}));
  expect(xyz + "POINTS 1\nWIDTH 999999\nHEIGHT 999\nDATA binary_compressed\n" + body, 0,
         "POINTS 1, WIDTH times HEIGHT 998999001");
  expect(xyz + "WIDTH 999999\nHEIGHT 999\nDATA binary_compressed\n" + body, 0, "truncated");
  expect(xyz + "POINTS 1\nDATA binary_compressed\n" + body.substr(0, 9), 0, "truncated");
  expect(xyz + "POINTS 1\nDATA binary_compressed\n" + bytes_of(std::vector<std::uint32_t>{4, 12}) +
             "\xFF\xFF\xFF\xFF",
         0, "damaged");
  expect("FIELDS x q y\nSIZE 4 4 4\nTYPE F F F\nPOINTS 1\nDATA binary\n", 0, "no x, y and z");
  expect("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 2 1\nPOINTS 1\nDATA ascii\n1 2 3 4\n", 0,
         "'y' has several values");
  expect("FIELDS x y z\nSIZE 4 4 4\nTYPE F F\nPOINTS 1\nDATA ascii\n1 2 3\n", 0,
         "TYPE of 2 for 3 fields");
  expect("FIELDS x y z\nSIZE 4 4 2\nTYPE F F F\nPOINTS 1\nDATA ascii\n1 2 3\n", 0, "2 F 1");
  expect("FIELDS x y z\nSIZE 4 4 4\nTYPE F F Q\nPOINTS 1\nDATA ascii\n1 2 3\n", 0, "4 Q 1");
  // normals of which one component is there, which crashes other readers
  const std::string partial = "FIELDS x y z normal_x\nSIZE 4 4 4 4\nTYPE F F F F\nPOINTS 1\n";
  const std::string columns = compressed(bytes_of(std::vector<float>{1, 2, 3, 1}));
  EXPECT_EQ(
      read_cloud(folder.write("b.pcd", partial + "DATA binary_compressed\n" + columns)).points,
      (Points{{1}, {2}, {3}}));
}

}  // namespace
}  // namespace gmcr::io
