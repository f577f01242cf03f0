#include "proof/consensus_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "gmcr/clique.hpp"
#include "problem/graph/consistency_graph.hpp"
#include "random_geometry.hpp"

namespace gmcr::proof {
namespace {

constexpr double kBound = 0.05;

/// A few correspondences, and how much each of them weighs.
struct WeightedProblem {
  geometry::CorrespondenceArrays arrays;
  ScaleRange scales{1, 1};
  std::vector<double> weights;

  Index size() const { return arrays.size(); }
  double total() const { return std::accumulate(weights.begin(), weights.end(), 0.0); }
  BitsetGraph graph() const { return problem::consistency_graph(arrays, scales, 1); }

  double weight_of(const Similarity& pose) const {
    const Points images = pose.apply(arrays.source.transpose());
    double weight = 0;
    for (Index i = 0; i < size(); ++i) {
      const double residual = (arrays.target.row(i).transpose() - images.col(i)).norm();
      if (residual <= arrays.bounds[i]) weight += weights[static_cast<std::size_t>(i)];
    }
    return weight;
  }

  /// Runs the search; the poses that it offers are measured by the weight of what they hold.
  double search(double to_beat,
                const parallel::Deadline& deadline = parallel::Deadline::never()) const {
    const BitsetGraph edges = graph();
    double best = to_beat;
    const auto offer = [&](const problem::CentredPose& pose) {
      EXPECT_GE(pose.scale(), scales.min);
      EXPECT_LE(pose.scale(), scales.max);
      return best = std::max(best, weight_of(pose.similarity));
    };
    return ConsensusSearch(arrays, edges, weights, scales, offer, {deadline}).run(to_beat);
  }
};

enum class Kind { Loose, Planted, Mirrored, NearDuplicates };

WeightedProblem small_problem(std::uint64_t seed, Kind kind, bool scale_is_known, bool same_bounds,
                              bool same_weights) {
  testing::RandomGeometry random(seed);
  const Index n = 8 + random.index(4);
  WeightedProblem problem;
  if (!scale_is_known) problem.scales = {0.8, 1.3};
  const Similarity truth = random.similarity(problem.scales.min, problem.scales.max, 1);
  Points source = random.in_cube(n);
  if (kind == Kind::NearDuplicates) {
    for (Index i = 3; i < n; ++i) {
      if (i % 2 == 0) source.col(i) = source.col(i % 3) + random.in_ball(kBound);
    }
  }
  Points target = truth.apply(source);
  if (kind == Kind::Mirrored) {
    const Eigen::Vector3d normal = random.unit();
    for (Index i = 4; i < n; ++i) {
      target.col(i) -= 2 * normal.dot(target.col(i) - truth.translation) * normal;
    }
  }
  problem.arrays.bounds.resize(n);
  for (Index i = 0; i < n; ++i) {
    problem.arrays.bounds[i] = same_bounds ? kBound : kBound * random.uniform(0.5, 2);
    const bool is_outlier = kind == Kind::Planted && i >= n / 2;
    const double noise = is_outlier ? 6 : kind == Kind::Loose ? 2.5 : 1.2;
    target.col(i) += random.in_ball(noise * problem.arrays.bounds[i]);
    problem.weights.push_back(same_weights ? 1 : random.uniform(0.05, 1));
  }
  problem.arrays.source = source.transpose();
  problem.arrays.target = target.transpose();
  return problem;
}

enum class Fits { Yes, No, Unknown };

/// Whether some pose holds all of the members: by minimax fits until they prove the one or the
/// other.
Fits fits_jointly(const WeightedProblem& problem, const std::vector<Index>& members) {
  estimation::MinimaxFit fit(problem.arrays.source(members, Eigen::all).transpose(),
                             problem.arrays.target(members, Eigen::all).transpose(),
                             problem.arrays.bounds(members),
                             estimation::PoseConstraints{problem.scales});
  for (int step = 0; step < 1000 && fit.step(); ++step) {
    if (fit.residuals().maxCoeff() <= 1) return Fits::Yes;
    if (fit.lower_bound() > 1 + 1e-6) return Fits::No;
  }
  return Fits::Unknown;
}

/// Largest weight of a set that one pose holds, over all subsets; nullopt where one that would be
/// larger stays undecided.
std::optional<double> heaviest_by_enumeration(const WeightedProblem& problem) {
  const BitsetGraph graph = problem.graph();
  const auto n = static_cast<unsigned>(problem.size());
  std::vector<Fits> fits(std::size_t{1} << n, Fits::Yes);
  double heaviest = 0, undecided = 0;
  for (unsigned mask = 1; mask < (1u << n); ++mask) {
    std::vector<Index> members;
    double weight = 0;
    for (unsigned v = 0; v < n; ++v) {
      if ((mask >> v & 1u) == 0) continue;
      // what does not fit does not fit with more
      if (fits[mask & ~(1u << v)] == Fits::No) fits[mask] = Fits::No;
      members.push_back(static_cast<Index>(v));
      weight += problem.weights[v];
    }
    if (members.size() == 2 && !graph.has_edge(members[0], members[1])) fits[mask] = Fits::No;
    if (members.size() > 2 && fits[mask] != Fits::No) fits[mask] = fits_jointly(problem, members);
    if (fits[mask] == Fits::Yes) heaviest = std::max(heaviest, weight);
    if (fits[mask] == Fits::Unknown) undecided = std::max(undecided, weight);
  }
  if (undecided > heaviest) return std::nullopt;
  return heaviest;
}

struct Tally {
  int problems = 0, undecided = 0, exact = 0, exact_from_truth = 0, below_total = 0;
};

void compare_with_enumeration(const WeightedProblem& problem, Tally& tally) {
  const auto truth = heaviest_by_enumeration(problem);
  ++tally.problems;
  if (!truth) {
    ++tally.undecided;
    return;
  }
  const double rounding = 1e-9;
  const double from_nothing = problem.search(0), from_truth = problem.search(*truth);
  EXPECT_GE(from_nothing, *truth - rounding);
  EXPECT_GE(from_truth, *truth - rounding);
  EXPECT_GE(problem.search(0.7 * *truth), *truth - rounding);
  EXPECT_LE(from_nothing, problem.total() + rounding);
  const double late = problem.search(0, parallel::Deadline(0));
  EXPECT_GE(late, *truth - rounding);
  EXPECT_LE(late, problem.total() + rounding);
  tally.exact += from_nothing <= *truth + rounding;
  tally.exact_from_truth += from_truth <= *truth + rounding;
  tally.below_total += *truth < problem.total() - rounding;
}

class ConsensusSearchOfKind : public ::testing::TestWithParam<Kind> {};

TEST_P(ConsensusSearchOfKind, IsThatOfAllSubsets) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (unsigned choice = 0; choice < 8; ++choice) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " choice " << choice);
      compare_with_enumeration(
          small_problem(100 * seed + choice, GetParam(), choice & 1u, choice & 2u, choice & 4u),
          tally);
    }
  }
  EXPECT_LE(tally.undecided, tally.problems / 10);
  const int decided = tally.problems - tally.undecided;
  EXPECT_GE(tally.exact, 0.97 * decided);
  EXPECT_GE(tally.exact_from_truth, 0.97 * decided);
  EXPECT_GE(tally.below_total, decided / 3);  // there was something to prove
}

