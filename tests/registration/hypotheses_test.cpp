#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using testing::Problem;
using testing::random_problem;

/// An object that a quarter turn about its z axis maps onto itself, and matches to all four copies:
/// more of the first than of the second and so on.
struct SymmetricObject {
  Problem problem;
  std::vector<Similarity> poses;  ///< by descending number of matches
  std::vector<Index> sizes;
};

SymmetricObject symmetric_object(std::uint64_t seed, Index num_outliers, double scale = 1) {
  testing::RandomGeometry random(seed);
  SymmetricObject object;
  object.sizes = {18, 14, 11, 8};
  object.problem.truth = random.similarity(scale, scale, 1);
  std::vector<Eigen::Vector3d> sources, targets;
  for (std::size_t k = 0; k < object.sizes.size(); ++k) {
    Similarity pose = object.problem.truth;
    pose.rotation *=
        Eigen::AngleAxisd(static_cast<double>(k) * std::numbers::pi / 2, Eigen::Vector3d::UnitZ())
            .matrix();
    object.poses.push_back(pose);
    for (Index m = 0; m < object.sizes[k]; ++m) {
      const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      const double radius = random.uniform(0.3, 0.6);
      sources.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                           random.uniform(-0.5, 0.5));
      targets.emplace_back(pose * sources.back() + random.in_ball(object.problem.noise_bound));
    }
  }
  for (Index m = 0; m < num_outliers; ++m) {
    sources.push_back(random.in_ball(0.7));
    targets.push_back(object.problem.truth.translation + random.in_ball(0.7 * scale));
  }
  const auto count = static_cast<Index>(sources.size());
  object.problem.source.resize(3, count);
  object.problem.target.resize(3, count);
  for (Index i = 0; i < count; ++i) {
    // mixed, so that no order of the input gives the answer away
    const Index place = i * 29 % count;
    object.problem.source.col(place) = sources[static_cast<std::size_t>(i)];
    object.problem.target.col(place) = targets[static_cast<std::size_t>(i)];
  }
  return object;
}

std::vector<Alternative> all_poses(const Result& result) {
  std::vector<Alternative> all{{result.target_from_source, result.inliers, result.evidence}};
  all.insert(all.end(), result.alternatives.begin(), result.alternatives.end());
  return all;
}

void expect_the_four_poses(const SymmetricObject& object, Options options) {
  options.num_hypotheses = 4;
  const Problem& problem = object.problem;
  const Result result = register_correspondences(problem.source, problem.target, options);
  ASSERT_EQ(result.status, Status::Ok) << result.status_reason;
  ASSERT_EQ(result.alternatives.size(), 3u);
  const std::vector<Alternative> found = all_poses(result);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(mean_point_error(found[k].target_from_source, object.poses[k], problem.source), 0.02)
        << k;
    EXPECT_GE(static_cast<Index>(found[k].inliers.size()), object.sizes[k] - 2);
    const Consensus consensus =
        evaluate_consensus(found[k].target_from_source, problem.source, problem.target, options);
    EXPECT_EQ(found[k].inliers, consensus.inliers);
    EXPECT_NEAR(found[k].evidence, consensus.evidence, 1e-9);
    for (std::size_t better = 0; better < k; ++better) {
      EXPECT_LE(found[k].evidence, found[better].evidence);
      std::vector<Index> shared;
      std::set_intersection(found[k].inliers.begin(), found[k].inliers.end(),
                            found[better].inliers.begin(), found[better].inliers.end(),
                            std::back_inserter(shared));
      EXPECT_LE(2 * shared.size(), found[k].inliers.size());
    }
  }
  EXPECT_DOUBLE_EQ(result.runner_up_ratio(), found[1].evidence / found[0].evidence);
  EXPECT_GT(result.runner_up_ratio(), 0.6);
}

TEST(Hypotheses, OfASymmetricObjectAreItsPosesByDescendingEvidence) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const SymmetricObject object = symmetric_object(seed, 26, 1.5);
    SCOPED_TRACE(seed);
    for (Options options :
         {object.problem.options(), object.problem.options_with_unknown_scale()}) {
      expect_the_four_poses(object, options);
      options.evidence = Evidence::Count;
      expect_the_four_poses(object, options);
      options.one_to_one = true;
      expect_the_four_poses(object, options);
    }
  }
}

TEST(Hypotheses, AreFoundWithABoundForEachCorrespondence) {
  SymmetricObject object = symmetric_object(7, 25);
  Options options = object.problem.options();
  options.noise_bound = 0;
  testing::RandomGeometry random(8);
  for (Index i = 0; i < object.problem.source.cols(); ++i) {
    options.noise_bounds.push_back(random.uniform(0.01, 0.02));
  }
  expect_the_four_poses(object, options);
}

