#include "consensus/scale_bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "consensus/binned_pairs.hpp"
#include "consensus/consistency_graph.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

TEST(ScaleBins, CoverTheRangeWithoutGaps) {
  const ScaleBins bins({0.3, 7}, 1.1);
  EXPECT_EQ(bins[0].min, 0.3);
  EXPECT_EQ(bins[bins.size() - 1].max, 7);
  for (Index bin = 0; bin < bins.size(); ++bin) {
    EXPECT_LE(bins[bin].max / bins[bin].min, 1.1 + 1e-9);
    if (bin == 0) continue;
    EXPECT_EQ(bins[bin].min, bins[bin - 1].max);
  }
}

TEST(ScaleBins, OfOneScaleAreOneBin) {
  const ScaleBins bins({2, 2}, 1.02);
  EXPECT_EQ(bins.size(), 1);
  EXPECT_EQ(bins.covering(1, 3), (std::pair<Index, Index>{0, 0}));
  EXPECT_GT(bins.covering(2.1, 3).first, bins.covering(2.1, 3).second);
}

TEST(ScaleBins, CoveringNeverMissesABin) {
  testing::RandomGeometry random(1);
  const ScaleBins bins({0.05, 50}, 1.02);
  for (int trial = 0; trial < 2000; ++trial) {
    double lower = std::exp(random.uniform(-4, 5)), upper = lower * std::exp(random.uniform(0, 2));
    if (trial % 10 == 0) lower = bins[random.index(bins.size())].max;  // exactly on an edge
    if (trial % 7 == 0) lower = -upper;
    upper = std::max(lower, upper);
    const auto [first, last] = bins.covering(lower, upper);
    for (Index bin = 0; bin < bins.size(); ++bin) {
      const bool meets = lower <= bins[bin].max && upper >= bins[bin].min;
      const bool named = first <= bin && bin <= last;
      EXPECT_TRUE(named || !meets);
      EXPECT_TRUE(meets || !named || bin == first || bin == last);
    }
  }
}

TEST(ScaleVotes, CountTheEdgesOfEachBinsGraph) {
  testing::RandomGeometry random(2);
  const Index n = 150;
  Correspondences c{random.in_cube(n), random.in_cube(n, 1.0), Eigen::ArrayXd::Constant(n, 0.01)};
  c.source.col(5) = c.source.col(4);
  const auto arrays = consistency_arrays(c, 50);
  const ScaleBins bins({0.05, 50}, 1.3);
  const ScaleVotes votes = count_scale_votes(
      arrays, bins, [](Index, Index) { return 1.0; }, 1);
  for (Index bin = 0; bin < bins.size(); ++bin) {
    const Index edges = consistency_graph(arrays, bins[bin], 1).num_edges();
    const Index pairs = votes.pairs[static_cast<std::size_t>(bin)];
    EXPECT_GE(pairs, edges);  // a bound: never fewer
    EXPECT_LE(pairs, edges + 1);
    EXPECT_NEAR(votes.evidence[static_cast<std::size_t>(bin)], static_cast<double>(pairs), 1e-6);
  }
}

TEST(ScaleVotes, BoundTheEvidenceOfEachBinsGraphWhereWeightsGrowWithTheScale) {
  testing::RandomGeometry random(3);
  const Index n = 120;
  Correspondences c{random.in_cube(n), random.in_cube(n, 1.0), Eigen::ArrayXd::Constant(n, 0.03)};
  c.source.col(5) = c.source.col(4);  // agrees over many bins
  const auto arrays = consistency_arrays(c, 50);
  const ScaleBins bins({0.05, 50}, 1.05);
  ASSERT_GT(bins.num_runs(), 3);
  const auto weight = [&](Index i, Index run) {
    return (1.0 + static_cast<double>(run)) / static_cast<double>(bins.num_runs() + i % 3);
  };
  const ScaleVotes votes = count_scale_votes(arrays, bins, weight, 1);
  for (Index bin = 0; bin < bins.size(); ++bin) {
    const BitsetGraph graph = consistency_graph(arrays, bins[bin], 1);
    double evidence = 0, most = 0;
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < i; ++j) {
        const double both = weight(i, bins.run_of(bin)) * weight(j, bins.run_of(bin));
        if (graph.has_edge(i, j)) evidence += both;
        most = std::max(most, both);
      }
    }
    // never less, and no more than a pair that only touches the bin adds
    EXPECT_GE(votes.evidence[static_cast<std::size_t>(bin)], evidence - 1e-9) << bin;
    EXPECT_LE(votes.evidence[static_cast<std::size_t>(bin)], evidence + most + 1e-9) << bin;
  }
}

