#include "proof/improve.hpp"

#include <gtest/gtest.h>

#include "built_problem.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr::proof {
namespace {

/// 90 matches of a thin cloud, 19 of 20 of them wrong, in clusters that agree with each other.
SyntheticProblem thin_problem(std::uint64_t seed) {
  SyntheticOptions options = paper_structured_options();
  options.outlier_rate = 0.95;
  options.seed = seed;
  Points cloud = testing::RandomGeometry(seed).in_cube(options.num_cloud_points);
  cloud.topRows<2>() *= 0.15;
  return make_synthetic(options, cloud);
}

struct Evidence {
  double found = 0;
  double bound = 0;
};

Evidence evidence_of(search::BestPoseSearch& search) {
  return {search.poses().to_beat(problem::Measure::Evidence), search.bounds().evidence};
}

/// Evidence before and after.
std::pair<Evidence, Evidence> improve_on(const SyntheticProblem& matches, const Options& options) {
  problem::Run run(options);
  const problem::Problem problem(matches.source, matches.target, options, run);
  search::BestPoseSearch search(problem, run);
  const Evidence before = evidence_of(search);
  improve(search);
  return {before, evidence_of(search)};
}

Options unknown_scale(const SyntheticProblem& matches) {
  Options options;
  options.noise_bound = matches.noise_bound;
  options.scale_mode = ScaleMode::Estimated;
  options.num_threads = 1;
  return options;
}

TEST(Improve, ComesCloseToWhatAProofFinds) {
  double before = 0, after = 0, proven = 0;
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    const SyntheticProblem matches = thin_problem(seed);
    Options options = unknown_scale(matches);
    const auto [first, then] = improve_on(matches, options);
    EXPECT_GE(then.found, first.found);
    EXPECT_LE(then.bound, first.bound);
    EXPECT_GE(then.bound, then.found);
    before += first.found;
    after += then.found;
    options.certify = true;
    options.time_limit = 2;
    const Result best = register_correspondences(matches.source, matches.target, options);
    proven += best.certificate.evidence.lower;
    EXPECT_GE(then.bound * (1 + 1e-9), best.certificate.evidence.lower);
  }
  EXPECT_GT(proven - before, 1);  // else nothing was tested
  EXPECT_LT(proven - after, (proven - before) / 2);
}

TEST(Improve, IsPartOfASolveAndDoesTheSameWorkAnywhere) {
  const SyntheticProblem matches = thin_problem(3);
  Options options = unknown_scale(matches);
  const double found = improve_on(matches, options).second.found;
  for (const int threads : {1, 3}) {
    options.num_threads = threads;
    const Result result = register_correspondences(matches.source, matches.target, options);
    EXPECT_DOUBLE_EQ(result.certificate.evidence.lower, found);
  }
}

TEST(Improve, LeavesASearchWithoutGraphsAlone) {
  const auto matches = testing::random_problem(1, 400, 100);  // which samples decide
  const Options options = matches.options();
  problem::Run run(options);
  const problem::Problem problem(matches.source, matches.target, options, run);
  search::BestPoseSearch search(problem, run);
  ASSERT_TRUE(search.has_no_graphs());
  const Evidence before = evidence_of(search);
  improve(search);
  EXPECT_EQ(evidence_of(search).bound, before.bound);
}

}  // namespace
}  // namespace gmcr::proof
