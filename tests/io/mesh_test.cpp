#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/file_bytes.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::bytes_of;
using test::TemporaryFolder;

// A flat plate of 3 x 1 of a square and a long triangle pair, in each format.
constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_index\nend_header\n"
    "0 0 5\n1 0 5\n3 0 5\n3 1 5\n1 1 5\n0 1 5\n4 0 1 4 5\n4 1 2 3 4\n";
constexpr const char* kObj =
    "# plate\no plate\nv 0 0 5\nv 1 0 5 1 0 0\nv 3 0 5\nv 3 1 5\nv 1 1 5\nv 0 1 5\nvn 0 0 1\n"
    "f 1/1/1 2//1 5 6\nf -5 \\\n -4 -3 -2\n";
constexpr const char* kOff =
    "OFF # plate\n6 2 0\n0 0 5\n1 0 5\n3 0 5\n\n3 1 5\n1 1 5\n0 1 5\n4 0 1 4 5 255 0 0\n4 1 2 3 "
    "4\n";
constexpr const char* kStl =
    "solid plate\nfacet normal 0 0 1\nouter loop\nvertex 0 0 5\nvertex 3 0 5\nvertex 3 1 5\n"
    "endloop\nendfacet\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 5\nVERTEX 3 1 5\nVERTEX 0 1 5\n"
    "ENDLOOP\nENDFACET\nendsolid plate\n";

/// The square as a strip, and the pair as another one.
constexpr const char* kStrips =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
    "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    "0 0 5\n1 0 5\n3 0 5\n3 1 5\n1 1 5\n0 1 5\n9 0 1 5 4 -1 1 2 4 3\n";

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string binary_stl() {
  std::string bytes = "solid but binary" + std::string(64, ' ') + bytes_of(std::uint32_t{2});
  bytes += bytes_of(std::vector<float>{0, 0, 1, 0, 0, 5, 3, 0, 5, 3, 1, 5}) + "ab";
  bytes += bytes_of(std::vector<float>{0, 0, 1, 0, 0, 5, 3, 1, 5, 0, 1, 5}) + "ab";
  return bytes;
}

TEST(Mesh, IsSampledEvenlyOnItsSurface) {
  const TemporaryFolder folder;
  for (const auto& [name, text] : {std::pair<std::string, std::string>{"a.ply", kPly},
                                   {"a.obj", kObj},
                                   {"a.off", kOff},
                                   {"a.stl", kStl},
                                   {"c.ply", kStrips},
                                   {"c.off", "OFF6 2 0" + std::string(kOff).substr(17)},
                                   {"c.stl", "\xEF\xBB\xBF" + upper(kStl)},
                                   {"b.stl", binary_stl()}}) {
    const auto path = folder.write(name, text);
    const Cloud cloud = read_cloud(path, {.mesh_points = 3000});
    ASSERT_EQ(cloud.points.cols(), 3000) << name;
    EXPECT_TRUE((cloud.points.row(2).array() == 5).all()) << name;
    ASSERT_EQ(cloud.notes.size(), 1U) << name;
    EXPECT_NE(cloud.notes[0].find("3000 points are spread over its surface"), std::string::npos);
    // cells of 0.1 x 0.1 expect 10 points each
    Eigen::MatrixXi counts = Eigen::MatrixXi::Zero(30, 10);
    for (Index i = 0; i < cloud.points.cols(); ++i) {
      const double x = cloud.points(0, i), y = cloud.points(1, i);
      ASSERT_TRUE(x >= 0 && x <= 3 && y >= 0 && y <= 1) << name;
      ++counts(std::min(29, static_cast<int>(10 * x)), std::min(9, static_cast<int>(10 * y)));
    }
    EXPECT_GE(counts.minCoeff(), 4) << name;
    EXPECT_LE(counts.maxCoeff(), 17) << name;
    EXPECT_EQ(read_cloud(path, {.mesh_points = 3000}).points, cloud.points) << name;
    EXPECT_EQ(read_cloud(path).points.cols(), CloudOptions{}.mesh_points);
  }
}

TEST(Mesh, GivesItsVerticesWhereThatIsAsked) {
  const TemporaryFolder folder;
  const Points vertices{{0, 1, 3, 3, 1, 0}, {0, 0, 0, 1, 1, 1}, {5, 5, 5, 5, 5, 5}};
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"a.ply", kPly}, {"a.obj", kObj}, {"a.off", kOff}}) {
    const Cloud cloud = read_cloud(folder.write(name, text), {.mesh_points = 0});
    EXPECT_EQ(cloud.points, vertices) << name;
    EXPECT_EQ(cloud.notes, std::vector<std::string>{"a mesh: its vertices are taken"});
  }
  EXPECT_EQ(read_cloud(folder.write("b.stl", binary_stl()), {.mesh_points = 0}).points.cols(), 6);
}

TEST(Mesh, OfFewFacesAmongManyPointsIsACloud) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 1\n1 0 1\n0 1 1\n5 5 5\n6 6 6\n7 7 7\n8 8 8\n3 0 1 2\n");
  const Cloud cloud = read_cloud(path);
  EXPECT_EQ(cloud.points.cols(), 7);
  ASSERT_EQ(cloud.notes.size(), 1U);
  EXPECT_NE(cloud.notes[0].find("use 43 % of the points"), std::string::npos) << cloud.notes[0];
}

TEST(Mesh, WithoutAnAreaGivesItsVertices) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n");
  EXPECT_EQ(read_cloud(path).points.cols(), 3);
}

TEST(Mesh, ThatIsMalformedIsAnError) {
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& name, const std::string& text, std::size_t line,
                          const std::string& words) {
    const auto path = folder.write(name, text);
    test::expect_io_error([&] { read_cloud(path); }, path, line, words);
  };
  expect("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", 3, "vertex 3 of a face, but there are 2");
  expect("a.obj", "v 0 0 0\nf 0 1 1\n", 2, "'0' is no vertex");
  expect("a.obj", "v 0 0 0\nf -2 1 1\n", 2, "'-2' is no vertex");
  expect("a.obj", "v 0 zero 0\n", 1, "'zero' is no number");
  expect("a.obj", "f 1 2 3\n", 0, "no vertices");
  expect("a.off", "OFF\n3 1 0\n0 0 0\n1 1 1\n", 4, "truncated");
  expect("a.off", "OFF\n1999999999 1 0\n0 0 0\n", 2, "truncated");
  expect("a.off", "OFF\n1 1 0\n0 0 0\n3 0 1 2\n", 4, "'1' is none of the 1 vertices");
  expect("a.off", "OFF BINARY\nabc\n", 1, "binary OFF");
  expect("a.off", "4OFF\n1 0 0\n0 0 0 0\n", 1, "3 coordinates");
  expect("a.stl", "solid a\nfacet\nvertex 1 2 3\nendfacet\n", 4, "without 3 vertices");
  expect("a.stl", std::string(kStl).substr(0, std::string(kStl).find("endsolid")), 15,
         "truncated: no endsolid");
  expect("a.stl", binary_stl().substr(5, 170), 0, "truncated or no STL");
  expect("a.stl", binary_stl() + "more", 0,
         "188 bytes where 2 triangles of a binary file take 184");
}

}  // namespace
}  // namespace gmcr::io
