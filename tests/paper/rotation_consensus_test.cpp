#include "paper/rotation_consensus.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "random_geometry.hpp"

namespace gmcr::paper {
namespace {

Tims tims_of(const Points& source, const Points& target, double bound) {
  Tims tims;
  tims.pairs.resize(static_cast<std::size_t>(source.cols()));
  tims.source = source;
  tims.target = target;
  tims.bounds = Eigen::ArrayXd::Constant(source.cols(), bound);
  return tims;
}

double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool admits(const Tims& tims, Index k, double scale, const Eigen::Matrix3d& rotation) {
  return (tims.target.col(k) - scale * rotation * tims.source.col(k)).norm() <= tims.bounds[k];
}

TEST(RotationCones, AdmitARotationIffItMovesTheVectorIntoItsCone) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double scale = random.uniform(0.5, 2);
    const Tims tims = tims_of(random.in_cube(1), random.in_cube(1), random.uniform(0.01, 1.5));
    const Eigen::Matrix3d rotation = random.rotation();
    const RotationCones cones = rotation_cones(tims, scale);
    const bool in_cone =
        !cones.tims.empty() &&
        angle(rotation * tims.source.col(0), tims.target.col(0)) <=
            std::atan2(cones.directions.sin_gamma[0], cones.directions.cos_gamma[0]) + 1e-9;
    EXPECT_EQ(in_cone, admits(tims, 0, scale, rotation));
  }
}

TEST(RotationCones, LeaveOutATimWhoseLengthsDisagree) {
  Points source(3, 3), target(3, 3);
  source << 1, 1, 1, 0, 0, 0, 0, 0, 0;
  target << 0, 0, 0, 1.05, 2, 0.9, 0, 0, 0;
  EXPECT_EQ(rotation_cones(tims_of(source, target, 0.1), 1).tims, (std::vector<Index>{0, 2}));
}

TEST(RotationCones, OfAVectorWithinItsBoundSayNothing) {
  const RotationCones cones =
      rotation_cones(tims_of(Points::Zero(3, 1), Points::Constant(3, 1, 0.01), 1), 1);
  EXPECT_EQ(cones.directions.cos_gamma[0], -1);
}

TEST(RotationCones, OfCopiesAreAtLeastSixtyDegreesAtEveryScaleBelow) {
  // L6: |bbar| <= eps and s |abar| <= eps
  testing::RandomGeometry random(5);
  double widest = -1;
  for (int trial = 0; trial < 2000; ++trial) {
    const Tims tims = tims_of(random.unit() * random.uniform(0.01, 1),
                              random.unit() * random.uniform(0.01, 1), 1);
    for (const double scale : {1.0, 0.5, 1e-3}) {
      const RotationCones cones = rotation_cones(tims, scale);
      ASSERT_EQ(cones.tims.size(), 1u);
      widest = std::max(widest, cones.directions.cos_gamma[0]);
    }
  }
  EXPECT_LE(widest, 0.5);
  EXPECT_GT(widest, 0.4);
}

/// Smallest excess of the two cones' conditions over a fine search of rotations; <= 0: they share
/// one.
double least_excess(const Tims& tims, const Eigen::Array2d& gamma) {
  // any rotation of the first vector into its cone, then any turn about its image
  const Eigen::Vector3d a0 = tims.source.col(0).normalized(), b0 = tims.target.col(0).normalized();
  const Eigen::Vector3d a1 = tims.source.col(1).normalized(), b1 = tims.target.col(1).normalized();
  double least = 10;
  constexpr int kTilts = 12, kTurns = 90;
  const Eigen::Matrix3d align = Eigen::Quaterniond::FromTwoVectors(a0, b0).toRotationMatrix();
  for (int tilt = 0; tilt <= kTilts; ++tilt) {
    for (int direction = 0; direction < kTurns; ++direction) {
      const double phi = 2 * std::numbers::pi * direction / kTurns;
      const Eigen::Vector3d axis = Eigen::AngleAxisd(phi, b0) * b0.unitOrthogonal();
      const Eigen::AngleAxisd lean(gamma[0] * tilt / kTilts, axis);
      for (int turn = 0; turn < kTurns; ++turn) {
        const double psi = 2 * std::numbers::pi * turn / kTurns;
        const Eigen::Vector3d image = lean * (Eigen::AngleAxisd(psi, b0) * (align * a1));
        least = std::min(least, angle(image, b1) - gamma[1]);
      }
    }
  }
  return least;
}

