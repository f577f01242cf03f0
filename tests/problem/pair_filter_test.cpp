#include "problem/graph/pair_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/pairs/consistency_row.hpp"
#include "problem/graph/consistency_graph.hpp"
#include "random_geometry.hpp"

namespace gmcr::problem {
namespace {

using Eigen::Vector3d;

Eigen::Matrix3d about(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Correspondences tight_correspondences(testing::RandomGeometry& random, Index count) {
  Correspondences c{random.in_cube(count), random.in_cube(count), Eigen::ArrayXd(count)};
  for (double& bound : c.bounds) bound = random.uniform(0.02, 0.1);
  return c;
}

GravityPrior upright(double max_tilt) { return {Vector3d::UnitZ(), Vector3d::UnitZ(), max_tilt}; }

/// A pose, priors that it satisfies, exactly at their limits in half of the cases, and inliers.
struct Admitted {
  Similarity pose;
  Priors priors;
  Points source, target;
  double bound = 0;
};

Admitted random_admitted(testing::RandomGeometry& random, double unit, double offset) {
  constexpr Index kCount = 30;
  const auto part = [&] { return random.index(2) == 0 ? 1.0 : random.uniform(0, 1); };
  const double angles[] = {0, 1e-7, 0.05, 0.8, 3};
  Admitted a;
  a.pose = random.similarity(0.5, 2, unit);
  a.bound = 0.02 * unit;
  const Vector3d up = random.unit();
  const Eigen::Matrix3d& rotation = a.pose.rotation;
  const double max_tilt = angles[random.index(5)], max_rotation = angles[random.index(5)];
  const Vector3d image = rotation * up;
  a.priors.gravity = GravityPrior{
      random.uniform(0.1, 9) * up,
      random.uniform(0.1, 9) * (about(image.unitOrthogonal(), part() * max_tilt) * image),
      max_tilt};
  InitialPose initial;
  initial.target_from_source.rotation = about(random.unit(), part() * max_rotation) * rotation;
  initial.max_rotation = max_rotation;
  initial.max_translation = random.uniform(0, 1) * unit;
  // along gravity the noise and the limits of the priors add up
  const bool aligned = random.index(2) == 0;
  const auto error_direction = [&]() -> Vector3d {
    if (!aligned) return random.unit();
    return (random.index(2) == 0 ? 1 : -1) * a.priors.gravity->target.normalized();
  };
  initial.target_from_source.translation =
      a.pose.translation + part() * initial.max_translation * error_direction();
  a.priors.initial_pose = initial;
  a.priors.max_translation = a.pose.translation.norm() / part();
  a.source = (unit * random.in_cube(kCount)).colwise() + offset * random.unit();
  a.target = a.pose.apply(a.source);
  for (Index i = 0; i < kCount; ++i) a.target.col(i) += part() * a.bound * error_direction();
  return a;
}

TEST(PairFilter, KeepsAllInliersOfEveryPoseThatThePriorsAdmit) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 600; ++trial) {
    const double unit = std::pow(10.0, 3 * static_cast<double>(random.index(3)) - 3);
    const Admitted a = random_admitted(random, unit, random.index(2) == 0 ? 0 : 1e6);
    EXPECT_TRUE(a.priors.admit(a.pose)) << trial;
    const double s = a.pose.scale;
    const ScaleRange scales = random.index(2) == 0 ? ScaleRange{s, s} : ScaleRange{0.9 * s, s};
    const Correspondences c =
        centre(a.source, a.target, Eigen::ArrayXd::Constant(a.source.cols(), a.bound));
    const PairFilter filter(c, a.priors, false, scales);
    BitsetGraph graph = consistency_graph(consistency_arrays(c, scales.max), scales, 1);
    filter.apply(graph, scales, 1);
    EXPECT_EQ(graph.num_edges(), 30 * 29 / 2) << trial;
    for (Index i = 0; i < c.size(); ++i) {
      EXPECT_TRUE(filter.admits(i, scales)) << trial;
      for (Index j = 0; j < i; ++j) EXPECT_TRUE(filter.admits_pair(i, j, scales)) << trial;
    }
  }
}

TEST(PairFilter, OfAKnownAxisComparesHeightsAndDistancesFromTheAxis) {
  testing::RandomGeometry random(2);
  const Correspondences c = tight_correspondences(random, 80);
  const PairFilter filter(c, Priors{upright(0), {}}, false, {1.2, 1.2});
  int admitted = 0;
  for (Index i = 0; i < c.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      const Vector3d a = 1.2 * (c.source.col(j) - c.source.col(i));
      const Vector3d b = c.target.col(j) - c.target.col(i);
      const double distance = std::hypot(b.z() - a.z(), b.head(2).norm() - a.head(2).norm());
      const bool expected = distance <= c.bounds[i] + c.bounds[j];
      EXPECT_EQ(filter.admits_pair(i, j, {1.2, 1.2}), expected);
      admitted += expected;
    }
  }
  EXPECT_GT(admitted, 50);
}

