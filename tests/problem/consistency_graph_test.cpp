#include "problem/graph/consistency_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "random_geometry.hpp"

namespace gmcr::problem {
namespace {

Correspondences random_correspondences(testing::RandomGeometry& random, Index count) {
  Correspondences c{random.in_cube(count), random.in_cube(count, 1.0), Eigen::ArrayXd(count)};
  for (double& bound : c.bounds) bound = random.uniform(0.02, 0.3);
  return c;
}

bool agree(const Correspondences& c, Index i, Index j, double scale_min, double scale_max) {
  const double a = (c.source.col(j) - c.source.col(i)).norm();
  const double b = (c.target.col(j) - c.target.col(i)).norm();
  const double e = c.bounds[i] + c.bounds[j];
  return b - e <= scale_max * a && b + e >= scale_min * a;
}

TEST(ConsistencyGraph, HasTheEdgesOfL1AtEverySizeAroundAWord) {
  testing::RandomGeometry random(1);
  for (const Index count : {0, 1, 2, 63, 64, 65, 130}) {
    const Correspondences c = random_correspondences(random, count);
    for (const ScaleRange scales : {ScaleRange{1, 1}, ScaleRange{1.5, 1.6}, ScaleRange{0.1, 9}}) {
      const BitsetGraph graph = consistency_graph(consistency_arrays(c, scales.max), scales, 1);
      for (Index i = 0; i < count; ++i) {
        EXPECT_FALSE(graph.has_edge(i, i));
        for (Index j = 0; j < count; ++j) {
          if (i == j) continue;
          EXPECT_EQ(graph.has_edge(i, j), agree(c, i, j, scales.min, scales.max)) << i << ' ' << j;
        }
      }
    }
  }
}

TEST(ConsistencyGraph, JoinsAllInliersOfOnePose) {
  // L5: also with residuals of exactly the bound, far from the origin
  testing::RandomGeometry random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Similarity truth = random.similarity(0.5, 2, 1e6);
    const Points source = random.in_cube(40).colwise() + 1e6 * random.unit();
    Points target = truth.apply(source);
    for (Index i = 0; i < 40; ++i) target.col(i) += 0.01 * random.unit();
    Correspondences c = centre(source, target, Eigen::ArrayXd::Constant(40, 0.01));
    const BitsetGraph graph =
        consistency_graph(consistency_arrays(c, truth.scale), {truth.scale, truth.scale}, 1);
    EXPECT_EQ(graph.num_edges(), 40 * 39 / 2);
  }
}

TEST(ConsistencyGraph, GrowsWithTheRangeOfScales) {
  testing::RandomGeometry random(3);
  const Correspondences c = random_correspondences(random, 60);
  const auto arrays = consistency_arrays(c, 3);
  const BitsetGraph narrow = consistency_graph(arrays, {1, 1.1}, 1);
  const BitsetGraph wide = consistency_graph(arrays, {0.9, 3}, 1);
  EXPECT_LT(narrow.num_edges(), wide.num_edges());
  for (Index i = 0; i < 60; ++i) {
    for (Index j = 0; j < 60; ++j) EXPECT_LE(narrow.has_edge(i, j), wide.has_edge(i, j));
  }
}

TEST(ConsistencyGraph, IsTheSameForAnyNumberOfThreads) {
  testing::RandomGeometry random(4);
  const auto arrays = consistency_arrays(random_correspondences(random, 300), 1);
  const BitsetGraph one = consistency_graph(arrays, {1, 1}, 1);
  const BitsetGraph four = consistency_graph(arrays, {1, 1}, 4);
  for (Index i = 0; i < 300; ++i) {
    const auto a = one.row(i), b = four.row(i);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin()));
  }
}

TEST(ConsistencyGraph, LacksEdgesWhereItsTimeIsUp) {
  testing::RandomGeometry random(6);
  const auto arrays = consistency_arrays(random_correspondences(random, 700), 1);
  EXPECT_GT(consistency_graph(arrays, {1, 1}, 2).num_edges(), 0);
  EXPECT_EQ(consistency_graph(arrays, {1, 1}, 2, parallel::Deadline(0)).num_edges(), 0);
}

}  // namespace
}  // namespace gmcr::problem
