#include <gtest/gtest.h>

#include <filesystem>

#include "data_folder.hpp"
#include "gmcr/io.hpp"

namespace gmcr::io {
namespace {

using testing::data_folder;

class RealData : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(data_folder() / "README.md")) {
      GTEST_SKIP() << "no data at " << data_folder() << "; set GMCR_DATA";
    }
  }
};

TEST_F(RealData, MatchesOfBothLayoutsHaveTheRightColumns) {
  const Matches kitti = read_matches(data_folder() / "kitti_fpfh/kitti_000/correspondences.csv");
  ASSERT_EQ(kitti.source.cols(), 5344);
  EXPECT_EQ(kitti.source.col(0), Eigen::Vector3d(-2.55025, 43.8988, -3.59623));
  EXPECT_EQ(kitti.target.col(0), Eigen::Vector3d(11.1698, 25.9378, -2.28502));
  const Matches gore = read_matches(data_folder() / "gore/bunny/correspondences.csv");
  ASSERT_EQ(gore.source.cols(), 1000);
  EXPECT_EQ(gore.source.col(0), Eigen::Vector3d(31.75324, -0.447475, -5.726363));
  EXPECT_EQ(gore.target.col(0), Eigen::Vector3d(23.22718, -1.908014, 10.81895));
}

TEST_F(RealData, NuScenesScanEqualsItsPly) {
  const auto stem =
      data_folder() / "nuscenes/n015-2018-07-24-11-22-45+0800__LIDAR_TOP__1532402927647951";
  const Cloud scan = read_cloud(stem.string() + ".pcd.bin");
  EXPECT_EQ(scan.points.cols(), 34688);
  EXPECT_EQ(scan.points, read_cloud(stem.string() + ".ply").points);
}

TEST_F(RealData, ClaimedPosesAreSimilaritiesNearTheRefinedOnes) {
  const auto folder = data_folder() / "kitti_fpfh/kitti_000";
  const Similarity truth = read_transform(folder / "T_target_source.txt");
  const Similarity published = read_transform(folder / "T_published.txt");
  EXPECT_LT((truth.translation - published.translation).norm(), 0.1);
  EXPECT_NEAR(truth.scale, 1, 1e-5);
}

}  // namespace
}  // namespace gmcr::io
