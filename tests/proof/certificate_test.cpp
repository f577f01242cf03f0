#include "proof/certificate.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <vector>

#include "gmcr/synthetic.hpp"
#include "problems.hpp"

namespace gmcr::proof {
namespace {

using testing::Problem;
using testing::random_problem;

Problem synthetic_problem(SyntheticOptions options) {
  const SyntheticProblem p = make_synthetic(options);
  return {p.source, p.target, p.target_from_source, p.noise_bound};
}

/// Random outliers, with a bound so loose that chance inliers are many.
Problem loose_ball(std::uint64_t seed) {
  SyntheticOptions options;
  options.num_correspondences = 40;
  options.outlier_rate = 0.7;
  options.noise_bound = 0.15;
  options.noise_extent = 0.15;
  options.scale_range = {0.7, 1.5};
  options.seed = seed;
  return synthetic_problem(options);
}

Problem structured(std::uint64_t seed) {
  SyntheticOptions options = paper_structured_options();
  options.num_correspondences = 45;
  options.num_cloud_points = 500;
  options.outlier_rate = 0.6;
  options.seed = seed;
  return synthetic_problem(options);
}

/// Correspondences that say the same thing twice, and sources and targets with several partners.
Problem with_duplicates(std::uint64_t seed) {
  Problem problem = random_problem(seed, 20, 20, 1.3);
  testing::RandomGeometry random(seed + 1);
  for (Index i = 0; i < 5; ++i) {
    problem.source.col(20 + i) = problem.source.col(i) + random.in_ball(0.004);
    problem.target.col(20 + i) = problem.target.col(i) + random.in_ball(0.004);
    problem.source.col(30 + i) = problem.source.col(25);
    problem.target.col(35 + i) = problem.target.col(i);
  }
  return problem;
}

std::vector<Problem> all_kinds(std::uint64_t seed) {
  return {loose_ball(seed), structured(seed), with_duplicates(seed)};
}

/// A prior on gravity that the truth satisfies.
GravityPrior gravity_of(const Similarity& truth) {
  return {Eigen::Vector3d::UnitZ(), truth.rotation * Eigen::Vector3d::UnitZ(), 0.3};
}

/// Every option that the bounds depend on, two values each.
std::vector<Options> all_options(const Problem& problem) {
  std::vector<Options> all;
  for (unsigned choice = 0; choice < 32; ++choice) {
    Options options = choice & 1u ? problem.options_with_unknown_scale() : problem.options();
    options.evidence = choice & 2u ? Evidence::Count : Evidence::Distinct;
    options.certify = choice & 4u;
    options.one_to_one = choice & 8u;
    if (choice & 16u) options.gravity = gravity_of(problem.truth);
    options.time_limit = options.certify ? 0.02 : 10;
    all.push_back(options);
  }
  return all;
}

/// The truth, what was found, and poses around them, as far as the certificate speaks of them.
std::vector<Similarity> poses_to_bound(const Problem& problem, const Result& result,
                                       const Options& options, std::uint64_t seed) {
  std::vector<Similarity> poses{problem.truth, result.target_from_source};
  for (const Alternative& alternative : result.alternatives) {
    poses.push_back(alternative.target_from_source);
  }
  testing::RandomGeometry random(seed);
  const std::size_t num_centres = poses.size();
  for (int k = 0; k < 40; ++k) {
    Similarity pose = poses[static_cast<std::size_t>(k) % num_centres];
    pose.rotation = Eigen::AngleAxisd(random.uniform(0, 0.1), random.unit()) * pose.rotation;
    pose.translation += random.in_ball(2 * problem.noise_bound);
    if (options.scale_mode == ScaleMode::Estimated) pose.scale *= random.uniform(0.95, 1.05);
    poses.push_back(pose);
  }
  std::erase_if(poses, [&](const Similarity& pose) {
    const ScaleRange& scales = result.diagnostics.scale_range;
    return !options.admit(pose) || pose.scale < scales.min || pose.scale > scales.max;
  });
  return poses;
}

void expect_valid(const Problem& problem, const Result& result, const Options& options,
                  std::uint64_t seed) {
  const Certificate& certificate = result.certificate;
  const Consensus achieved =
      evaluate_consensus(certificate.target_from_source, problem.source, problem.target, options);
  EXPECT_EQ(certificate.inliers, achieved.inliers);
  EXPECT_EQ(certificate.lower, static_cast<Index>(achieved.inliers.size()));
  EXPECT_NEAR(certificate.evidence.lower, achieved.evidence, 1e-9);
  EXPECT_GE(certificate.upper, certificate.lower);
  EXPECT_GE(certificate.evidence.upper, certificate.evidence.lower);
  EXPECT_EQ(certificate.certified, certificate.upper == certificate.lower);
  EXPECT_EQ(certificate.evidence.certified,
            certificate.evidence.upper <= certificate.evidence.lower * (1 + 1e-9));
  if (options.evidence == Evidence::Count) {
    EXPECT_EQ(certificate.evidence.lower, static_cast<double>(certificate.lower));
    EXPECT_EQ(certificate.evidence.upper, static_cast<double>(certificate.upper));
  }
  const auto poses = poses_to_bound(problem, result, options, seed);
  EXPECT_GE(poses.size(), 2u);
  for (const Similarity& pose : poses) {
    const Consensus consensus = evaluate_consensus(pose, problem.source, problem.target, options);
    EXPECT_GE(certificate.upper, static_cast<Index>(consensus.inliers.size()));
    EXPECT_GE(certificate.evidence.upper, consensus.evidence - 1e-9);
  }
}

TEST(Certificate, BoundsTheTruthTheAlternativesAndAllAroundThem) {
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    for (const Problem& problem : all_kinds(seed)) {
      unsigned choice = 0;
      for (Options options : all_options(problem)) {
        SCOPED_TRACE(::testing::Message() << "seed " << seed << " options " << choice++);
        options.num_hypotheses = 3;
        const Result result = register_correspondences(problem.source, problem.target, options);
        expect_valid(problem, result, options, seed);
      }
    }
  }
}

/// Of several problems together.
struct Sums {
  Index upper = 0;
  double evidence_gap = 0;
  int certified = 0;  ///< whose evidence is

