#include "search/scales/binned_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "problem/graph/consistency_graph.hpp"
#include "random_geometry.hpp"

namespace gmcr::search {
namespace {

constexpr std::size_t kManyBytes = std::size_t{1} << 30;

struct Problem {
  geometry::CorrespondenceArrays arrays;
  ScaleBins bins{{0.05, 20}, 1.2};
  ScaleVotes votes;

  explicit Problem(Index n, double bound = 0.02) {
    testing::RandomGeometry random(4);
    const Points source = random.in_cube(n), target = random.in_cube(n, 1.0);
    arrays = problem::consistency_arrays({source, target, Eigen::ArrayXd::Constant(n, bound)}, 20);
    votes = count_scale_votes(arrays, bins, BinGroupWeights(n), kManyBytes, 1);
  }

  BinnedPairs list(const std::vector<Index>& wanted, int num_threads = 1) const {
    return {arrays, bins, votes, wanted, num_threads};
  }
  BitsetGraph graph(const BinnedPairs& listed, Index bin, int num_threads = 1) const {
    return listed.graph(arrays, bin, bins[bin], num_threads);
  }
};

void expect_equal(const BitsetGraph& a, const BitsetGraph& b) {
  ASSERT_EQ(a.num_vertices(), b.num_vertices());
  for (Index v = 0; v < a.num_vertices(); ++v) {
    EXPECT_TRUE(std::equal(a.row(v).begin(), a.row(v).end(), b.row(v).begin())) << v;
  }
}

TEST(BinnedPairs, GiveTheGraphOfEachBin) {
  for (const Index n : {3, 63, 64, 65, 130}) {
    const Problem problem(n);
    std::vector<Index> all(static_cast<std::size_t>(problem.bins.size()));
    std::iota(all.begin(), all.end(), Index{0});
    const BinnedPairs pairs = problem.list(all);
    for (const Index bin : all) {
      ASSERT_TRUE(pairs.contains(bin));
      const BitsetGraph listed = problem.graph(pairs, bin);
      const BitsetGraph from_all = problem::consistency_graph(problem.arrays, problem.bins[bin], 1);
      EXPECT_EQ(listed.num_edges(), problem.votes.pairs[static_cast<std::size_t>(bin)]);
      for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
          EXPECT_LE(from_all.has_edge(i, j), listed.has_edge(i, j));
          EXPECT_EQ(listed.has_edge(i, j), listed.has_edge(j, i));
        }
      }
    }
  }
}

TEST(BinnedPairs, GiveTheGraphOfAPartOfABin) {
  const Problem problem(130);
  const Index bin = 12;
  const ScaleRange whole = problem.bins[bin];
  const ScaleRange part{whole.min * 1.05, whole.min * 1.06};
  const BinnedPairs pairs = problem.list({bin});
  expect_equal(pairs.graph(problem.arrays, bin, part, 1),
               problem::consistency_graph(problem.arrays, part, 1));
}

TEST(BinnedPairs, ListTheBinsWantedAndNoOthers) {
  const Problem problem(100);
  const BinnedPairs both = problem.list({14, 3});
  EXPECT_TRUE(both.contains(14) && both.contains(3));
  EXPECT_FALSE(both.contains(10) || both.contains(2) || both.contains(4));
  expect_equal(problem.graph(both, 14), problem.graph(problem.list({14}), 14));
}

TEST(BinnedPairs, FitIntoFourBytesAPair) {
  const Problem problem(100);
  const std::vector<Index>& counts = problem.votes.pairs;
  const std::vector<Index> wanted{14, 3, 10};
  const auto bytes = 4 * static_cast<std::size_t>(counts[14] + counts[3]);
  ASSERT_GT(counts[3], 0);
  ASSERT_GT(counts[10], 0);
  EXPECT_EQ(BinnedPairs::num_that_fit(problem.votes, wanted, kManyBytes), 3u);
  EXPECT_EQ(BinnedPairs::num_that_fit(problem.votes, wanted, bytes), 2u);
  EXPECT_EQ(BinnedPairs::num_that_fit(problem.votes, wanted, bytes - 1), 1u);
  ScaleVotes late = problem.votes;
  late.pairs_of_chunks.clear();
  EXPECT_EQ(BinnedPairs::num_that_fit(late, wanted, kManyBytes), 0u);
}

TEST(BinnedPairs, AreTheSameForAnyNumberOfThreads) {
  const Problem problem(700, 0.5);  // large enough for threads in all steps
  const std::vector<Index>& counts = problem.votes.pairs;
  const Index bin = std::max_element(counts.begin(), counts.end()) - counts.begin();
  ASSERT_GT(counts[static_cast<std::size_t>(bin)], 100'000);
  const std::vector<Index> wanted{bin, bin - 1};
  const BinnedPairs one = problem.list(wanted), four = problem.list(wanted, 4);
  expect_equal(problem.graph(one, bin), problem.graph(four, bin, 4));
}

TEST(BinnedPairs, ListNoneWhereTimeIsUp) {
  const Problem problem(50);
  const std::vector<Index> wanted{3};
  const BinnedPairs late(problem.arrays, problem.bins, problem.votes, wanted, 1,
                         parallel::Deadline(0));
  EXPECT_FALSE(late.contains(3));
  EXPECT_FALSE(BinnedPairs().contains(3));
}

}  // namespace
}  // namespace gmcr::search
