#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <stdexcept>

#include "frontend/alignment/refine_pose.hpp"
#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::some_motion;

const auto kNever = parallel::Deadline::never();

/// The pose after a turn of `degrees` about a point and a shift of it.
Similarity nudged(const Similarity& pose, const Eigen::Vector3d& point, double degrees,
                  const Eigen::Vector3d& shift, double growth = 1) {
  Similarity nudge;
  nudge.rotation =
      Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d(2, 1, -1).normalized()).matrix();
  nudge.scale = growth;
  nudge.translation = point + shift - growth * (nudge.rotation * point);
  return nudge * pose;
}

Points with_noise(Points points, double sigma, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0, sigma);
  for (double& value : points.reshaped()) value += normal(generator);
  return points;
}

RefinedPose refined(const PointsRef& source, const PointsRef& target, const Similarity& start,
                    const RefinementScale& scale, const Options& options,
                    const parallel::Deadline& deadline) {
  CentredPair pair(source, target, scale.cell, scale.cell, 1);
  return refine_pose(pair, start, scale, options, deadline);
}

/// A pose of two bumpy spheres and a start near it.
struct Case {
  Points source = voxel_grid(bumpy_sphere(20000, 1), 0.05);
  Similarity truth = some_motion();
  Points target = voxel_grid(truth.apply(bumpy_sphere(20000, 2)), 0.05);
  Similarity start = nudged(truth, truth.translation, 3, {0.03, -0.05, 0.04});
  RefinementScale scale{0.05, 3, 2500, 1e-3};

  double error(const Similarity& pose) const { return mean_point_error(pose, truth, source); }
};

TEST(RefinePose, BringsASurfaceFarBelowAVoxelOfItsPlace) {
  const Case a;
  ASSERT_GT(a.error(a.start), 0.05);
  const RefinedPose result = refined(a.source, a.target, a.start, a.scale, {}, kNever);
  EXPECT_TRUE(result.is_applied);
  EXPECT_LT(a.error(result.target_from_source), 0.02 * a.scale.cell);
  EXPECT_EQ(result.target_from_source.scale, 1);
}

TEST(RefinePose, OfCopiesIsExactToRounding) {
  const Case a;
  const Points copy = a.truth.apply(a.source);
  const RefinedPose result = refined(a.source, copy, a.start, a.scale, {}, kNever);
  EXPECT_LT(a.error(result.target_from_source), 1e-9);
  const RefinedPose again = refined(a.source, copy, a.truth, a.scale, {}, kNever);
  EXPECT_LT(a.error(again.target_from_source), 1e-12);
}

TEST(RefinePose, HasNoEyesForPointsThatAreNowhereOnTheOther) {
  const Case a;
  Points half(3, a.target.cols());
  Index count = 0;
  for (Index i = 0; i < a.target.cols(); ++i) {
    if (a.target(0, i) < a.truth.translation.x() + 0.2) half.col(count++) = a.target.col(i);
  }
  half.conservativeResize(Eigen::NoChange, count);
  const RefinedPose result = refined(a.source, half, a.start, a.scale, {}, kNever);
  EXPECT_LT(a.error(result.target_from_source), 0.04 * a.scale.cell);
}

TEST(RefinePose, SaysHowNoisyTheSurfacesAre) {
  const Case a;
  double last = 0;
  for (const double sigma : {0.002, 0.004, 0.008}) {
    const Points noisy = with_noise(a.target, sigma, 3);
    const RefinedPose result = refined(a.source, noisy, a.start, a.scale, {}, kNever);
    EXPECT_LT(a.error(result.target_from_source), sigma);
    EXPECT_GT(result.noise, 0.5 * sigma);
    EXPECT_LT(result.noise, 3 * sigma + 0.002);
    EXPECT_GT(result.noise, last);
    last = result.noise;
  }
}

TEST(RefinePose, FindsTheScaleOnlyWhereItIsEstimated) {
  const Case a;
  const Similarity start = nudged(a.truth, a.truth.translation, 1, {0.01, 0.02, 0}, 1.02);
  Options options;
  const RefinedPose kept = refined(a.source, a.target, start, a.scale, options, kNever);
  EXPECT_EQ(kept.target_from_source.scale, start.scale);
  options.scale_mode = ScaleMode::Estimated;
  const RefinedPose result = refined(a.source, a.target, start, a.scale, options, kNever);
  EXPECT_LT(scale_error(result.target_from_source.scale, 1), 1e-3);
  options.scale_range = ScaleRange{1.01, 1.1};
  const RefinedPose bounded = refined(a.source, a.target, start, a.scale, options, kNever);
  EXPECT_GE(bounded.target_from_source.scale, 1.01);
}

TEST(RefinePose, KeepsWhatThePriorsAdmit) {
  const Case a;
  Options options;
  options.initial_pose = InitialPose{a.start, 0.01, 0.02};
  const RefinedPose result = refined(a.source, a.target, a.start, a.scale, options, kNever);
  EXPECT_TRUE(options.admit(result.target_from_source));
  EXPECT_LT(a.error(result.target_from_source), a.error(a.start));
}