TEST(PairFilter, OfAnInitialPoseFindsTheNearestRotationAndScale) {
  testing::RandomGeometry random(3);
  const Correspondences c = tight_correspondences(random, 60);
  const ScaleRange scales{0.8, 1.1};
  Priors priors;
  priors.initial_pose = InitialPose{random.similarity(1, 1, 1), 0.7};
  const Eigen::Matrix3d& known = priors.initial_pose->target_from_source.rotation;
  const PairFilter filter(c, priors, false, scales);
  int admitted = 0;
  for (Index i = 0; i < c.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      const Vector3d a = known * (c.source.col(j) - c.source.col(i));
      const Vector3d b = c.target.col(j) - c.target.col(i);
      // the image of a, turned towards b as far as it may be, at each scale
      const double angle = std::acos(a.normalized().dot(b.normalized()));
      const Vector3d turned = about(a.cross(b).normalized(), std::min(angle, 0.7)) * a;
      double distance = 1e9;
      for (int step = 0; step <= 300; ++step) {
        distance = std::min(distance, (b - (0.8 + 0.001 * step) * turned).norm());
      }
      const double bound = c.bounds[i] + c.bounds[j];
      if (std::abs(distance - bound) < 1e-4) continue;
      EXPECT_EQ(filter.admits_pair(i, j, scales), distance < bound);
      admitted += distance < bound;
    }
  }
  EXPECT_GT(admitted, 50);
}

TEST(PairFilter, AdmitsMoreWhereTheTiltIsLarger) {
  testing::RandomGeometry random(4);
  const Correspondences c = tight_correspondences(random, 100);
  const BitsetGraph all = consistency_graph(consistency_arrays(c, 1), {1, 1}, 1);
  Index before = 0;
  for (const double tilt : {0.0, 0.1, 0.5, 2.0}) {
    BitsetGraph graph = all;
    PairFilter(c, Priors{upright(tilt), {}}, false, {1, 1}).apply(graph, {1, 1}, 1);
    EXPECT_GT(graph.num_edges(), before);
    before = graph.num_edges();
  }
  EXPECT_LT(before, all.num_edges());
}

TEST(PairFilter, WithoutLimitsIsL1) {
  testing::RandomGeometry random(5);
  const Correspondences c = tight_correspondences(random, 50);
  const auto arrays = consistency_arrays(c, 1.3);
  Priors free;
  free.gravity = upright(std::numbers::pi);
  free.initial_pose = InitialPose{Similarity{}, std::numbers::pi};
  for (const Priors& priors : {Priors{}, free}) {
    const PairFilter filter(c, priors, false, {1, 1.3});
    EXPECT_TRUE(filter.is_empty());
    for (Index i = 0; i < c.size(); ++i) {
      EXPECT_TRUE(filter.admits(i, {1, 1.3}));
      for (Index j = 0; j < i; ++j) {
        EXPECT_EQ(filter.admits_pair(i, j, {1, 1.3}), kernels::is_consistent(arrays, i, j, 1, 1.3));
      }
    }
  }
  // vectors at no angle: the prior has nothing to say beyond L1
  Correspondences same = c;
  same.target = 1.15 * c.source;
  Priors priors;
  priors.initial_pose = InitialPose{Similarity{}, 0.0};
  const PairFilter filter(same, priors, false, {1, 1});
  const auto same_arrays = consistency_arrays(same, 1);
  for (Index i = 0; i < c.size(); ++i) {
    for (Index j = 0; j < i; ++j) {
      EXPECT_EQ(filter.admits_pair(i, j, {1, 1}), kernels::is_consistent(same_arrays, i, j, 1, 1));
    }
  }
}

