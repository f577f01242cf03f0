#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::random_points;
using testing::some_motion;

TEST(RegisterClouds, RecoversAKnownMotion) {
  const Points source = bumpy_sphere(6000, 1);
  const Similarity motion = some_motion();
  const CloudResult result = register_clouds(source, motion.apply(bumpy_sphere(6000, 2)));
  ASSERT_EQ(result.registration.status, Status::Ok);
  EXPECT_LT(rotation_error_deg(result.registration.target_from_source.rotation, motion.rotation),
            3);
  EXPECT_LT(mean_point_error(result.registration.target_from_source, motion, source), 0.05);
  EXPECT_EQ(result.verdict, Verdict::Trusted);
  EXPECT_GT(result.fitness, 0.6);
  EXPECT_GT(result.overlap_rmse, 0);
  EXPECT_LT(result.overlap_rmse, result.matches.target_voxel_size);
  EXPECT_EQ(result.num_source_points, 6000);
  EXPECT_EQ(result.num_target_points, 6000);
}

TEST(RegisterClouds, RecoversAnUnknownScale) {
  const Points source = bumpy_sphere(2500, 1);
  for (const double scale : {0.1, 10.0}) {
    const Similarity motion = some_motion(scale);
    Options options;
    options.scale_mode = ScaleMode::Estimated;
    FrontendOptions frontend;
    frontend.orientation = NormalOrientation::Outward;
    frontend.max_attempts = 1;
    const CloudResult result =
        register_clouds(source, motion.apply(bumpy_sphere(2500, 2)), frontend, options);
    ASSERT_EQ(result.registration.status, Status::Ok);
    EXPECT_LT(scale_error(result.registration.target_from_source.scale, scale), 0.05);
    EXPECT_LT(mean_point_error(result.registration.target_from_source, motion, source),
              0.12 * scale);
  }
}

TEST(RegisterClouds, TellsWhichStageIsAtWork) {
  const Points source = bumpy_sphere(3000, 1), target = some_motion().apply(bumpy_sphere(3000, 2));
  std::vector<std::string> stages;
  Options options;
  options.progress = [&](const Progress& progress) {
    if (stages.empty() || stages.back() != progress.stage) stages.push_back(progress.stage);
    return true;
  };
  const CloudResult whole = register_clouds(source, target, {}, options);
  EXPECT_EQ(stages.front(), "matching");
  EXPECT_EQ(stages.back(), "refinement");
  EXPECT_NE(std::find(stages.begin(), stages.end(), "comparison"), stages.end());

  options.progress = [](const Progress& progress) {
    return progress.stage != std::string("refinement");
  };
  const CloudResult stopped = register_clouds(source, target, {}, options);
  const auto& hits = stopped.registration.diagnostics.limits_hit;
  ASSERT_FALSE(hits.empty());
  EXPECT_EQ(hits.back().limit, Limit::Stopped);
  EXPECT_EQ(stopped.registration.inliers.empty(), whole.registration.inliers.empty());
}

TEST(RegisterClouds, InliersAreWithinTheBoundTheResultNames) {
  const Points source = bumpy_sphere(5000, 1);
  const CloudResult result = register_clouds(source, some_motion().apply(bumpy_sphere(5000, 2)));
  const auto& matches = result.matches;
  const Points moved = result.registration.target_from_source.apply(matches.source);
  std::vector<Index> within;
  for (Index i = 0; i < moved.cols(); ++i) {
    if ((moved.col(i) - matches.target.col(i)).norm() <= matches.noise_bound) within.push_back(i);
  }
  EXPECT_EQ(result.registration.inliers, within);
}

