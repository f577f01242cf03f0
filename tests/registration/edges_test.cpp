#include <gtest/gtest.h>

#include <cmath>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using testing::random_problem;

std::vector<Options> all_modes(double noise_bound) {
  std::vector<Options> modes;
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    for (const ScaleMode scale_mode : {ScaleMode::Known, ScaleMode::Estimated}) {
      for (const Evidence evidence : {Evidence::Distinct, Evidence::Count}) {
        Options options;
        options.noise_bound = noise_bound;
        options.method = method;
        options.scale_mode = scale_mode;
        options.evidence = evidence;
        modes.push_back(options);
      }
    }
  }
  return modes;
}

TEST(EdgeCases, FewerThanThreeCorrespondencesAreTooFew) {
  for (const Index count : {0, 1, 2}) {
    for (const Options& options : all_modes(0.1)) {
      const Result result =
          register_correspondences(Points::Random(3, count), Points::Random(3, count), options);
      EXPECT_EQ(result.status, Status::TooFewCorrespondences);
      EXPECT_FALSE(result.status_reason.empty());
      EXPECT_TRUE(result.inliers.empty());
      EXPECT_EQ(result.certificate.upper, count);
      EXPECT_EQ(result.target_from_source.matrix(), Eigen::Matrix4d::Identity());
    }
  }
}

TEST(EdgeCases, ThreeExactCorrespondencesAreEnough) {
  const auto problem = random_problem(1, 3, 0);
  for (const Options& options : all_modes(0.011)) {
    const Result result = register_correspondences(problem.source, problem.target, options);
    EXPECT_EQ(result.status, Status::Ok) << result.status_reason;
    EXPECT_EQ(result.inliers.size(), 3u);
    EXPECT_TRUE(result.certificate.certified);
  }
}

TEST(EdgeCases, CorrespondencesWithoutAnyAgreementHaveNoConsensus) {
  Points source(3, 3), target(3, 3);
  source << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  target << 0, 50, 0, 0, 0, 70, 0, 0, 0;
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    Options options;
    options.noise_bound = 0.01;
    options.method = method;
    const Result result = register_correspondences(source, target, options);
    EXPECT_EQ(result.status, Status::NoConsensus);
    EXPECT_TRUE(result.inliers.empty());
    EXPECT_FALSE(result.status_reason.empty());
  }
}

TEST(EdgeCases, CollinearInliersAreDegenerate) {
  testing::RandomGeometry random(2);
  const Similarity truth = random.similarity(1, 1, 1);
  Points source(3, 20);
  for (Index i = 0; i < 20; ++i) source.col(i) = random.uniform(-1, 1) * Eigen::Vector3d(1, 2, 3);
  Points target = truth.apply(source);
  for (const bool noisy : {false, true}) {
    if (noisy) {
      for (Index i = 0; i < 20; ++i) target.col(i) += random.in_ball(0.002);
    }
    for (const Options& options : all_modes(0.01)) {
      if (options.method == Method::Paper) continue;
      const Result result = register_correspondences(source, target, options);
      EXPECT_EQ(result.status, Status::Degenerate);
      EXPECT_NE(result.status_reason.find("collinear"), std::string::npos);
      EXPECT_EQ(result.inliers.size(), 20u);
      EXPECT_TRUE(result.target_from_source.matrix().allFinite());
    }
  }
}

TEST(EdgeCases, CoincidentPointsAreDegenerate) {
  const Points source = Points::Constant(3, 30, 4), target = Points::Constant(3, 30, -2);
  for (const Options& options : all_modes(0.01)) {
    const Result result = register_correspondences(source, target, options);
    EXPECT_NE(result.status, Status::Ok);
    EXPECT_TRUE(result.target_from_source.matrix().allFinite());
    EXPECT_TRUE(options.method == Method::Paper || result.status == Status::Degenerate);
  }
}

TEST(EdgeCases, CoplanarInliersAreNotDegenerate) {
  auto problem = random_problem(3, 30, 0);
  problem.source.row(2).setZero();
  problem.target = problem.truth.apply(problem.source);
  for (const Options& options : all_modes(0.01)) {
    const Result result = register_correspondences(problem.source, problem.target, options);
    EXPECT_EQ(result.status, Status::Ok);
    EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source), 0.01);
    EXPECT_NEAR(result.target_from_source.rotation.determinant(), 1, 1e-9);
  }
}

TEST(EdgeCases, AMirroredCloudIsNotTakenForTheCloud) {
  // all distances agree, so the whole is one clique; no proper rotation fits more than a part
  testing::RandomGeometry random(4);
  const Points source = random.in_cube(40);
  Points target = source;
  target.row(0) *= -1;
  Options options;
  options.noise_bound = 0.02;
  const Result result = register_correspondences(source, target, options);
  EXPECT_LT(result.inliers.size(), 30u);
  EXPECT_NEAR(result.target_from_source.rotation.determinant(), 1, 1e-9);
  EXPECT_GE(result.certificate.upper, 39);
  EXPECT_FALSE(result.certificate.certified);
}

TEST(EdgeCases, FarFromTheOriginNothingIsLost) {
  for (const bool unknown_scale : {false, true}) {
    auto problem = random_problem(5, 40, 60);
    const Eigen::Vector3d source_offset(1e6, -2e6, 3e6), target_offset(-4e6, 1e6, 2e6);
    problem.source.colwise() += source_offset;
    problem.target.colwise() += target_offset;
    Similarity truth = problem.truth;
    truth.translation += target_offset - truth.rotation * source_offset;
    const Result result = register_correspondences(
        problem.source, problem.target,
        unknown_scale ? problem.options_with_unknown_scale() : problem.options());
    EXPECT_EQ(result.status, Status::Ok);
    EXPECT_GE(result.certificate.lower, 39);
    EXPECT_LT(mean_point_error(result.target_from_source, truth, problem.source), 0.01);
  }
}

TEST(EdgeCases, MillimetresAndKilometresGiveTheSameInliers) {
  const auto problem = random_problem(6, 30, 100);
  const Result metres = register_correspondences(problem.source, problem.target, problem.options());
  for (const double unit : {1e-3, 1e3}) {
    Options options = problem.options();
    options.noise_bound *= unit;
    const Result other =
        register_correspondences(unit * problem.source, unit * problem.target, options);
    EXPECT_EQ(other.inliers, metres.inliers);
    EXPECT_EQ(other.certificate.upper, metres.certificate.upper);
  }
}

TEST(EdgeCases, ABoundThatHoldsEverythingIsCertifiedAndDegenerate) {
  const auto problem = random_problem(7, 10, 10);
  Options options;
  options.noise_bound = 1000;
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(result.status, Status::Degenerate);
  EXPECT_EQ(result.inliers.size(), 20u);
  EXPECT_TRUE(result.certificate.certified);
}

}  // namespace
}  // namespace gmcr::registration
