#include "gmcr/priors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using Eigen::Vector3d;
using testing::Problem;

Eigen::Matrix3d about(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

GravityPrior upright(double max_tilt) {
  return {Vector3d(0, 0, 2), Vector3d(0, 0, 9.81), max_tilt};
}

/// 20 correspondences follow a truth with upright gravity, 35 another pose, 45 none.
struct Contest {
  Problem problem;
  Similarity rival;
};

Contest contest(std::uint64_t seed, double tilt = 0) {
  Contest c{testing::random_problem(seed, 20, 80), {}};
  testing::RandomGeometry random(seed + 1000);
  Similarity& truth = c.problem.truth;
  truth.rotation = about(Vector3d(1, 1, 0), tilt) * about(Vector3d::UnitZ(), random.uniform(-3, 3));
  truth.translation = 0.4 * random.unit();
  c.rival.rotation = about(Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 0), 1.2) *
                     about(Vector3d::UnitZ(), random.uniform(-3, 3));
  c.rival.translation = 3 * random.unit();
  for (Index i = 0; i < 55; ++i) {
    const Similarity& pose = i < 20 ? truth : c.rival;
    c.problem.target.col(i) =
        pose * c.problem.source.col(i) + random.in_ball(c.problem.noise_bound);
  }
  return c;
}

Result solve(const Problem& problem, Options options, const Priors& priors) {
  static_cast<Priors&>(options) = priors;
  const Result result = register_correspondences(problem.source, problem.target, options);
  if (result.status == Status::Ok) {
    EXPECT_TRUE(priors.admit(result.target_from_source));
  }
  return result;
}

/// Each prior alone tells the truth of a contest from its rival.
std::vector<Priors> telling_priors(const Similarity& truth) {
  std::vector<Priors> all(5);
  all[0].gravity = upright(0);
  all[1].gravity = upright(0.3);
  all[2].initial_pose =
      InitialPose{{1, about(Vector3d(1, 2, 3), 0.2) * truth.rotation, Vector3d::Zero()}, 0.25};
  all[3].initial_pose = InitialPose{truth, std::numbers::pi, 0.5};
  all[4].max_translation = 0.5;
  return all;
}

bool constrains_rotation(const Priors& priors) {
  return priors.gravity || (priors.initial_pose && priors.initial_pose->max_rotation < 3);
}

TEST(Priors, TellTheTruthFromARivalWithMoreInliers) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto [problem, rival] = contest(seed);
    for (const Method method : {Method::Gmcr, Method::Paper}) {
      for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
        options.method = method;
        const Result free = solve(problem, options, {});
        EXPECT_LT(mean_point_error(free.target_from_source, rival, problem.source), 0.02);
        for (const Priors& priors : telling_priors(problem.truth)) {
          const Result result = solve(problem, options, priors);
          if (method == Method::Paper && options.scale_mode == ScaleMode::Estimated &&
              !constrains_rotation(priors)) {
            continue;  // its scale stage sees pairs only, of which the translation says nothing
          }
          EXPECT_EQ(result.status, Status::Ok) << result.status_reason;
          EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source),
                    0.02);
          EXPECT_GE(result.inliers.size(), 18u);
          EXPECT_GE(result.certificate.upper, 20);
        }
      }
    }
  }
}

TEST(Priors, TightenTheCertificate) {
  const auto [problem, rival] = contest(3);
  Priors priors;
  priors.gravity = upright(0);
  EXPECT_GE(solve(problem, problem.options(), {}).certificate.upper, 35);
  const Result result = solve(problem, problem.options(), priors);
  EXPECT_EQ(result.certificate.upper, 20);
  EXPECT_TRUE(result.certificate.certified);
}

TEST(Priors, ATiltWithinTheLimitIsFoundAndOneBeyondIsNot) {
  const auto [problem, rival] = contest(4, 0.2);
  Priors priors;
  priors.gravity = upright(0.201);
  EXPECT_GE(solve(problem, problem.options(), priors).certificate.lower, 20);
  priors.gravity = upright(0.1);
  EXPECT_LT(solve(problem, problem.options(), priors).certificate.lower, 15);
}

TEST(Priors, OnTheTranslationLeaveOutWhatNoPoseCanMap) {
  const auto [problem, rival] = contest(5);
  Priors priors;
  EXPECT_EQ(solve(problem, problem.options(), priors).diagnostics.num_used, 100);
  priors.max_translation = 0.5;
  const Result result = solve(problem, problem.options(), priors);
  EXPECT_LT(result.diagnostics.num_used, 100);
  EXPECT_GE(result.diagnostics.num_used, 20);
  EXPECT_LE(result.target_from_source.translation.norm(), 0.5 + 1e-12);
}