TEST(WithPose, OfItsOwnPoseChangesNothing) {
  const Points source = bumpy_sphere(5000, 1);
  const CloudResult result = register_clouds(source, some_motion().apply(bumpy_sphere(5000, 2)));
  const CloudResult same = with_pose(result, result.registration.target_from_source, {});
  EXPECT_EQ(same.registration.inliers, result.registration.inliers);
  EXPECT_DOUBLE_EQ(same.registration.evidence, result.registration.evidence);
  EXPECT_EQ(same.registration.certificate.upper, result.registration.certificate.upper);
  EXPECT_EQ(same.fitness, result.fitness);
  EXPECT_EQ(same.verdict_reason, result.verdict_reason);
  ASSERT_TRUE(same.registration.covariance && result.registration.covariance);
  EXPECT_EQ(same.registration.covariance->matrix, result.registration.covariance->matrix);
}

TEST(WithPose, HasTheUncertaintyOfTheNewPose) {
  Options options;
  options.scale_mode = ScaleMode::Estimated;
  const CloudResult result = register_clouds(
      bumpy_sphere(5000, 1), some_motion().apply(bumpy_sphere(5000, 2)), {}, options);
  ASSERT_TRUE(result.registration.covariance);
  Similarity next = result.registration.target_from_source;
  next.translation += Eigen::Vector3d(0.2 * result.matches.noise_bound, 0, 0);
  const CloudResult moved = with_pose(result, next, options);
  ASSERT_TRUE(moved.registration.covariance);
  EXPECT_NE(moved.registration.covariance->matrix, result.registration.covariance->matrix);
  EXPECT_LE(moved.registration.consistent_scales.min, next.scale);
  EXPECT_GE(moved.registration.consistent_scales.max, next.scale);
}

TEST(WithPose, OfAWrongPoseIsNotTrusted) {
  const Points source = bumpy_sphere(5000, 1);
  const CloudResult result = register_clouds(source, some_motion().apply(bumpy_sphere(5000, 2)));
  Similarity away = result.registration.target_from_source;
  away.translation += Eigen::Vector3d(100, 0, 0);
  const CloudResult wrong = with_pose(result, away, {});
  EXPECT_EQ(wrong.verdict, Verdict::Untrusted);
  EXPECT_TRUE(wrong.registration.inliers.empty());
  // which speaks of the matches
  EXPECT_EQ(wrong.registration.certificate.lower, result.registration.certificate.lower);
  EXPECT_EQ(wrong.fitness, 0);
}

TEST(RegisterClouds, ChoosesTheNoiseBoundFromTheMatches) {
  Options options;
  options.noise_mode = NoiseMode::Estimated;
  const Points source = bumpy_sphere(5000, 1);
  const Similarity truth = some_motion();
  const CloudResult result =
      register_clouds(source, truth.apply(bumpy_sphere(5000, 2)), {}, options);
  EXPECT_EQ(result.registration.status, Status::Ok);
  ASSERT_TRUE(result.registration.noise_estimate);
  EXPECT_EQ(result.matches.noise_bound, result.registration.noise_estimate->noise_bound);
  EXPECT_LT(result.matches.noise_bound, 4 * result.matches.target_voxel_size);
  EXPECT_LT(mean_point_error(result.registration.target_from_source, truth, source),
            2 * result.matches.noise_bound);
  const CloudResult same = with_pose(result, result.registration.target_from_source, options);
  EXPECT_EQ(same.registration.inliers, result.registration.inliers);
}

TEST(RegisterClouds, StopsTheAttemptsWhenTheTimeIsUp) {
  Options options;
  options.time_limit = 1e-9;
  const CloudResult result =
      register_clouds(bumpy_sphere(3000, 1), 2 * random_points(3000, 2), {}, options);
  EXPECT_EQ(result.num_attempts, 1);
  EXPECT_FALSE(result.registration.diagnostics.limits_hit.empty());
}

TEST(RegisterClouds, OfUnrelatedCloudsIsNotTrusted) {
  const CloudResult result = register_clouds(bumpy_sphere(3000, 1), 2 * random_points(3000, 2));
  EXPECT_NE(result.verdict, Verdict::Trusted);
  EXPECT_FALSE(result.verdict_reason.empty());
  EXPECT_GT(result.num_attempts, 1);
}

