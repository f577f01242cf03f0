#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "data_folder.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::frontend {
namespace {

namespace fs = std::filesystem;
using testing::data_folder;

/// Points of a binary PLY whose only element has the float properties x, y, z.
Points read_xyz_ply(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  Index count = 0;
  while (std::getline(file, line) && line != "end_header") {
    std::istringstream words(line);
    std::string first, second;
    if (words >> first >> second && first == "element" && second == "vertex") words >> count;
  }
  Eigen::Matrix3Xf points(3, count);
  file.read(reinterpret_cast<char*>(points.data()),
            static_cast<std::streamsize>(points.size() * sizeof(float)));
  return points.cast<double>();
}

Similarity read_transform(const fs::path& path) {
  std::ifstream file(path);
  Eigen::Matrix4d matrix;
  for (int i = 0; i < 16; ++i) file >> matrix(i / 4, i % 4);
  return Similarity::from_matrix(matrix);
}

class RealPair : public ::testing::TestWithParam<const char*> {};

TEST_P(RealPair, IsRegisteredAndTrustedWithDefaultOptions) {
  const fs::path folder = data_folder() / GetParam();
  if (!fs::exists(folder)) GTEST_SKIP() << "no real data at " << folder << "; set GMCR_DATA";
  const Points source = read_xyz_ply(folder / "source.ply");
  const Points target = read_xyz_ply(folder / "target.ply");
  const Similarity truth = read_transform(folder / "T_target_source.txt");
  const CloudResult result = register_clouds(source, target);
  ASSERT_EQ(result.registration.status, Status::Ok);
  const double extent = (target.rowwise().maxCoeff() - target.rowwise().minCoeff()).norm();
  EXPECT_LT(rotation_error_deg(result.registration.target_from_source.rotation, truth.rotation), 5);
  EXPECT_LT(mean_point_error(result.registration.target_from_source, truth, source), 0.05 * extent);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
}

INSTANTIATE_TEST_SUITE_P(Frontend, RealPair,
                         ::testing::Values("stanford_scans/bunny_045_000",
                                           "mian_views/trex_view1_view0",
                                           "lidar/kitti00_000010_000000", "3dmatch/redkitchen_4_0",
                                           "rgbd_frames/7scenes_700_000"));

class RealObject : public ::testing::TestWithParam<const char*> {};

TEST_P(RealObject, IsFoundByTurningItAndDoubtedForItsSymmetry) {
  const fs::path folder = data_folder() / GetParam();
  if (!fs::exists(folder)) GTEST_SKIP() << "no real data at " << folder << "; set GMCR_DATA";
  const Points source = read_xyz_ply(folder / "source.ply");
  const Points target = read_xyz_ply(folder / "target.ply");
  const Similarity truth = read_transform(folder / "T_target_source.txt");
  const CloudResult result = register_clouds(source, target);
  ASSERT_EQ(result.registration.status, Status::Ok);
  EXPECT_TRUE(result.found_by_turning) << result.verdict_reason;
  EXPECT_EQ(result.verdict, Verdict::Doubtful) << result.verdict_reason;
  EXPECT_FALSE(result.rivals.empty());
  EXPECT_LT(rotation_error_deg(result.registration.target_from_source.rotation, truth.rotation), 5);
}

INSTANTIATE_TEST_SUITE_P(Frontend, RealObject,
                         ::testing::Values("objects_ycb/009_gelatin_box",
                                           "objects_ycb/010_potted_meat_can"));

TEST(RealObjects, WithoutSymmetryAreTrustedWhereNoMatchSpeaksForThem) {
  const fs::path folder = data_folder() / "objects_ycb/035_power_drill";
  if (!fs::exists(folder)) GTEST_SKIP() << "no real data at " << folder << "; set GMCR_DATA";
  const Points source = read_xyz_ply(folder / "source.ply");
  Points target = read_xyz_ply(folder / "target.ply");
  const Similarity truth = read_transform(folder / "T_target_source.txt");
  const CloudResult result = register_clouds(source, target);
  EXPECT_TRUE(result.found_by_turning);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  EXPECT_LT(rotation_error_deg(result.registration.target_from_source.rotation, truth.rotation), 1);
  // its mirror image looks alike
  target.row(0) *= -1;
  const CloudResult mirrored = register_clouds(source, target);
  EXPECT_NE(mirrored.verdict, Verdict::Trusted) << mirrored.verdict_reason;
}

}  // namespace
}  // namespace gmcr::frontend