TEST(BinnedPairs, GiveTheGraphOfEachBin) {
  testing::RandomGeometry random(4);
  const Index n = 120;
  const Correspondences c{random.in_cube(n), random.in_cube(n, 1.0),
                          Eigen::ArrayXd::Constant(n, 0.02)};
  const auto arrays = consistency_arrays(c, 20);
  const ScaleBins bins({0.05, 20}, 1.2);
  const ScaleVotes votes = count_scale_votes(
      arrays, bins, [](Index, Index) { return 1.0; }, 1);
  const auto binned = BinnedPairs::make(arrays, bins, votes, std::size_t{1} << 24);
  ASSERT_TRUE(binned);
  for (Index bin = 0; bin < bins.size(); ++bin) {
    const BitsetGraph listed = binned->graph(bin);
    const BitsetGraph all = consistency_graph(arrays, bins[bin], 1);
    EXPECT_EQ(listed.num_edges(), votes.pairs[static_cast<std::size_t>(bin)]);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) EXPECT_LE(all.has_edge(i, j), listed.has_edge(i, j));
    }
  }
}

TEST(BinnedPairs, AreNotMadeWhereTheyDoNotFit) {
  const Correspondences c{Points::Zero(3, 3), Points::Zero(3, 3), Eigen::ArrayXd::Ones(3)};
  const auto arrays = consistency_arrays(c, 2);
  const ScaleBins bins({1, 1}, 1.1);
  const ScaleVotes votes = count_scale_votes(
      arrays, bins, [](Index, Index) { return 1.0; }, 1);
  EXPECT_EQ(votes.pairs[0], 3);
  EXPECT_TRUE(BinnedPairs::make(arrays, bins, votes, 24));
  EXPECT_FALSE(BinnedPairs::make(arrays, bins, votes, 23));
}

TEST(ScaleVotes, WeighAPairByBothWeights) {
  Correspondences c{Points::Zero(3, 2), Points::Zero(3, 2), Eigen::ArrayXd::Constant(2, 1e-3)};
  c.source(0, 1) = 1;
  c.target(0, 1) = 2;
  const ScaleBins bins({1, 4}, 1.1);
  const ScaleVotes votes = count_scale_votes(
      consistency_arrays(c, 4), bins, [](Index i, Index) { return i == 0 ? 0.5 : 0.25; }, 1);
  double most = 0;
  for (const double evidence : votes.evidence) most = std::max(most, evidence);
  EXPECT_DOUBLE_EQ(most, 0.125);
}

TEST(ScaleVotes, AreTheSameForAnyNumberOfThreads) {
  testing::RandomGeometry random(3);
  const Index n = 300;
  const Correspondences c{random.in_cube(n), random.in_cube(n), Eigen::ArrayXd::Constant(n, 0.05)};
  const auto arrays = consistency_arrays(c, 50);
  const ScaleBins bins({0.05, 50}, 1.02);
  const auto weight = [](Index i, Index) { return 1.0 / static_cast<double>(i + 1); };
  const ScaleVotes one = count_scale_votes(arrays, bins, weight, 1);
  const ScaleVotes four = count_scale_votes(arrays, bins, weight, 4);
  EXPECT_EQ(one.pairs, four.pairs);
  EXPECT_EQ(one.evidence, four.evidence);
}

}  // namespace
}  // namespace gmcr
