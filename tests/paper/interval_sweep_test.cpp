#include "paper/interval_sweep.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "gmcr/clique.hpp"

namespace gmcr::paper {
namespace {

/// The deepest point is a lower end of some interval.
Index depth_by_trying_every_start(const Eigen::ArrayXd& lower, const Eigen::ArrayXd& upper) {
  Index deepest = 0;
  for (const double point : lower) {
    deepest = std::max<Index>(deepest, ((lower <= point) && (point <= upper)).count());
  }
  return deepest;
}

RC_GTEST_PROP(DeepestPoint, AgreesWithTheQuadraticSweepAndTheCliqueOfTheScaleGraph, ()) {
  // ends on a coarse grid, so that ties and touching intervals are common
  const auto count = *rc::gen::inRange<Index>(0, 40);
  Eigen::ArrayXd lower(count), upper(count);
  for (Index k = 0; k < count; ++k) {
    lower[k] = *rc::gen::inRange(0, 12);
    upper[k] = lower[k] + *rc::gen::inRange(-1, 5);
  }
  const DeepestPoint deepest = deepest_point(lower, upper);
  const auto depth = static_cast<Index>(deepest.members.size());
  RC_ASSERT(depth == depth_by_trying_every_start(lower, upper));
  for (const Index k : deepest.members) {
    RC_ASSERT(lower[k] <= deepest.lower && deepest.upper <= upper[k]);
  }
  // L2: the maximum clique of the paper's scale consensus graph
  BitsetGraph graph(count);
  Index non_empty = 0;
  for (Index k = 0; k < count; ++k) {
    if (lower[k] <= upper[k]) ++non_empty;
    for (Index l = k + 1; l < count; ++l) {
      const bool both = lower[k] <= upper[k] && lower[l] <= upper[l];
      if (both && lower[k] <= upper[l] && lower[l] <= upper[k]) graph.add_edge(k, l);
    }
  }
  RC_ASSERT(depth == (non_empty == 0 ? 0 : static_cast<Index>(max_clique(graph).vertices.size())));
}

TEST(DeepestPoint, OfTouchingIntervalsIsWhereTheyTouch) {
  const DeepestPoint deepest = deepest_point(Eigen::Array2d(0, 1), Eigen::Array2d(1, 2));
  EXPECT_EQ(deepest.members, (std::vector<Index>{0, 1}));
  EXPECT_EQ(deepest.lower, 1);
  EXPECT_EQ(deepest.upper, 1);
}

TEST(DeepestPoint, TiesGoToTheSmallestPoint) {
  EXPECT_EQ(deepest_point(Eigen::Array2d(5, 0), Eigen::Array2d(6, 1)).lower, 0);
}

TEST(DeepestPoint, CountsIntervalsWithoutEndsAndSkipsEmptyOnes) {
  const double inf = std::numeric_limits<double>::infinity();
  const DeepestPoint deepest =
      deepest_point(Eigen::Array4d(-inf, 2, inf, -inf), Eigen::Array4d(inf, 3, -inf, 2.5));
  EXPECT_EQ(deepest.members, (std::vector<Index>{0, 1, 3}));
}

TEST(DeepestPoint, OfNoIntervalsHasNoMembers) {
  EXPECT_TRUE(deepest_point(Eigen::ArrayXd(0), Eigen::ArrayXd(0)).members.empty());
}

}  // namespace
}  // namespace gmcr::paper