  void add(const Certificate& c) {
    upper += c.upper;
    evidence_gap += c.evidence.upper - c.evidence.lower;
    certified += c.evidence.certified;
  }
};

TEST(Certificate, IsTightenedByTheJointSearchAndNeverLoosened) {
  for (const bool scale_is_known : {true, false}) {
    Sums without, with;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      for (const Problem& problem : {loose_ball(seed), structured(seed)}) {
        Options options = scale_is_known ? problem.options() : problem.options_with_unknown_scale();
        const Result plain = register_correspondences(problem.source, problem.target, options);
        options.certify = true;
        options.time_limit = 1 + 3 * plain.diagnostics.total_seconds;
        const Result tight = register_correspondences(problem.source, problem.target, options);
        const Certificate &loose = plain.certificate, &bounds = tight.certificate;
        EXPECT_LE(bounds.upper, loose.upper) << seed;
        EXPECT_LE(bounds.evidence.upper, loose.evidence.upper + 1e-9) << seed;
        EXPECT_GE(bounds.evidence.lower, loose.evidence.lower - 1e-9);
        without.add(loose);
        with.add(bounds);
      }
    }
    EXPECT_LT(with.upper, without.upper);
    EXPECT_LE(with.evidence_gap, without.evidence_gap);  // few matches are nearly proven without
    EXPECT_GE(with.certified, without.certified);
  }
}

TEST(Certificate, OfAMirroredCloudIsProvenByTheJointSearchAlone) {
  testing::RandomGeometry random(4);
  const Points source = random.in_cube(16);
  Points target = source;
  target.row(0) *= -1;
  Options options;
  options.noise_bound = 0.02;
  const Result plain = register_correspondences(source, target, options);
  EXPECT_GE(plain.certificate.upper, 15);
  EXPECT_FALSE(plain.certificate.certified);
  options.certify = true;
  const Result tight = register_correspondences(source, target, options);
  EXPECT_TRUE(tight.certificate.certified);
  EXPECT_LT(tight.certificate.upper, 10);
}

