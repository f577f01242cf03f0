#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "frontend/judgement/hypotheses.hpp"
#include "frontend/judgement/view_search.hpp"
#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::frontend {
namespace {

using Eigen::Vector3d;
using testing::bumpy_sphere;
using testing::random_points;
using testing::some_motion;

/// The half of the moved shape that a sensor at the origin sees, along z.
struct SeenObject {
  explicit SeenObject(const Points& shape) {
    motion = some_motion();
    motion.translation = {0, 0, 8};
    const Points moved = motion.apply(shape);
    std::vector<Index> front;
    for (Index i = 0; i < moved.cols(); ++i) {
      if (moved(2, i) < 8) front.push_back(i);
    }
    view = moved(Eigen::all, front);
  }
  Similarity motion;
  Points view;
};

/// Smallest mean point error of the poses.
double least_error(const std::vector<Similarity>& poses, const Similarity& truth,
                   const Points& points) {
  double least = 1e9;
  for (const Similarity& pose : poses) {
    least = std::min(least, mean_point_error(pose, truth, points));
  }
  return least;
}

TEST(ViewSearch, FindsThePoseOfAnObjectThatAViewShows) {
  const Points object = voxel_grid(bumpy_sphere(6000, 1), 0.06);
  const SeenObject seen(voxel_grid(bumpy_sphere(12000, 2), 0.06));
  const ObjectAndView clouds{object, seen.view, 0.06, Vector3d::Zero()};
  ASSERT_TRUE(may_show(clouds, 1));
  const parallel::Deadline never = parallel::Deadline::never();
  Options options;
  options.num_threads = 1;
  const auto poses = poses_by_views(clouds, options, never);
  ASSERT_FALSE(poses.empty());
  EXPECT_LE(poses.size(), 6u);
  EXPECT_LT(least_error(poses, seen.motion, object), 0.1);
  options.num_threads = 3;
  const auto same = poses_by_views(clouds, options, never);
  ASSERT_EQ(same.size(), poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    EXPECT_EQ(same[k].matrix(), poses[k].matrix());
  }
}

TEST(ViewSearch, KeepsToThePriors) {
  const Points object = voxel_grid(bumpy_sphere(6000, 1), 0.06);
  const SeenObject seen(voxel_grid(bumpy_sphere(12000, 2), 0.06));
  Options options;
  options.initial_pose = InitialPose{seen.motion, 0.6, 1};
  const auto poses = poses_by_views({object, seen.view, 0.06, Vector3d::Zero()}, options,
                                    parallel::Deadline::never());
  for (const Similarity& pose : poses) {
    EXPECT_LT(rotation_error_deg(pose.rotation, seen.motion.rotation), 35);
  }
}

TEST(ViewSearch, IsForViewsAsLargeAsTheObjectFromOutside) {
  const Points object = voxel_grid(bumpy_sphere(6000, 1), 0.06);
  const Points scene = 2 * object;
  const Vector3d outside(0, 0, 8);
  EXPECT_FALSE(may_show({object, scene, 0.06, outside}, 1));
  EXPECT_TRUE(may_show({object, scene, 0.06, outside}, 2));
  EXPECT_FALSE(may_show({object, scene, 0.06, Vector3d::Zero()}, 2));
  const Points dense = voxel_grid(bumpy_sphere(30000, 1), 0.02);
  EXPECT_FALSE(may_show({dense, dense, 0.02, outside}, 1));
}

/// A smooth ellipsoid: its features tell nothing, and it turns into itself by half.
Points ellipsoid(Index count, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Points points(3, count);
  for (Index i = 0; i < count; ++i) {
    const Vector3d d = Vector3d::NullaryExpr([&] { return normal(generator); }).normalized();
    points.col(i) = Vector3d(1, 0.7, 0.45).cwiseProduct(d);
  }
  return points;
}

TEST(RegisterClouds, NamesTheSymmetryOfAnObject) {
  const Points object = ellipsoid(3000, 1);
  const SeenObject seen(ellipsoid(10000, 2));
  const CloudResult result = register_clouds(object, seen.view);
  ASSERT_EQ(result.registration.status, Status::Ok);
  EXPECT_EQ(result.verdict, Verdict::Doubtful) << result.verdict_reason;
  ASSERT_FALSE(result.rivals.empty());
  EXPECT_TRUE(result.rivals.front().is_symmetry);
  EXPECT_NE(result.verdict_reason.find("a symmetry of the source"), std::string::npos)
      << result.verdict_reason;
  // the axes lie where they are, whichever way they point
  const Eigen::Matrix3d off =
      result.registration.target_from_source.rotation.transpose() * seen.motion.rotation;
  for (int k = 0; k < 3; ++k) EXPECT_GT(std::abs(off(k, k)), std::cos(0.1));
}

TEST(SurfaceJudge, KnowsASymmetryFromAnotherPose) {
  const Points points = voxel_grid(ellipsoid(8000, 1), 0.06);
  const auto pair = std::make_shared<CentredPair>(points, points, 0.06, 0.06, 2);
  const Options options;
  SurfaceJudge judge(pair, 0.06, options);
  const Similarity here = some_motion();
  for (const double angle : {std::numbers::pi, 0.5 * std::numbers::pi}) {
    Similarity turn;
    turn.rotation = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    EXPECT_EQ(judge.is_symmetry(here, here * turn), angle > 3);
  }
}

TEST(RegisterClouds, JudgesEveryAttemptOnTheVoxelsOfTheFirst) {
  const Points source = bumpy_sphere(3000, 1), target = 2 * random_points(3000, 2);
  const CloudMatches first = match_clouds(source, target);
  const CloudResult result = register_clouds(source, target);
  EXPECT_GT(result.num_attempts, 1);
  EXPECT_EQ(result.voxels.source, first.source_voxels);
  EXPECT_EQ(result.voxels.target, first.target_voxels);
  EXPECT_EQ(result.voxels.target_voxel_size, first.target_voxel_size);
}

}  // namespace
}  // namespace gmcr::frontend
