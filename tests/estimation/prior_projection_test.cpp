#include "estimation/fits/prior_projection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "estimation/fits/constrained_fit.hpp"
#include "geometry/angles.hpp"
#include "gmcr/metrics.hpp"
#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

using Eigen::Vector3d;

Eigen::Matrix3d about(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Eigen::Matrix3d random_covariance(testing::RandomGeometry& random) {
  return random.in_cube(3) * random.in_cube(3);
}

/// Priors that some rotation satisfies, at their limits in some of the cases.
Priors satisfiable(testing::RandomGeometry& random) {
  const double angles[] = {0, 1e-9, 1e-5, 0.02, 0.5, 3};
  const Eigen::Matrix3d rotation = random.rotation();
  const auto part = [&] { return random.index(2) == 0 ? 1.0 : random.uniform(0, 1); };
  Priors priors;
  const Index kinds = random.index(3);
  if (kinds != 1) {
    const double tilt = angles[random.index(6)];
    const Vector3d source = random.unit(), image = rotation * source;
    priors.gravity =
        GravityPrior{source, about(image.unitOrthogonal(), part() * tilt) * image, tilt};
  }
  if (kinds != 0) {
    const double turn = angles[random.index(6)];
    priors.initial_pose =
        InitialPose{{1, about(random.unit(), part() * turn) * rotation, {0, 0, 0}}, turn};
  }
  return priors;
}

TEST(AdmittedRotation, ExistsAndIsAdmittedWhereverTheAreSatisfiable) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const Priors priors = satisfiable(random);
    Eigen::Matrix3d covariance = random_covariance(random);
    if (trial % 5 == 0) covariance = random.unit() * random.unit().transpose();
    if (trial % 7 == 0) covariance.setZero();
    const auto rotation = admitted_rotation(covariance, priors);
    ASSERT_TRUE(rotation) << trial;
    EXPECT_TRUE(priors.admit({1, *rotation, {0, 0, 0}})) << trial;
    EXPECT_LT((rotation->transpose() * *rotation - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(rotation->determinant(), 1, 1e-12);
  }
}

TEST(AdmittedRotation, OfAKnownAxisIsTheBestOfAllYaws) {
  testing::RandomGeometry random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d source = random.unit(), target = random.unit();
    const Eigen::Matrix3d covariance = random_covariance(random);
    Priors priors;
    priors.gravity = GravityPrior{source, target, 0};
    const auto rotation = admitted_rotation(covariance, priors);
    ASSERT_TRUE(rotation);
    const double fit = rotation->cwiseProduct(covariance).sum();
    for (int step = 0; step < 360; ++step) {
      const Eigen::Matrix3d other = about(target, step * std::numbers::pi / 180) * *rotation;
      EXPECT_GE(fit, other.cwiseProduct(covariance).sum() - 1e-12);
    }
  }
}

TEST(AdmittedRotation, OfPointsOnALineUsesWhatIsKnown) {
  testing::RandomGeometry random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix3d truth = random.rotation();
    const Vector3d line = random.unit(), up = random.unit();
    Priors priors;
    priors.gravity = GravityPrior{up, truth * up, 0.01};
    const auto rotation = admitted_rotation(truth * line * line.transpose(), priors);
    ASSERT_TRUE(rotation);
    EXPECT_LT(geometry::angle_between(*rotation * line, truth * line), 1e-6);
  }
}

TEST(AdmittedRotation, OfContradictionsIsNone) {
  Priors priors;
  priors.gravity = GravityPrior{Vector3d::UnitZ(), Vector3d::UnitZ(), 0.1};
  priors.initial_pose = InitialPose{{1, about(Vector3d::UnitX(), 1), {0, 0, 0}}, 0.85};
  EXPECT_FALSE(admitted_rotation(Eigen::Matrix3d::Identity(), priors));
  priors.initial_pose->max_rotation = 0.95;
  EXPECT_TRUE(admitted_rotation(Eigen::Matrix3d::Identity(), priors));
}