INSTANTIATE_TEST_SUITE_P(Problems, ConsensusSearchOfKind,
                         ::testing::Values(Kind::Loose, Kind::Planted, Kind::Mirrored,
                                           Kind::NearDuplicates));

/// A cloud and its mirror image: all distances agree.
WeightedProblem mirrored_cloud(std::uint64_t seed, Index count, double bound) {
  testing::RandomGeometry random(seed);
  WeightedProblem problem;
  const Points source = random.in_cube(count);
  Points target = random.rotation() * source;
  target.row(0) *= -1;
  problem.arrays = {source.transpose(), target.transpose(), Eigen::ArrayXd::Constant(count, bound)};
  problem.weights.assign(static_cast<std::size_t>(count), 1);
  return problem;
}

TEST(ConsensusSearch, ProvesThatNoPoseHoldsAMirroredCliqueWhole) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const WeightedProblem problem = mirrored_cloud(seed, 14, 0.02);
    ASSERT_EQ(problem.graph().num_edges(), 14 * 13 / 2);
    const double bound = problem.search(0);
    EXPECT_GE(bound, 3);  // any three points are held
    EXPECT_LE(bound, 8);
  }
}

TEST(ConsensusSearch, OfLooseBoundsHoldsAll) {
  const WeightedProblem problem = mirrored_cloud(1, 14, 2);
  EXPECT_EQ(problem.search(0), 14);
  EXPECT_EQ(problem.search(14), 14);
}