TEST(Hypotheses, KeepToThePriors) {
  const SymmetricObject object = symmetric_object(9, 24);
  Options options = object.problem.options();
  const Similarity& truth = object.problem.truth;
  // all four turn the axis of symmetry the same way
  options.gravity = {Eigen::Vector3d::UnitZ(), truth.rotation.col(2), 0.1};
  options.max_translation = truth.translation.norm() + 0.1;
  expect_the_four_poses(object, options);
  // the second is a quarter turn from the first, the third a half
  options.initial_pose = InitialPose{truth, 2};
  options.num_hypotheses = 4;
  const Result result =
      register_correspondences(object.problem.source, object.problem.target, options);
  ASSERT_GE(result.alternatives.size(), 2u);
  const std::vector<Alternative> found = all_poses(result);
  for (const Alternative& pose : found) {
    EXPECT_TRUE(options.admit(pose.target_from_source));
  }
  EXPECT_LT(mean_point_error(found[1].target_from_source, object.poses[1], object.problem.source),
            0.02);
  EXPECT_LT(mean_point_error(found[2].target_from_source, object.poses[3], object.problem.source),
            0.02);
}

TEST(Hypotheses, AreAsManyAsAskedForOrAsThereAre) {
  const SymmetricObject object = symmetric_object(10, 0);
  for (Options options : {object.problem.options(), object.problem.options_with_unknown_scale()}) {
    const Result one =
        register_correspondences(object.problem.source, object.problem.target, options);
    EXPECT_TRUE(one.alternatives.empty());
    EXPECT_EQ(one.runner_up_ratio(), 0);
    options.num_hypotheses = 2;
    const Result two =
        register_correspondences(object.problem.source, object.problem.target, options);
    EXPECT_EQ(two.alternatives.size(), 1u);
    EXPECT_EQ(two.inliers, one.inliers);
    EXPECT_EQ(two.certificate.upper, one.certificate.upper);
  }
  Options options = object.problem.options();
  options.num_hypotheses = 20;
  const Result all =
      register_correspondences(object.problem.source, object.problem.target, options);
  EXPECT_EQ(all.alternatives.size(), 3u);
}

TEST(Hypotheses, OfAUniqueObjectAreFarBehind) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Problem problem = random_problem(seed, 30, 60);
    for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
      options.num_hypotheses = 2;
      const Result result = register_correspondences(problem.source, problem.target, options);
      EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source), 0.02);
      EXPECT_LT(result.runner_up_ratio(), 0.5);
    }
  }
}

TEST(Hypotheses, HaveAQuarterOfTheEvidenceOfTheBestAtLeast) {
  for (const Index count : {9, 11}) {
    Problem problem = random_problem(3, 40 + count, 0);
    problem.target = problem.truth.apply(problem.source);
    problem.target.rightCols(count).colwise() += Eigen::Vector3d(5, 0, 0);
    Options options = problem.options();
    options.evidence = Evidence::Count;
    options.num_hypotheses = 2;
    const Result result = register_correspondences(problem.source, problem.target, options);
    EXPECT_EQ(result.inliers.size(), 40u);
    EXPECT_EQ(result.alternatives.size(), count < 10 ? 0u : 1u);
  }
}

TEST(Hypotheses, OfTooFewCorrespondencesAreNone) {
  for (Index count = 0; count <= 3; ++count) {
    const Problem problem = random_problem(1, count, 0);
    Options options = problem.options();
    options.num_hypotheses = 5;
    const Result result = register_correspondences(problem.source, problem.target, options);
    EXPECT_EQ(result.status, count < 3 ? Status::TooFewCorrespondences : Status::Ok);
    EXPECT_TRUE(result.alternatives.empty());
  }
}

TEST(Hypotheses, OfATriangleThatNoPoseHoldsAreNone) {
  // the pairs agree, but the fit leaves each corner 1.15 bounds away
  Points source(3, 3);
  source << 0, 1, 0.5, 0, 0, std::sqrt(0.75), 0, 0, 0;
  Options options;
  options.noise_bound = 0.01;
  options.num_hypotheses = 1'000'000'000;
  const Result result = register_correspondences(source, 1.0199 * source, options);
  EXPECT_TRUE(result.alternatives.empty());
  EXPECT_LT(result.diagnostics.total_seconds, 10);
}

}  // namespace
}  // namespace gmcr::registration