TEST(AdmittedTranslation, IsTheNearestOfBothBalls) {
  testing::RandomGeometry random(4);
  int corners = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Priors priors;
    priors.max_translation = random.uniform(0.2, 1);
    InitialPose initial;
    initial.target_from_source.translation = random.uniform(0, 1) * random.unit();
    initial.max_rotation = 3;
    initial.max_translation = random.uniform(0.2, 1);
    priors.initial_pose = initial;
    const Vector3d& centre = initial.target_from_source.translation;
    const Vector3d wanted = random.uniform(0, 3) * random.unit();
    const auto admitted = admitted_translation(wanted, priors);
    ASSERT_EQ(admitted.has_value(),
              centre.norm() <= priors.max_translation + initial.max_translation);
    if (!admitted) continue;
    EXPECT_TRUE(priors.admit({1, Eigen::Matrix3d::Identity(), *admitted}));
    corners += std::abs(admitted->norm() - priors.max_translation) < 1e-9 &&
               std::abs((*admitted - centre).norm() - initial.max_translation) < 1e-9;
    // nothing near it is admitted and nearer
    for (int other = 0; other < 100; ++other) {
      const Vector3d near = *admitted + random.uniform(0, 0.2) * random.unit();
      if (!priors.admit({1, Eigen::Matrix3d::Identity(), near})) continue;
      EXPECT_GE((near - wanted).norm(), (*admitted - wanted).norm() - 1e-9);
    }
  }
  EXPECT_GT(corners, 10);
}

TEST(FitPose, RecoversAPoseAtTheLimitsOfItsPriors) {
  testing::RandomGeometry random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Similarity truth = random.similarity(0.5, 2, 3);
    const Points source = random.in_cube(8);
    const Points target = truth.apply(source);
    std::vector<Index> all(8);
    std::iota(all.begin(), all.end(), Index{0});
    PoseConstraints constraints{{0.1, 10}};
    const Vector3d up = random.unit(), image = truth.rotation * up;
    constraints.priors.gravity = GravityPrior{up, about(image.unitOrthogonal(), 0.1) * image, 0.1};
    constraints.priors.initial_pose = InitialPose{
        {1, about(random.unit(), 0.2) * truth.rotation, truth.translation + 0.1 * random.unit()},
        0.2,
        0.1};
    constraints.priors.max_translation = truth.translation.norm();
    const auto fit = fit_pose(source, target, Eigen::ArrayXd::Ones(8), all, constraints);
    ASSERT_TRUE(fit);
    EXPECT_TRUE(constraints.priors.admit(*fit));
    EXPECT_LT(mean_point_error(*fit, truth, source), 1e-6);
  }
}

TEST(FitPose, OfAPriorThatBindsIsAdmittedAndBeatsASimpleShift) {
  testing::RandomGeometry random(6);
  for (int trial = 0; trial < 50; ++trial) {
    const Similarity truth = random.similarity(1, 1, 1);
    const Points source = random.in_cube(20);
    Points target = truth.apply(source);
    for (Index i = 0; i < 20; ++i) target.col(i) += random.in_ball(0.01);
    std::vector<Index> all(20);
    std::iota(all.begin(), all.end(), Index{0});
    // the caller's origin is 200 m from the points, and its image is known to a millimetre
    PoseConstraints constraints{{1, 1}};
    constraints.source_origin = Vector3d(200, 0, 0);
    Similarity between_callers = truth;
    between_callers.translation -= truth.rotation * constraints.source_origin;
    constraints.priors.initial_pose = InitialPose{between_callers, 3, 0.001};
    const Eigen::ArrayXd bounds = Eigen::ArrayXd::Ones(20);
    const auto fit = fit_pose(source, target, bounds, all, constraints);
    ASSERT_TRUE(fit);
    Similarity in_callers = *fit;
    in_callers.translation -= fit->rotation * constraints.source_origin;
    EXPECT_TRUE(constraints.priors.admit(in_callers));
    EXPECT_LT(mean_point_error(*fit, truth, source), 0.01);
  }
}

}  // namespace
}  // namespace gmcr::estimation