TEST(RefinePose, IsTheSameAnywhereOnEarth) {
  const Case a;
  const RefinedPose here = refined(a.source, a.target, a.start, a.scale, {}, kNever);
  for (const double offset : {1e3, 1e5, 1e7}) {
    const Eigen::Vector3d from(offset, -2 * offset, 0.1 * offset), to(-offset, offset, 0);
    const auto moved = [&](Similarity pose) {
      pose.translation += to - pose.rotation * from;
      return pose;
    };
    const RefinedPose there = refined(a.source.colwise() + from, a.target.colwise() + to,
                                      moved(a.start), a.scale, {}, kNever);
    const Points images = there.target_from_source.apply(a.source.colwise() + from).colwise() - to;
    EXPECT_LT((images - here.target_from_source.apply(a.source)).colwise().norm().maxCoeff(),
              1e-5 * a.scale.cell + 1e-14 * offset)
        << offset;
  }
}

TEST(RefinePose, DoesNotDependOnTheNumberOfThreads) {
  const Case a;
  Options options;
  options.scale_mode = ScaleMode::Estimated;
  options.num_threads = 1;
  const RefinedPose one = refined(a.source, a.target, a.start, a.scale, options, kNever);
  for (const int threads : {2, 3}) {
    options.num_threads = threads;
    const RefinedPose more = refined(a.source, a.target, a.start, a.scale, options, kNever);
    EXPECT_EQ(more.target_from_source.matrix(), one.target_from_source.matrix());
    EXPECT_EQ(more.noise, one.noise);
  }
}

TEST(RefinePose, LeavesAPoseOfCloudsThatHardlyMeet) {
  const Case a;
  const Similarity away = nudged(a.truth, a.truth.translation, 0, {50, 0, 0});
  const RefinedPose result = refined(a.source, a.target, away, a.scale, {}, kNever);
  EXPECT_FALSE(result.is_applied);
  EXPECT_EQ(result.target_from_source.matrix(), away.matrix());
}

TEST(RefinePose, OfAPlaneStaysWhereItLiesAlongThePlane) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto plane = [&] {
    Points points = Points::NullaryExpr(3, 3000, [&] { return coordinate(generator); });
    points.row(2).setZero();
    return points;
  };
  Similarity start;
  start.translation = {0, 0, 0.04};
  const RefinedPose result = refined(plane(), plane(), start, {0.05, 3, 2500, 1e-3}, {}, kNever);
  EXPECT_NEAR(result.target_from_source.translation.z(), 0, 1e-6);
  EXPECT_LT(result.target_from_source.translation.head<2>().norm(), 0.02);
}

TEST(RegisterClouds, RefinesUnlessToldNotTo) {
  const Points source = bumpy_sphere(8000, 1);
  const Similarity truth = some_motion();
  const Points target = truth.apply(bumpy_sphere(8000, 2));
  FrontendOptions frontend;
  const CloudResult refined = register_clouds(source, target, frontend);
  frontend.refine = Refine::None;
  const CloudResult plain = register_clouds(source, target, frontend);
  EXPECT_TRUE(refined.refinement.is_applied);
  EXPECT_EQ(refined.refinement.method, "icp");
  EXPECT_GT(refined.refinement.noise, 0);
  EXPECT_FALSE(plain.refinement.is_applied);
  EXPECT_EQ(plain.refinement.method, "none");
  const auto error = [&](const CloudResult& result) {
    return mean_point_error(result.registration.target_from_source, truth, source);
  };
  EXPECT_LT(error(refined), 0.25 * error(plain));
  // what is said of the pose is said of the refined one
  const CloudResult same = with_pose(refined, refined.registration.target_from_source, {});
  EXPECT_EQ(same.registration.inliers, refined.registration.inliers);
  EXPECT_EQ(same.fitness, refined.fitness);

  const CloudResult later = refine_clouds(plain, source, target);
  EXPECT_LT(error(later), 0.25 * error(plain));
}

TEST(RegisterClouds, SaysThatTheTimeEndedTheRefinement) {
  Options options;
  options.time_limit = 1e-9;
  const CloudResult result = register_clouds(
      bumpy_sphere(3000, 1), some_motion().apply(bumpy_sphere(3000, 2)), {}, options);
  EXPECT_FALSE(result.refinement.is_applied);
}

TEST(RefineClouds, OfAResultWithoutAPoseIsThatResult) {
  const Points points = bumpy_sphere(500, 1);
  const CloudResult none = register_clouds(Points(3, 0), points);
  const CloudResult same = refine_clouds(none, Points(3, 0), points);
  EXPECT_EQ(same.registration.status, none.registration.status);
  EXPECT_FALSE(same.refinement.is_applied);
  EXPECT_EQ(same.refinement.note, "no pose to refine");
}

TEST(RefineClouds, ChecksItsClouds) {
  Points bad = bumpy_sphere(100, 1);
  bad(1, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(refine_clouds({}, bad, bumpy_sphere(100, 1)), std::invalid_argument);
}

}  // namespace
}  // namespace gmcr::frontend
