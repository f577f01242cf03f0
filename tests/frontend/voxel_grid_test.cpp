#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>

#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {
namespace {

using testing::random_points;

/// Means by a map from cell to points, written without the numbering of cells.
Points voxel_grid_oracle(const Points& points, double size) {
  const Eigen::Vector3d origin = points.rowwise().minCoeff();
  std::map<std::array<double, 3>, std::pair<Eigen::Vector3d, double>> cells;
  for (const auto& p : points.colwise()) {
    const Eigen::Vector3d c = (p - origin) / size;
    auto [cell, added] = cells.try_emplace(
        {std::floor(c.x()), std::floor(c.y()), std::floor(c.z())}, Eigen::Vector3d::Zero(), 0.0);
    cell->second.first += p;
    cell->second.second += 1;
  }
  Points means(3, static_cast<Index>(cells.size()));
  Index i = 0;
  for (const auto& [cell, sum] : cells) means.col(i++) = sum.first / sum.second;
  return means;
}

TEST(VoxelGrid, OfRandomPointsAgreesWithAMapOfCells) {
  for (const double size : {0.05, 0.2, 0.7}) {
    const Points points = random_points(2000, 7);
    const Points expected = voxel_grid_oracle(points, size);
    const Points actual = voxel_grid(points, size);
    ASSERT_EQ(actual.cols(), expected.cols());
    EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(VoxelGrid, OfNoPointsIsEmpty) { EXPECT_EQ(voxel_grid(Points(3, 0), 1).cols(), 0); }

TEST(VoxelGrid, OfOnePointIsThatPoint) {
  const Points point = Eigen::Vector3d(1e6, -2, 3);
  EXPECT_EQ(voxel_grid(point, 0.1), point);
}

TEST(VoxelGrid, OfDuplicatesIsOnePoint) {
  const Points points = Eigen::Vector3d(0.1, 0.2, 0.3).replicate(1, 50);
  EXPECT_EQ(voxel_grid(points, 0.01), points.leftCols(1));
}

TEST(VoxelGrid, LargerThanTheCloudIsTheMean) {
  const Points points = random_points(100, 3);
  const Points mean = voxel_grid(points, 10);
  ASSERT_EQ(mean.cols(), 1);
  EXPECT_LT((mean - points.rowwise().mean()).norm(), 1e-12);
}

TEST(VoxelGrid, FinerThanTheSpacingKeepsEveryPoint) {
  EXPECT_EQ(voxel_grid(random_points(300, 4), 1e-5).cols(), 300);
}

TEST(VoxelGrid, FarFromTheOriginLosesNothing) {
  // multiples of 2^-20 stay exact at 1e6, so that both clouds fall into the same cells
  Points points = (random_points(500, 5) * 1048576).array().round() / 1048576;
  const Eigen::Vector3d offset = Eigen::Vector3d::Constant(1048576);
  const Points near = voxel_grid(points, 0.25);
  const Points far = voxel_grid(points.colwise() + offset, 0.25);
  ASSERT_EQ(far.cols(), near.cols());
  EXPECT_LT(((far.colwise() - offset) - near).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(VoxelGrid, ThatOverflowsNamesTheVoxelSize) {
  Points points(3, 2);
  points << 0, 1e7, 0, 1e7, 0, 1e7;
  try {
    voxel_grid(points, 1e-13);
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).rfind("voxel_size:", 0), 0u) << error.what();
  }
  EXPECT_THROW(voxel_grid(points, 1e-300), std::invalid_argument);
  EXPECT_THROW(voxel_grid(Points{{-1e308, 1e308}, {0, 0}, {0, 0}}, 1), std::invalid_argument);
  EXPECT_NO_THROW(voxel_grid(points, 10));
}

TEST(VoxelGrid, OfACloudWithAFarStrayPointIsThatOfTheRestAndThePoint) {
  Points points(3, 501);
  points.leftCols(500) = random_points(500, 6);
  points.col(500).setConstant(1e12);
  const Points means = voxel_grid(points, 0.1);
  EXPECT_EQ(means.cols(), voxel_grid(points.leftCols(500), 0.1).cols() + 1);
}

RC_GTEST_PROP(VoxelGrid, IsPermutedInputGivesTheSameMeans, ()) {
  const auto seed = *rc::gen::inRange(0u, 1000u);
  const Points points = random_points(400, seed);
  const Points reversed = points.rowwise().reverse();
  const Points a = voxel_grid(points, 0.3);
  const Points b = voxel_grid(reversed, 0.3);
  RC_ASSERT(a.cols() == b.cols());
  RC_ASSERT((a - b).cwiseAbs().maxCoeff() < 1e-14);
}

}  // namespace
}  // namespace gmcr::frontend