TEST(Priors, TogetherAndAtTheirLimitsKeepTheInliersFarFromTheOrigin) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const double unit = seed % 3 == 0 ? 1 : (seed % 3 == 1 ? 1e-3 : 1e3);
    auto [problem, rival] = contest(seed + 20);
    Similarity& truth = problem.truth;
    problem.source *= unit;
    problem.target *= unit;
    problem.noise_bound *= unit;
    truth.translation *= unit;
    if (seed >= 3) {
      const Vector3d source_offset(1e6, 2e6, -1e6), target_offset(-2e6, 1e6, 3e6);
      if (unit < 1) continue;  // a micrometre at 1e6 m has no digits
      problem.source.colwise() += source_offset;
      problem.target.colwise() += target_offset;
      truth.translation += target_offset - truth.rotation * source_offset;
    }
    Priors priors;
    priors.gravity = upright(0);
    priors.initial_pose = InitialPose{truth, 0.01, 0.05 * unit};
    priors.initial_pose->target_from_source.rotation =
        about(Vector3d::UnitZ(), 0.01) * truth.rotation;
    priors.max_translation = truth.translation.norm();
    for (const Options& options : {problem.options(), problem.options_with_unknown_scale()}) {
      const Result result = solve(problem, options, priors);
      EXPECT_EQ(result.status, Status::Ok) << seed << ' ' << result.status_reason;
      EXPECT_GE(result.inliers.size(), 17u) << seed;
      EXPECT_GE(result.certificate.upper, 20);
    }
  }
}

TEST(Priors, OfAKnownTranslationFarFromThePointsKeepTheInliers) {
  // a turn by the noise moves the far origin much more than the noise bound
  testing::RandomGeometry random(30);
  Problem problem = testing::random_problem(30, 30, 30);
  problem.source.colwise() += Vector3d(300, 0, 0);
  for (Index i = 0; i < 30; ++i) {
    problem.target.col(i) = problem.truth * problem.source.col(i) + random.in_ball(0.01);
  }
  Priors priors;
  priors.initial_pose = InitialPose{problem.truth, std::numbers::pi, 0.001};
  const Result result = solve(problem, problem.options(), priors);
  EXPECT_GE(result.inliers.size(), 28u);
  EXPECT_LE(translation_error(result.target_from_source.translation, problem.truth.translation),
            0.001 + 1e-9);
}

TEST(Priors, ThatNoPoseSatisfiesGiveNoConsensus) {
  const Contest c = contest(6);
  const Problem& problem = c.problem;
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    Options options = problem.options();
    options.method = method;
    Priors contradictory;
    contradictory.gravity = upright(0.1);
    contradictory.initial_pose = InitialPose{{1, about(Vector3d::UnitX(), 1), {0, 0, 0}}, 0.5};
    const Result none = solve(problem, options, contradictory);
    EXPECT_EQ(none.status, Status::NoConsensus);
    EXPECT_NE(none.status_reason.find("priors"), std::string::npos) << none.status_reason;

    Priors far;
    far.initial_pose = InitialPose{{1, Eigen::Matrix3d::Identity(), {1000, 0, 0}}, 3.2 - 0.1, 1};
    const Result nothing = solve(problem, options, far);
    EXPECT_EQ(nothing.status, Status::NoConsensus);
    EXPECT_NE(nothing.status_reason.find("priors"), std::string::npos) << nothing.status_reason;
    EXPECT_EQ(nothing.diagnostics.num_used, 0);
    EXPECT_EQ(nothing.certificate.upper, 0);
    EXPECT_TRUE(nothing.inliers.empty());
  }
}

TEST(Priors, NeverLetTheBoundFallBelowAnAdmittedPose) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    testing::RandomGeometry random(seed);
    Problem problem = testing::random_problem(seed, 12, 60);
    for (Index i = 40; i < 60; ++i) {  // shared end points
      problem.source.col(i) = problem.source.col(i - 40);
      if (i % 2 == 0) problem.target.col(i) = problem.target.col(i - 40);
    }
    Options options = problem.options();
    options.noise_bound = 0.05;
    options.one_to_one = seed % 2 == 0;
    options.method = seed % 4 < 2 ? Method::Gmcr : Method::Paper;
    const Vector3d up = random.unit();
    options.gravity = GravityPrior{up, problem.truth.rotation * up, 0.01};
    options.max_translation = problem.truth.translation.norm();
    const auto at_truth =
        evaluate_consensus(problem.truth, problem.source, problem.target, options).inliers.size();
    const Result result = solve(problem, options, options);
    EXPECT_GE(result.certificate.upper, static_cast<Index>(at_truth)) << seed;
    EXPECT_GE(result.certificate.upper, result.certificate.lower);
  }
}