TEST(RotationGraph, JoinsTwoTimsIffSomeRotationSuitsBoth) {
  // L3 against a search over rotations; pairs within the search's resolution of the border are
  // skipped
  testing::RandomGeometry random(2);
  int joined = 0, apart = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Points source(3, 2), target(3, 2);
    for (Index k = 0; k < 2; ++k) {
      source.col(k) = random.unit();
      target.col(k) = random.unit();
    }
    const Tims tims = tims_of(source, target, random.uniform(0.05, 0.6));
    const RotationCones cones = rotation_cones(tims, 1);
    ASSERT_EQ(cones.tims.size(), 2u);
    const Eigen::Array2d gamma(cones.directions.cos_gamma[0], cones.directions.cos_gamma[1]);
    const double excess = least_excess(tims, gamma.acos());
    if (std::abs(excess) < 0.08) continue;
    const bool edge = rotation_graph(cones, 1).has_edge(0, 1);
    EXPECT_EQ(edge, excess < 0);
    (edge ? joined : apart) += 1;
  }
  EXPECT_GT(joined, 5);
  EXPECT_GT(apart, 5);
}

TEST(RotationGraph, IsL3ForAnyGammas) {
  testing::RandomGeometry random(3);
  kernels::DirectionArrays directions;
  const Index count = 130;
  directions.source.resize(count, 3);
  directions.target.resize(count, 3);
  Eigen::ArrayXd gamma(count);
  for (Index k = 0; k < count; ++k) {
    directions.source.row(k) = random.unit().transpose();
    directions.target.row(k) = random.unit().transpose();
    gamma[k] = k % 10 == 0 ? std::numbers::pi * static_cast<double>(k % 3) / 2
                           : random.uniform(0, std::numbers::pi);
  }
  directions.cos_gamma = gamma.cos();
  directions.sin_gamma = gamma.sin();
  std::vector<Index> tims(static_cast<std::size_t>(count));
  std::iota(tims.begin(), tims.end(), Index{0});
  const BitsetGraph graph = rotation_graph({tims, directions}, 2);
  for (Index k = 0; k < count; ++k) {
    EXPECT_FALSE(graph.has_edge(k, k));
    for (Index l = 0; l < count; ++l) {
      if (k == l) continue;
      const double difference = std::abs(angle(directions.source.row(k), directions.source.row(l)) -
                                         angle(directions.target.row(k), directions.target.row(l)));
      const double room = gamma[k] + gamma[l] - difference;
      if (std::abs(room) > 1e-6) {
        EXPECT_EQ(graph.has_edge(k, l), room > 0) << k << ' ' << l;
      }
      EXPECT_EQ(graph.has_edge(k, l), graph.has_edge(l, k));
    }
  }
}

TEST(RotationGraph, IsCompleteOverTheTimsOfOneRotation) {
  testing::RandomGeometry random(4);
  const Eigen::Matrix3d truth = random.rotation();
  const Points source = random.in_cube(50);
  Points target = truth * source;
  for (Index k = 0; k < 50; ++k) target.col(k) += random.in_ball(1e-4);
  const BitsetGraph graph = rotation_graph(rotation_cones(tims_of(source, target, 1e-4), 1), 1);
  EXPECT_EQ(graph.num_edges(), 50 * 49 / 2);
}

}  // namespace
}  // namespace gmcr::paper