TEST(RegisterClouds, OfCloudsWithoutASurfaceHasNoPose) {
  const Points whole = bumpy_sphere(500, 1);
  for (const Points& cloud :
       {Points(3, 0), Points(random_points(2, 1)), Points(Points::Constant(3, 100, 4.0))}) {
    const CloudResult result = register_clouds(cloud, whole);
    EXPECT_EQ(result.registration.status, Status::TooFewCorrespondences);
    EXPECT_EQ(result.verdict, Verdict::Untrusted);
    EXPECT_EQ(result.fitness, 0);
    EXPECT_NE(result.verdict_reason.find("no pose"), std::string::npos);
  }
}

TEST(RegisterClouds, TurnsTheNormalsOfAModelOutwardWhereItsViewIsSeenFromTheOrigin) {
  const Points model = bumpy_sphere(6000, 1);
  Similarity motion = some_motion();
  motion.translation = {0, 0, 8};
  Points view = motion.apply(bumpy_sphere(12000, 2));
  std::vector<Index> visible;
  for (Index i = 0; i < view.cols(); ++i) {
    if (view(2, i) < 8) visible.push_back(i);
  }
  const CloudResult result = register_clouds(model, view(Eigen::all, visible));
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  EXPECT_EQ(result.num_attempts, 2);
  EXPECT_LT(mean_point_error(result.registration.target_from_source, motion, model), 0.1);
  EXPECT_GT(result.target_fitness, result.fitness);
}

TEST(RegisterClouds, HasTheVerdictOfTheFirstAttemptWithoutOthers) {
  FrontendOptions frontend;
  frontend.orientation = NormalOrientation::Outward;
  const Points source = bumpy_sphere(6000, 1);
  const CloudResult result =
      register_clouds(source, some_motion().apply(bumpy_sphere(6000, 2)), frontend);
  EXPECT_EQ(result.num_attempts, 1);
  EXPECT_EQ(result.verdict, Verdict::Trusted);
  EXPECT_NE(result.verdict_reason.find("matches agree"), std::string::npos);
}

TEST(RegisterClouds, StopsAtMaxAttempts) {
  FrontendOptions frontend;
  frontend.max_attempts = 1;
  EXPECT_EQ(
      register_clouds(bumpy_sphere(3000, 1), 2 * random_points(3000, 2), frontend).num_attempts, 1);
}

TEST(RegisterClouds, ReportsTheStagesOfBothParts) {
  const Points source = bumpy_sphere(3000, 1);
  const CloudResult result = register_clouds(source, bumpy_sphere(3000, 2));
  const auto& stages = result.registration.diagnostics.stages;
  ASSERT_GT(stages.size(), 4u);
  EXPECT_EQ(stages[0].name, "voxel");
  EXPECT_EQ(stages[3].name, "matching");
  EXPECT_GT(result.registration.diagnostics.total_seconds, 0);
}

TEST(RegisterClouds, DoesNotDependOnTheNumberOfThreads) {
  const Points source = bumpy_sphere(4000, 1);
  const Points target = some_motion().apply(bumpy_sphere(4000, 2));
  Options options;
  options.num_threads = 1;
  const CloudResult one = register_clouds(source, target, {}, options);
  options.num_threads = 3;
  const CloudResult three = register_clouds(source, target, {}, options);
  EXPECT_EQ(three.registration.target_from_source.matrix(),
            one.registration.target_from_source.matrix());
  EXPECT_EQ(three.registration.inliers, one.registration.inliers);
  EXPECT_EQ(three.fitness, one.fitness);
  EXPECT_EQ(three.overlap_rmse, one.overlap_rmse);
}

TEST(RegisterClouds, VerdictsHaveNames) {
  EXPECT_STREQ(to_string(Verdict::Trusted), "trusted");
  EXPECT_STREQ(to_string(Verdict::Doubtful), "doubtful");
  EXPECT_STREQ(to_string(Verdict::Untrusted), "untrusted");
}

}  // namespace
}  // namespace gmcr::frontend
