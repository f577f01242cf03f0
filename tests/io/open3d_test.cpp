#include <gtest/gtest.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/io/PointCloudIO.h>

#include "gmcr/io.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::TemporaryFolder;

open3d::geometry::PointCloud wavy_cloud(int num_points) {
  open3d::geometry::PointCloud cloud;
  for (int i = 0; i < num_points; ++i) {
    // exact in float32, since Open3D writes PCD so
    cloud.points_.emplace_back(i * 0.25, (i % 7) * 0.5, -i);
  }
  return cloud;
}

void expect_same(const Points& points, const open3d::geometry::PointCloud& cloud) {
  ASSERT_EQ(points.cols(), static_cast<Index>(cloud.points_.size()));
  for (Index i = 0; i < points.cols(); ++i) {
    EXPECT_EQ(points.col(i), cloud.points_[static_cast<std::size_t>(i)]) << i;
  }
}

TEST(Open3DCloud, OfEveryEncodingIsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const auto cloud = wavy_cloud(200);
  for (const char* name : {"a.ply", "a.pcd", "a.xyz", "a.pts"}) {
    for (const bool is_ascii : {false, true}) {
      for (const bool is_compressed : {false, true}) {
        const auto path = folder / name;
        ASSERT_TRUE(open3d::io::WritePointCloud(path.string(), cloud, {is_ascii, is_compressed}));
        SCOPED_TRACE(std::string(name) + (is_ascii ? " ascii" : "") +
                     (is_compressed ? " compressed" : ""));
        expect_same(read_cloud(path).points, cloud);
      }
    }
  }
}

TEST(Open3DCloud, ReadsWhatIsWritten) {
  const TemporaryFolder folder;
  const auto cloud = wavy_cloud(50);
  Points points(3, 50);
  for (Index i = 0; i < 50; ++i) points.col(i) = cloud.points_[static_cast<std::size_t>(i)];
  for (const char* name : {"a.ply", "a.pcd", "a.xyz"}) {
    write_cloud(folder / name, points);
    open3d::geometry::PointCloud read;
    ASSERT_TRUE(open3d::io::ReadPointCloud((folder / name).string(), read));
    expect_same(points, read);
  }
}

TEST(CompressedPcd, CutOrDamagedAnywhereIsAnErrorOrACloudOfItsSize) {
  const TemporaryFolder folder;
  const auto path = folder / "a.pcd";
  ASSERT_TRUE(open3d::io::WritePointCloud(path.string(), wavy_cloud(60), {false, true}));
  const std::string whole = test::content_of(path);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(read_cloud(folder.write("cut.pcd", whole.substr(0, size))), IoError) << size;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    try {
      const Cloud cloud = read_cloud(folder.write("damaged.pcd", damaged));
      EXPECT_LE(cloud.points.cols() + cloud.num_dropped, 99);
    } catch (const IoError&) {
      SUCCEED();
    }
  }
}

TEST(ReadCloud, PrintsNothing) {
  const TemporaryFolder folder;
  folder.write("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
               "property float y\nproperty float z\nend_header\n1 2 3\n");
  folder.write("a.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 9\nDATA binary\nabc");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_THROW(read_cloud(folder / "a.ply"), IoError);
  EXPECT_THROW(read_cloud(folder / "a.pcd"), IoError);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace gmcr::io