TEST(Priors, OnGravityMakeCollinearInliersEnough) {
  testing::RandomGeometry random(9);
  Similarity truth;
  truth.rotation = about(Vector3d::UnitZ(), 1.1);
  truth.translation = Vector3d(1, 2, 3);
  for (const bool along_gravity : {false, true}) {
    const Vector3d direction = along_gravity ? Vector3d(0, 0, 1) : Vector3d(1, 2, 3);
    Points source(3, 20);
    for (Index i = 0; i < 20; ++i) source.col(i) = random.uniform(-1, 1) * direction;
    const Points target = truth.apply(source);
    for (const Method method : {Method::Gmcr, Method::Paper}) {
      Options options;
      options.noise_bound = 0.01;
      options.method = method;
      for (const double max_tilt : {0.0, 0.01}) {
        options.gravity = upright(max_tilt);
        const Result result = register_correspondences(source, target, options);
        EXPECT_EQ(result.status, along_gravity ? Status::Degenerate : Status::Ok) << max_tilt;
        EXPECT_EQ(result.inliers.size(), 20u);
        if (along_gravity) continue;
        EXPECT_LT(rotation_error_deg(result.target_from_source.rotation, truth.rotation), 1);
      }
      options.gravity = upright(0.2);
      EXPECT_EQ(register_correspondences(source, target, options).status, Status::Degenerate);
    }
  }
}

TEST(Priors, GiveTheSameBitsForAnyNumberOfThreads) {
  Problem problem = testing::random_problem(40, 40, 600);
  Options options = problem.options();
  options.one_to_one = true;
  options.gravity =
      GravityPrior{Vector3d::UnitX(), problem.truth.rotation * Vector3d::UnitX(), 0.05};
  options.num_threads = 1;
  const Result one = register_correspondences(problem.source, problem.target, options);
  options.num_threads = 4;
  const Result four = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(one.target_from_source.matrix(), four.target_from_source.matrix());
  EXPECT_EQ(one.certificate.upper, four.certificate.upper);
}

TEST(Priors, AreCheckedBeforeAnyWork) {
  const Problem problem = testing::random_problem(41, 10, 0);
  Options options = problem.options();
  options.max_translation = -1;
  EXPECT_THROW(register_correspondences(problem.source, problem.target, options),
               std::invalid_argument);
}

/// Exact correspondences of a truth that turns about the vertical.
Problem level_problem(Index count) {
  Problem problem = testing::random_problem(31, count, 0);
  problem.truth.rotation = about(Vector3d::UnitZ(), 1.2);
  problem.target = problem.truth.apply(problem.source);
  return problem;
}

TEST(Priors, OnGravityLeaveAPoseThatTwoCorrespondencesDetermine) {
  const Problem problem = level_problem(2);
  Priors priors;
  priors.gravity = upright(0);
  for (const Method method : {Method::Gmcr, Method::Paper}) {
    for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
      options.method = method;
      const Result result = solve(problem, options, priors);
      EXPECT_EQ(result.status, Status::Ok) << result.status_reason;
      EXPECT_EQ(result.inliers.size(), 2u);
      EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source), 0.01);
      EXPECT_EQ(solve(problem, options, {}).status, Status::TooFewCorrespondences);
    }
  }
  priors.gravity = upright(0.1);
  const Result tilted = solve(problem, problem.options(), priors);
  EXPECT_EQ(tilted.status, Status::TooFewCorrespondences) << "a tilt is one more unknown";
  EXPECT_NE(tilted.status_reason.find("3 are needed"), std::string::npos);
}

TEST(Priors, OnGravityDoNotTellTheTurnOfALineAlongIt) {
  Problem problem = level_problem(2);
  problem.source.col(1) = problem.source.col(0) + Vector3d(0, 0, 0.5);
  problem.target = problem.truth.apply(problem.source);
  Priors priors;
  priors.gravity = upright(0);
  EXPECT_EQ(solve(problem, problem.options(), priors).status, Status::Degenerate);
}

TEST(Priors, OnTheRotationLeaveAShiftThatOneCorrespondenceDetermines) {
  const Problem problem = level_problem(1);
  Priors priors;
  priors.initial_pose = InitialPose{{1, problem.truth.rotation, Vector3d::Zero()}, 0};
  const Result result = solve(problem, problem.options(), priors);
  EXPECT_EQ(result.status, Status::Ok) << result.status_reason;
  EXPECT_LT(mean_point_error(result.target_from_source, problem.truth, problem.source), 1e-9);
  const Result scaled = solve(problem, problem.options_with_unknown_scale(), priors);
  EXPECT_EQ(scaled.status, Status::TooFewCorrespondences);
  EXPECT_NE(scaled.status_reason.find("2 are needed"), std::string::npos);
  const Problem pair = level_problem(2);
  EXPECT_EQ(solve(pair, pair.options_with_unknown_scale(), priors).status, Status::Ok);
}

}  // namespace
}  // namespace gmcr::registration
