#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/file_bytes.hpp"
#include "io/new_file.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

namespace fs = std::filesystem;
using test::bytes_of;
using test::content_of;
using test::TemporaryFolder;

std::size_t num_files(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(NewFile, IsThereOnlyAfterItIsCommitted) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.txt", "old");
  {
    NewFile file(path);
    file.write("half of the n");
    EXPECT_EQ(content_of(path), "old");
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(num_files(path.parent_path()), 1U);
  NewFile file(path);
  file.write("new ");
  file.write("text");
  file.commit();
  EXPECT_EQ(content_of(path), "new text");
  EXPECT_EQ(num_files(path.parent_path()), 1U);
}

TEST(NewFile, KeepsPermissionsAndLinks) {
  const TemporaryFolder folder;
  const fs::path path = folder.write("a.txt", "old");
  ASSERT_EQ(chmod(path.c_str(), 0640), 0);
  fs::create_symlink("a.txt", folder / "link.txt");
  write_text(folder / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(fs::status(path).permissions(), fs::perms(0640));
}

TEST(Output, ThatCannotBeWrittenIsFoundBeforeTheWork) {
  const TemporaryFolder folder;
  const auto expect = [&](const fs::path& path, auto check, const std::string& words) {
    test::expect_io_error([&] { check(path); }, path, 0, words);
  };
  expect(folder / "nowhere/a.txt", check_output, "No such file");
  fs::create_directory(folder / "sub");
  expect(folder / "sub", check_output, "is a directory");
  expect(folder / "a.foo", check_cloud_output, "unknown extension");
  expect(folder / "a.ply", check_matches_output, "unknown extension");
  expect(folder / "nowhere/a.ply", check_cloud_output, "No such file");
  check_output(folder / "a.txt");
  check_cloud_output(folder / "a.ply");
  check_matches_output(folder / "a.csv");
  check_output("/dev/null");
  EXPECT_EQ(num_files(folder / ""), 1U);
}

TEST(WrittenPcd, HasDoublesOnlyWhereFloatsWouldMoveItsPoints) {
  const TemporaryFolder folder;
  const Points near{{0.1, 4.2, 7}, {2, 5.3, 8}, {3, -6.1, 9}};
  write_cloud(folder / "near.pcd", near);
  EXPECT_NE(content_of(folder / "near.pcd").find("SIZE 4 4 4"), std::string::npos);
  EXPECT_TRUE(read_cloud(folder / "near.pcd").points.isApprox(near, 1e-7));
  const Points far = near.colwise() + Eigen::Vector3d(694300, 5155400, 380);
  write_cloud(folder / "far.pcd", far);
  EXPECT_NE(content_of(folder / "far.pcd").find("SIZE 8 8 8"), std::string::npos);
  EXPECT_EQ(read_cloud(folder / "far.pcd").points, far);
}

// A quarter turn about z, and a shift.
Similarity quarter_turn() {
  Similarity pose;
  pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  pose.translation << 10, 20, 30;
  return pose;
}

TEST(MovedCloud, KeepsTheOtherFieldsOfAPly) {
  const TemporaryFolder folder;
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty uchar red\n"
      "property float x\nproperty float y\nproperty float z\nproperty float nx\n"
      "property float ny\nproperty float nz\nproperty double time\nend_header\n";
  const auto row = [](std::uint8_t red, std::vector<float> values, double time) {
    return bytes_of(red) + bytes_of(values) + bytes_of(time);
  };
  const auto source = folder.write(
      "a.ply", header + row(7, {1, 2, 3, 1, 0, 0}, 0.125) + row(9, {4, 5, NAN, 0, 1, 0}, 0.25));
  write_moved_cloud(folder / "b.ply", source, quarter_turn());
  EXPECT_EQ(content_of(folder / "b.ply"),
            header + row(7, {8, 21, 33, 0, 1, 0}, 0.125) + row(9, {4, 5, NAN, -1, 0, 0}, 0.25));
  Similarity far;
  far.translation << 694300.25, 5155400.125, 380;
  write_moved_cloud(folder / "c.ply", source, far);
  const std::string moved = content_of(folder / "c.ply");
  EXPECT_NE(moved.find("property double x"), std::string::npos);
  EXPECT_NE(moved.find("property uchar red"), std::string::npos);
  EXPECT_EQ(read_cloud(folder / "c.ply").points, (Points{{694301.25}, {5155402.125}, {383}}));
}

TEST(MovedCloud, KeepsTheImageOfAnOrganisedPcd) {
  const TemporaryFolder folder;
  const std::string header =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z intensity _\n"
      "SIZE 4 4 4 2 1\nTYPE F F F U U\nCOUNT 1 1 1 1 2\nWIDTH 2\nHEIGHT 2\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 4\nDATA binary\n";
  const auto row = [](std::vector<float> point, std::uint16_t intensity) {
    return bytes_of(point) + bytes_of(intensity) + "ab";
  };
  const auto source = folder.write("a.pcd", header + row({1, 2, 3}, 7) + row({0, 0, 0}, 8) +
                                                row({NAN, NAN, NAN}, 9) + row({4, 5, 6}, 10));
  write_moved_cloud(folder / "b.pcd", source, quarter_turn());
  EXPECT_EQ(content_of(folder / "b.pcd"), header + row({8, 21, 33}, 7) + row({0, 0, 0}, 8) +
                                              row({NAN, NAN, NAN}, 9) + row({5, 24, 36}, 10));
  write_moved_cloud(folder / "b.ply", source, quarter_turn());
  EXPECT_NE(content_of(folder / "b.ply").find("property ushort intensity"), std::string::npos);
  write_moved_cloud(folder / "b.csv", source, quarter_turn());
  EXPECT_EQ(content_of(folder / "b.csv"), "x,y,z\n8,21,33\n5,24,36\n");
}

TEST(MovedCloud, KeepsTheFacesOfAMesh) {
  const TemporaryFolder folder;
  const auto source = folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  write_moved_cloud(folder / "b.ply", source, quarter_turn());
  EXPECT_EQ(read_cloud(folder / "b.ply", {.mesh_points = 0}).points,
            (Points{{10, 10, 9}, {20, 21, 20}, {30, 30, 30}}));
  EXPECT_EQ(read_cloud(folder / "b.ply", {.mesh_points = 50}).points.cols(), 50);
  write_moved_cloud(folder / "b.xyz", source, quarter_turn(), {.mesh_points = 50});
  EXPECT_EQ(read_cloud(folder / "b.xyz").points.cols(), 50);
}

}  // namespace
}  // namespace gmcr::io
