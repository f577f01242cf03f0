#include "frontend/features/fpfh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "frontend/features/normals.hpp"
#include "frontend/mirrored.hpp"
#include "frontend/shapes.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::some_motion;

constexpr double kNormalRadius = 0.3;
constexpr double kFeatureRadius = 0.6;

struct Described {
  Points normals;
  Features features;
};

Described describe_cloud(const Points& points, const Eigen::Vector3d& viewpoint, double unit = 1,
                         int num_threads = 0) {
  const Neighbourhoods near = find_neighbourhoods(points, kFeatureRadius * unit, num_threads);
  Described described;
  described.normals = orient_toward(
      points, estimate_normals(points, near, kNormalRadius * unit, num_threads), viewpoint);
  described.features = compute_fpfh(points, described.normals, near, num_threads);
  return described;
}

/// Share of features that agree to 1 % of a histogram's sum; rounding of the normals moves a few
/// pairs across the edge of a bin.
double share_equal(const Features& a, const Features& b) {
  const auto differences = (a - b).colwise().lpNorm<Eigen::Infinity>().array();
  return static_cast<double>((differences < 2).count()) / static_cast<double>(a.cols());
}

TEST(Fpfh, OfAMirroredCloudIsThatOfTheCloudWithOneAngleReversed) {
  Points points = bumpy_sphere(1500, 2);
  Eigen::Vector3d viewpoint(1, 2, 9);
  const Features expected = mirrored_features(describe_cloud(points, viewpoint).features);
  points.row(0) *= -1;
  viewpoint.x() *= -1;
  EXPECT_GT(share_equal(describe_cloud(points, viewpoint).features, expected), 0.98);
}

TEST(Fpfh, SumsTo200InEachAngle) {
  const Features features = describe_cloud(bumpy_sphere(1500, 1), {0, 0, 9}).features;
  for (const auto& feature : features.colwise()) {
    for (int angle = 0; angle < 3; ++angle) {
      EXPECT_NEAR(feature.segment<11>(11 * angle).sum(), 200, 1e-2);
    }
  }
}

TEST(Fpfh, IsUnchangedByARigidMotionOfCloudAndViewpoint) {
  const Points points = bumpy_sphere(1500, 2);
  const Eigen::Vector3d viewpoint(1, 2, 9);
  const Similarity motion = some_motion();
  const Features before = describe_cloud(points, viewpoint).features;
  const Features after = describe_cloud(motion.apply(points), motion * viewpoint).features;
  EXPECT_GT(share_equal(before, after), 0.98);
}

TEST(Fpfh, IsUnchangedByTheUnit) {
  const Points points = bumpy_sphere(1500, 3);
  const Features metres = describe_cloud(points, {0, 0, 9}).features;
  const Features millimetres = describe_cloud(1000 * points, {0, 0, 9000}, 1000).features;
  EXPECT_GT(share_equal(metres, millimetres), 0.98);
}

TEST(Fpfh, FollowsAPermutationOfThePoints) {
  const Points points = bumpy_sphere(1000, 4);
  std::vector<Index> order(1000);
  std::iota(order.begin(), order.end(), Index{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  const Features direct = describe_cloud(points, {0, 0, 9}).features;
  const Features permuted = describe_cloud(points(Eigen::all, order), {0, 0, 9}).features;
  EXPECT_GT(share_equal(direct(Eigen::all, order), permuted), 0.98);
}

TEST(Fpfh, SeesTheSideOfTheNormals) {
  const Points points = bumpy_sphere(1500, 6);
  const Neighbourhoods near = find_neighbourhoods(points, kFeatureRadius, 0);
  const Points normals = orient_outward(points, estimate_normals(points, near, kNormalRadius, 0));
  const Features outward = compute_fpfh(points, normals, near, 0);
  const Features inward = compute_fpfh(points, -normals, near, 0);
  EXPECT_LT(share_equal(outward, inward), 0.01);
  // turning all normals mirrors the histograms of theta and phi and keeps that of alpha
  Features mirrored = inward;
  mirrored.topRows<11>() = inward.topRows<11>().colwise().reverse().eval();
  mirrored.bottomRows<11>() = inward.bottomRows<11>().colwise().reverse().eval();
  EXPECT_GT(share_equal(outward, mirrored), 0.98);
}

TEST(Fpfh, OfPointsWithoutNormalOrNeighboursIsZero) {
  Points points(3, 4);
  points << 0, 0.1, 0, 9, 0, 0, 0.1, 9, 0, 0, 0, 9;
  Points normals = Eigen::Vector3d(0, 0, 1).replicate(1, 4);
  normals.col(1).setZero();
  const Features features = compute_fpfh(points, normals, find_neighbourhoods(points, 1, 1), 1);
  EXPECT_FALSE(features.col(0).isZero(0));
  EXPECT_TRUE(features.col(1).isZero(0));
  EXPECT_FALSE(features.col(2).isZero(0));
  EXPECT_TRUE(features.col(3).isZero(0));
}

TEST(Fpfh, OfDuplicatesIsFinite) {
  const Points points = Points::Constant(3, 10, 0.5);
  const Points normals = Eigen::Vector3d(0, 0, 1).replicate(1, 10);
  EXPECT_TRUE(compute_fpfh(points, normals, find_neighbourhoods(points, 1, 1), 1).allFinite());
}

TEST(Fpfh, DoesNotDependOnTheNumberOfThreads) {
  const Points points = bumpy_sphere(2000, 7);
  const Features one = describe_cloud(points, {0, 0, 9}, 1, 1).features;
  EXPECT_EQ(describe_cloud(points, {0, 0, 9}, 1, 3).features, one);
}

}  // namespace
}  // namespace gmcr::frontend
