#include "search/scales/scale_votes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "problem/graph/consistency_graph.hpp"
#include "random_geometry.hpp"
#include "search/scales/vote_tally.hpp"

namespace gmcr::search {
namespace {

constexpr std::size_t kPlentyOfBytes = std::size_t{1} << 30;

ScaleVotes votes_of(const geometry::CorrespondenceArrays& arrays, const ScaleBins& bins,
                    const BinGroupWeights& weights, int num_threads = 1) {
  return count_scale_votes(arrays, bins, weights, kPlentyOfBytes, num_threads);
}

geometry::CorrespondenceArrays random_arrays(std::uint64_t seed, Index n, double bound) {
  testing::RandomGeometry random(seed);
  problem::Correspondences c{random.in_cube(n), random.in_cube(n, 1.0),
                             Eigen::ArrayXd::Constant(n, bound)};
  c.source.col(5) = c.source.col(4);  // agrees over many bins or none
  c.source.col(7) = c.source.col(6);
  c.target.col(7) = c.target.col(6);
  return problem::consistency_arrays(c, 50);
}

double at(const std::vector<double>& values, Index bin) {
  return values[static_cast<std::size_t>(bin)];
}

TEST(ScaleVotes, CountTheEdgesOfEachBinsGraph) {
  const Index n = 150;
  const auto arrays = random_arrays(2, n, 0.01);
  const ScaleBins bins({0.05, 50}, 1.3);
  const ScaleVotes votes = votes_of(arrays, bins, BinGroupWeights(n));
  for (Index bin = 0; bin < bins.size(); ++bin) {
    const Index edges = problem::consistency_graph(arrays, bins[bin], 1).num_edges();
    const Index pairs = votes.pairs[static_cast<std::size_t>(bin)];
    EXPECT_GE(pairs, edges);  // a bound: never fewer
    EXPECT_LE(pairs, edges + 1);
    EXPECT_EQ(at(votes.evidence, bin), static_cast<double>(pairs));
    Index of_chunks = 0;
    for (std::size_t k = static_cast<std::size_t>(bin); k < votes.pairs_of_chunks.size();
         k += static_cast<std::size_t>(bins.size())) {
      of_chunks += votes.pairs_of_chunks[k];
    }
    EXPECT_EQ(of_chunks, pairs);
  }
}

TEST(ScaleVotes, BoundTheMembersByTheDegreesOfEachBinsGraph) {
  const Index n = 150;
  const auto arrays = random_arrays(3, n, 0.04);
  const ScaleBins bins({0.05, 50}, 1.1);
  const ScaleVotes votes = votes_of(arrays, bins, BinGroupWeights(n));
  for (Index bin = 0; bin < bins.size(); ++bin) {
    const BitsetGraph graph = problem::consistency_graph(arrays, bins[bin], 1);
    std::vector<Index> degrees;
    for (Index v = 0; v < n; ++v) degrees.push_back(graph.degree(v));
    std::sort(degrees.rbegin(), degrees.rend());
    double most = 0;  // of m vertices each has m - 1 neighbours
    for (Index m = 1; m <= n; ++m) {
      if (degrees[static_cast<std::size_t>(m - 1)] >= m - 1) most = static_cast<double>(m);
    }
    EXPECT_GE(at(votes.max_members, bin), most);
    EXPECT_LE(at(votes.max_members, bin), most + 1);  // for a pair that only touches the bin
    EXPECT_EQ(at(votes.max_evidence, bin), at(votes.max_members, bin));
  }
}

TEST(ScaleVotes, BoundTheEvidenceOfEachBinsGraphWhereWeightsGrowWithTheScale) {
  const Index n = 120;
  const auto arrays = random_arrays(4, n, 0.03);
  const ScaleBins bins({0.05, 50}, 1.05);
  const auto weight = [&](Index i, double scale) {
    return std::min(1.0, (0.1 + scale / 50) / static_cast<double>(1 + i % 3));
  };
  const BinGroupWeights group_weights(n, bins, weight);
  ASSERT_GT(group_weights.group_of(bins.size() - 1), 3);
  const ScaleVotes votes = votes_of(arrays, bins, group_weights);
  for (Index bin = 0; bin < bins.size(); ++bin) {
    const BitsetGraph graph = problem::consistency_graph(arrays, bins[bin], 1);
    std::vector<double> weights;
    const std::uint32_t* of_group = group_weights.group(group_weights.group_of(bin));
    for (Index i = 0; i < n; ++i) {
      weights.push_back(static_cast<double>(of_group[i]) / BinGroupWeights::kOne);
      EXPECT_GE(weights.back(), weight(i, bins[bin].max));
    }
    double evidence = 0, heaviest = 0;
    std::vector<std::pair<double, double>> around;  // weight of a vertex and its neighbours
    for (Index i = 0; i < n; ++i) {
      double sum = weights[static_cast<std::size_t>(i)];
      for (Index j = 0; j < n; ++j) {
        const double both =
            weights[static_cast<std::size_t>(i)] * weights[static_cast<std::size_t>(j)];
        heaviest = std::max(heaviest, both);
        if (!graph.has_edge(i, j)) continue;
        if (j < i) evidence += both;
        sum += weights[static_cast<std::size_t>(j)];
      }
      around.emplace_back(sum, weights[static_cast<std::size_t>(i)]);
    }
    // never less, and no more than a pair that only touches the bin adds
    EXPECT_GE(at(votes.evidence, bin), evidence - 1e-9) << bin;
    EXPECT_LE(at(votes.evidence, bin), evidence + heaviest + 1e-3) << bin;
    std::sort(around.rbegin(), around.rend());
    double most = 0, sum = 0;
    for (const auto& [reach, own] : around) {
      sum += own;
      most = std::max(most, std::min(reach, sum));
    }
    EXPECT_GE(at(votes.max_evidence, bin), std::min(most, at(votes.max_members, bin)) - 1e-9);
    EXPECT_LE(at(votes.max_evidence, bin), most + 2);
    EXPECT_LE(at(votes.max_evidence, bin), at(votes.max_members, bin));
  }
}

TEST(ScaleVotes, WeighAPairByBothWeights) {
  problem::Correspondences c{Points::Zero(3, 2), Points::Zero(3, 2),
                             Eigen::ArrayXd::Constant(2, 1e-3)};
  c.source(0, 1) = 1;
  c.target(0, 1) = 2;
  const ScaleBins bins({1, 4}, 1.1);
  const BinGroupWeights weights(2, bins, [](Index i, double) { return i == 0 ? 0.5 : 0.25; });
  const ScaleVotes votes = votes_of(problem::consistency_arrays(c, 4), bins, weights);
  EXPECT_EQ(*std::max_element(votes.evidence.begin(), votes.evidence.end()), 0.125);
  EXPECT_EQ(*std::min_element(votes.evidence.begin(), votes.evidence.end()), 0);
}

TEST(ScaleVotes, AreTheSameForAnyNumberOfThreads) {
  const Index n = 600;
  const auto arrays = random_arrays(3, n, 0.05);
  const ScaleBins bins({0.05, 50}, 1.02);
  const BinGroupWeights weights(n, bins,
                                [](Index i, double) { return 1.0 / static_cast<double>(i + 1); });
  const ScaleVotes one = votes_of(arrays, bins, weights, 1);
  for (const std::size_t max_bytes : {kPlentyOfBytes, std::size_t{1}}) {
    const ScaleVotes four = count_scale_votes(arrays, bins, weights, max_bytes, 4);
    EXPECT_EQ(one.pairs, four.pairs);
    EXPECT_EQ(one.evidence, four.evidence);
    EXPECT_EQ(one.max_members, four.max_members);
    EXPECT_EQ(one.max_evidence, four.max_evidence);
    EXPECT_EQ(one.pairs_of_chunks, four.pairs_of_chunks);
  }
}

TEST(ScaleVotes, BoundByAllPairsWhereTimeIsUp) {
  const Index n = 20;
  const auto arrays = random_arrays(3, n, 0.05);
  const ScaleBins bins({0.05, 50}, 1.02);
  const ScaleVotes votes =
      count_scale_votes(arrays, bins, BinGroupWeights(n), kPlentyOfBytes, 1, parallel::Deadline(0));
  EXPECT_EQ(votes.pairs, std::vector<Index>(static_cast<std::size_t>(bins.size()), 190));
  EXPECT_EQ(at(votes.max_members, 3), 20);
  EXPECT_EQ(at(votes.max_evidence, 3), 20);
  EXPECT_TRUE(votes.pairs_of_chunks.empty());
  EXPECT_EQ(votes.evidence, std::vector<double>(static_cast<std::size_t>(bins.size())));
}

TEST(ScaleVotes, OfNoCorrespondencesAreNone) {
  const geometry::CorrespondenceArrays arrays{Eigen::MatrixX3d(0, 3), Eigen::MatrixX3d(0, 3), {}};
  const ScaleBins bins({1, 4}, 1.1);
  const ScaleVotes votes = votes_of(arrays, bins, BinGroupWeights(0));
  EXPECT_EQ(votes.pairs, std::vector<Index>(static_cast<std::size_t>(bins.size())));
  EXPECT_EQ(at(votes.max_members, 0), 0);
}

TEST(LogLevels, HoldEachNumberAndNoneAboveTheirTop) {
  for (std::uint64_t number = 1; number < 100'000; ++number) {
    const std::size_t level = LogLevels::of(number);
    EXPECT_GE(LogLevels::top(level), number);
    EXPECT_LE(static_cast<double>(LogLevels::top(level)),
              static_cast<double>(number) * (1 + 1 / 64.0));
    EXPECT_LT(LogLevels::top(level - 1), number);
  }
}

}  // namespace
}  // namespace gmcr::search
