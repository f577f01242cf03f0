#include "paper/translation_consensus.hpp"

#include <gtest/gtest.h>

#include "random_geometry.hpp"

namespace gmcr::paper {
namespace {

TEST(TranslationGraph, JoinsMeasurementsWhoseBallsMeet) {
  testing::RandomGeometry random(1);
  const Points measurements = random.in_cube(70);
  Eigen::ArrayXd bounds(70);
  for (double& bound : bounds) bound = random.uniform(0.05, 0.3);
  const BitsetGraph graph = translation_graph(measurements, bounds, 2);
  for (Index i = 0; i < 70; ++i) {
    for (Index j = 0; j < 70; ++j) {
      const double distance = (measurements.col(i) - measurements.col(j)).norm();
      EXPECT_EQ(graph.has_edge(i, j), i != j && distance <= bounds[i] + bounds[j]);
    }
  }
}

}  // namespace
}  // namespace gmcr::paper