TEST(ConsensusSearch, NeedsNoHelpOfThePosesItOffers) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const WeightedProblem problem = small_problem(seed, Kind::Loose, true, true, true);
    const auto truth = heaviest_by_enumeration(problem);
    if (!truth) continue;
    const BitsetGraph graph = problem.graph();
    const parallel::Deadline never = parallel::Deadline::never();
    const auto refuse = [](const problem::CentredPose&) { return 0.0; };
    ConsensusSearch search(problem.arrays, graph, problem.weights, problem.scales, refuse, {never});
    EXPECT_GE(search.run(0), *truth);
    EXPECT_LE(search.run(0), *truth + 1);
  }
}

TEST(ConsensusSearch, OfSetsThatAllFitIsTheCliqueNumberOfTheGraph) {
  // what the graph excludes for other reasons stays excluded
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const WeightedProblem problem = mirrored_cloud(seed, 16, 5);
    testing::RandomGeometry random(seed);
    BitsetGraph graph(16);
    for (Index i = 0; i < 16; ++i) {
      for (Index j = 0; j < i; ++j) {
        if (random.uniform(0, 1) < 0.6) graph.add_edge(i, j);
      }
    }
    const parallel::Deadline never = parallel::Deadline::never();
    const auto refuse = [](const problem::CentredPose&) { return 0.0; };
    ConsensusSearch search(problem.arrays, graph, problem.weights, problem.scales, refuse, {never});
    EXPECT_EQ(search.run(0), static_cast<double>(max_clique(graph, {}).vertices.size()));
  }
}

TEST(ConsensusSearch, OffersAPoseThatHoldsThePlantedSet) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const WeightedProblem problem = small_problem(seed, Kind::Planted, true, true, true);
    const auto truth = heaviest_by_enumeration(problem);
    if (!truth) continue;
    const BitsetGraph graph = problem.graph();
    const parallel::Deadline never = parallel::Deadline::never();
    double best = 0;
    const auto offer = [&](const problem::CentredPose& pose) {
      return best = std::max(best, problem.weight_of(pose.similarity));
    };
    ConsensusSearch(problem.arrays, graph, problem.weights, problem.scales, offer, {never}).run(0);
    EXPECT_EQ(best, *truth);
  }
}

TEST(ConsensusSearch, EndsWithItsWorkAndBoundsAllTheSame) {
  const parallel::Deadline never = parallel::Deadline::never();
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const WeightedProblem problem = small_problem(seed, Kind::Loose, false, true, false);
    const BitsetGraph graph = problem.graph();
    const double most = problem.search(0);
    for (const std::uint64_t work : {0, 1, 50, 500}) {
      double best = 0;
      const auto offer = [&](const problem::CentredPose& pose) {
        return best = std::max(best, problem.weight_of(pose.similarity));
      };
      ConsensusSearch search(problem.arrays, graph, problem.weights, problem.scales, offer,
                             {never, work});
      EXPECT_GE(search.run(0) * (1 + 1e-9), most) << "work " << work;
      EXPECT_LE(search.work_left(), work);
    }
  }
}

TEST(ConsensusSearch, OfFewCorrespondencesIsTheCliqueNumber) {
  for (const Index count : {0, 1, 2}) {
    EXPECT_EQ(mirrored_cloud(1, count, 0.02).search(0), count);
  }
  EXPECT_EQ(mirrored_cloud(1, 3, 0.02).search(0), 3);  // three points have no handedness
  EXPECT_EQ(mirrored_cloud(1, 3, 0.02).search(3), 3);
}

TEST(ConsensusSearch, OfAGraphWithoutEdgesIsTheHeaviestVertex) {
  WeightedProblem problem = mirrored_cloud(1, 7, 0.01);
  for (Index i = 0; i < 7; ++i) {
    problem.arrays.target.row(i) *= static_cast<double>(10 * (i + 1));
    problem.weights[static_cast<std::size_t>(i)] = 0.1 * static_cast<double>(i + 1);
  }
  ASSERT_EQ(problem.graph().num_edges(), 0);
  EXPECT_DOUBLE_EQ(problem.search(0), 0.7);
  EXPECT_EQ(problem.search(0.8), 0.8);
}

}  // namespace
}  // namespace gmcr::proof