TEST(Certificate, IsTheSameForAnyNumberOfThreads) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    // small enough that no clock ends the search
    const Problem problem = random_problem(seed, 12, 12);
    for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
      options.noise_bound = 0.03;
      options.certify = true;
      options.num_hypotheses = 2;
      options.num_threads = 1;
      const Result one = register_correspondences(problem.source, problem.target, options);
      options.num_threads = 4;
      const Result four = register_correspondences(problem.source, problem.target, options);
      EXPECT_EQ(one.target_from_source.matrix(), four.target_from_source.matrix());
      EXPECT_EQ(one.inliers, four.inliers);
      EXPECT_EQ(one.evidence, four.evidence);
      EXPECT_EQ(one.certificate.upper, four.certificate.upper);
      EXPECT_EQ(one.certificate.evidence.upper, four.certificate.evidence.upper);
      ASSERT_EQ(one.alternatives.size(), four.alternatives.size());
      for (std::size_t k = 0; k < one.alternatives.size(); ++k) {
        EXPECT_EQ(one.alternatives[k].inliers, four.alternatives[k].inliers);
      }
    }
  }
}

TEST(Certificate, IsNotLoweredBelowWhatWasAchievedByAnAddedOutlier) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    for (const Problem& problem : all_kinds(seed)) {
      for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
        if (options.scale_mode == ScaleMode::Estimated) options.scale_range = ScaleRange{0.5, 6};
        const Result before = register_correspondences(problem.source, problem.target, options);
        const Index n = problem.source.cols();
        Points source(3, n + 1), target(3, n + 1);
        source << problem.source, Eigen::Vector3d(9, 9, 9);
        target << problem.target, Eigen::Vector3d(-50, 80, 7);
        const Result after = register_correspondences(source, target, options);
        EXPECT_GE(after.certificate.upper, before.certificate.lower);
        EXPECT_GE(after.certificate.evidence.upper, before.certificate.evidence.lower - 1e-9);
      }
    }
  }
}

/// Structured outliers, many of them consistent by chance: no proof within a second.
Problem hard_problem() {
  SyntheticOptions synthetic;
  synthetic.num_correspondences = 400;
  synthetic.outlier_rate = 0.9;
  synthetic.noise_bound = 0.2;
  synthetic.noise_extent = 0.2;
  synthetic.seed = 1;
  return synthetic_problem(synthetic);
}

/// Whether the result says that it counted where evidence was asked for.
bool counts_inliers(const Result& result) {
  const auto& limits = result.diagnostics.limits_hit;
  return std::any_of(limits.begin(), limits.end(), [](const LimitHit& hit) {
    return hit.sentence.find("inliers were counted") != std::string::npos;
  });
}

TEST(Certificate, OfTheShortestTimeIsValidAndSaysSo) {
  const Problem problem = hard_problem();
  for (const bool certify : {false, true}) {
    for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
      options.certify = certify;
      options.num_hypotheses = 3;
      options.time_limit = 1e-6;
      const Result result = register_correspondences(problem.source, problem.target, options);
      EXPECT_FALSE(result.diagnostics.limits_hit.empty());
      EXPECT_FALSE(result.certificate.certified);
      if (counts_inliers(result)) options.evidence = Evidence::Count;
      expect_valid(problem, result, options, 1);
    }
  }
}

TEST(Certificate, OfAHardProblemKeepsToTheTime) {
  const Problem problem = hard_problem();
  for (Options options : {problem.options(), problem.options_with_unknown_scale()}) {
    options.certify = true;
    options.num_hypotheses = 3;
    options.time_limit = 0.2;
    const auto begin = std::chrono::steady_clock::now();
    const Result result = register_correspondences(problem.source, problem.target, options);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(wall.count(), 5);  // a proof takes minutes
    EXPECT_FALSE(result.diagnostics.limits_hit.empty());
    EXPECT_FALSE(result.certificate.certified);
    expect_valid(problem, result, options, 1);
  }
}

TEST(Certify, NeverBoundsBelowWhatWasAchieved) {
  EXPECT_TRUE(certify(5, 5, 5, 5).certified);
  EXPECT_FALSE(certify(5, 6, 5, 6).certified);
  EXPECT_EQ(certify(5, 3, 4, 2).upper, 5);
  EXPECT_EQ(certify(5, 3, 4, 2).evidence.upper, 4);
}

TEST(Certify, TakesTheNumberOfInliersForABoundOnTheirEvidence) {
  const Certificate certificate = certify(5, 6, 3.5, 8);
  EXPECT_EQ(certificate.evidence.lower, 3.5);
  EXPECT_EQ(certificate.evidence.upper, 6);
  EXPECT_FALSE(certificate.evidence.certified);
  EXPECT_TRUE(certify(5, 6, 3.5, 3.5 + 1e-12).evidence.certified);
}

}  // namespace
}  // namespace gmcr::proof