TEST(PairFilter, OfATranslationPriorRejectsWhatNoAdmittedPoseMapsThere) {
  // |b - R a| <= |t| + eps for some R iff | |b| - |a| | <= T + eps
  testing::RandomGeometry random(6);
  const Points source = random.in_cube(100, 3), target = random.in_cube(100, 3);
  const Correspondences c = centre(source, target, Eigen::ArrayXd::Constant(100, 0.1));
  Priors priors;
  priors.max_translation = 0.5;
  const PairFilter filter(c, priors, false, {1, 1});
  EXPECT_FALSE(filter.is_empty());
  int rejected = 0;
  for (Index i = 0; i < 100; ++i) {
    const bool expected = std::abs(source.col(i).norm() - target.col(i).norm()) <= 0.6;
    EXPECT_EQ(filter.admits(i, {1, 1}), expected);
    rejected += !expected;
  }
  EXPECT_GT(rejected, 20);
  // with the rotation known too: |b - a| <= T + eps
  priors.initial_pose = InitialPose{Similarity{}, 0.0};
  const PairFilter both(c, priors, false, {1, 1});
  for (Index i = 0; i < 100; ++i) {
    EXPECT_EQ(both.admits(i, {1, 1}), (source.col(i) - target.col(i)).norm() <= 0.6);
  }
}

TEST(PairFilter, OneToOneParsCorrespondencesThatShareAPoint) {
  testing::RandomGeometry random(7);
  const Similarity truth = random.similarity(1, 1, 1);
  Points source = random.in_cube(6);
  source.col(3) = source.col(1);
  Points target = truth.apply(source);
  target.col(3) += Vector3d(0.001, 0, 0);
  target.col(5) = target.col(2);
  const Correspondences c = centre(source, target, Eigen::ArrayXd::Constant(6, 5.0));
  const PairFilter filter(c, {}, true, {1, 1});
  EXPECT_FALSE(filter.is_empty());
  for (Index i = 0; i < 6; ++i) {
    for (Index j = 0; j < i; ++j) {
      const bool shared = (i == 3 && j == 1) || (i == 5 && j == 2);
      EXPECT_EQ(filter.admits_pair(i, j, {1, 1}), !shared);
      EXPECT_EQ(filter.admits_pair(j, i, {1, 1}), !shared);
    }
  }
  EXPECT_EQ(filter.one_to_one({0, 1, 2, 3, 4, 5}).size(), 4);
  EXPECT_EQ(filter.one_to_one({3, 4, 5}), (std::vector<Index>{3, 4, 5}));
  EXPECT_EQ(PairFilter(c, {}, false, {1, 1}).one_to_one({0, 1, 2, 3, 4, 5}).size(), 6);
}

TEST(PairFilter, LeavesExactlyTheAdmittedEdgesForAnyNumberOfThreads) {
  testing::RandomGeometry random(8);
  for (const Index count : {0, 1, 63, 64, 65, 130, 600}) {
    Correspondences c = tight_correspondences(random, count);
    for (Index i = 4; i < count; i += 5) c.source.col(i) = c.source.col(i - 3);
    const ScaleRange scales{0.9, 1.2};
    Priors priors{upright(0.1), {}};
    priors.initial_pose = InitialPose{Similarity{}, 2.0};
    const PairFilter filter(c, priors, true, scales);
    BitsetGraph one = consistency_graph(consistency_arrays(c, scales.max), scales, 1);
    BitsetGraph four = one;
    filter.apply(one, scales, 1);
    filter.apply(four, scales, 4);
    for (Index i = 0; i < count; ++i) {
      const auto a = one.row(i), b = four.row(i);
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin()));
      for (Index j = 0; j < count; ++j) {
        if (i == j) continue;
        ASSERT_EQ(one.has_edge(i, j), filter.admits_pair(i, j, scales));
      }
    }
  }
}

}  // namespace
}  // namespace gmcr::problem
