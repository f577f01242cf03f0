#include "frontend/matching/match_priors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "frontend/matching/feature_matching.hpp"
#include "frontend/shapes.hpp"

namespace gmcr::frontend {
namespace {

using Eigen::Vector3d;
using testing::random_points;
using testing::some_motion;

constexpr double kBound = 0.05;
constexpr Index kCount = 60;

Points unit_normals(Index count, unsigned seed) {
  Points normals = random_points(count, seed);
  normals.colwise().normalize();
  return normals;
}

Eigen::Matrix3d turn_of(double angle, unsigned seed) {
  return Eigen::AngleAxisd(angle, unit_normals(1, seed).col(0)).toRotationMatrix();
}

/// Options with priors, and a pose at the edge of what they admit.
struct Case {
  std::string name;
  Options options;
  Similarity pose;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (unsigned seed = 0; seed < 8; ++seed) {
    Case near{"initial pose", {}, some_motion()};
    near.options.initial_pose = InitialPose{some_motion(), 0.3, 0.4};
    near.pose.rotation = turn_of(0.299, seed) * near.pose.rotation;
    near.pose.translation += 0.399 * unit_normals(1, seed + 50).col(0);
    all.push_back(near);

    Case turned = near;
    turned.name = "rotation alone";
    turned.options.initial_pose->max_translation = std::numeric_limits<double>::infinity();
    turned.pose.translation *= 9;
    all.push_back(turned);

    Case scaled = near;
    scaled.name = "initial pose and a range of scales";
    scaled.options.scale_mode = ScaleMode::Estimated;
    scaled.options.scale_range = ScaleRange{0.5, 2};
    scaled.pose.scale = seed % 2 == 0 ? 0.5 : 2;
    all.push_back(scaled);

    Case any_scale = scaled;
    any_scale.name = "initial pose and any scale";
    any_scale.options.scale_range.reset();
    any_scale.pose.scale = 3;
    all.push_back(any_scale);

    Case level{"gravity", {}, {}};
    level.options.gravity = GravityPrior{Vector3d(0, 0, -2), Vector3d(0, -1, 0), 0.1};
    level.pose.rotation =
        turn_of(0.099, seed) *
        Eigen::Quaterniond::FromTwoVectors(Vector3d(0, 0, -1), Vector3d(0, -1, 0)) *
        Eigen::AngleAxisd(seed, Vector3d::UnitZ());
    level.pose.translation = {9, 9, 9};
    all.push_back(level);

    Case bounded = level;
    bounded.name = "gravity and a longest translation";
    bounded.options.max_translation = 2;
    bounded.pose.translation = 1.99 * unit_normals(1, seed + 70).col(0);
    all.push_back(bounded);
  }
  return all;
}

TEST(MatchPriors, LetEachPointMatchItsImageUnderEveryAdmittedPose) {
  for (const Case& given : cases()) {
    ASSERT_TRUE(given.options.admit(given.pose)) << given.name;
    const Points source = random_points(kCount, 1), normals = unit_normals(kCount, 2);
    const Points off = 0.99 * kBound * unit_normals(kCount, 3);
    const Points target = given.pose.apply(source) + off;
    const Points turned = turn_of(0.5, 4) * given.pose.rotation * normals;  // normals are noisy
    const MatchPriors priors({source, normals}, {target, turned}, given.options, kBound);
    for (Index i = 0; i < kCount; ++i) {
      const std::vector<Index> partners = priors.partners_of(i);
      EXPECT_TRUE(std::is_sorted(partners.begin(), partners.end()));
      EXPECT_TRUE(std::binary_search(partners.begin(), partners.end(), i)) << given.name;
    }
  }
}

TEST(MatchPriors, LeaveOutWhatNoAdmittedPoseBringsThere) {
  const Points source = random_points(kCount, 1), normals = unit_normals(kCount, 2);
  for (const Case& given : cases()) {
    const Points target = given.pose.apply(source);
    const Points turned = given.pose.rotation * normals;
    const MatchPriors priors({source, normals}, {target, turned}, given.options, kBound);
    Index num_partners = 0;
    for (Index i = 0; i < kCount; ++i) {
      num_partners += static_cast<Index>(priors.partners_of(i).size());
    }
    EXPECT_LT(num_partners, kCount * kCount * 7 / 10) << given.name;
  }
  // by hand: an image can be 0.4 + 0.05 + 2 sin(0.15) |p| away from where the prior puts it
  const Points p = Vector3d(1, 0, 0), up = Vector3d(0, 0, 1);
  Options options;
  options.initial_pose = InitialPose{{}, 0.3, 0.4};
  const auto count_at = [&](const Vector3d& q) {
    const Points target = q;
    return MatchPriors({p, up}, {target, up}, options, kBound).partners_of(0).size();
  };
  EXPECT_EQ(count_at({1.44, 0, 0}), 1u);
  EXPECT_EQ(count_at({1.46, 0, 0}), 0u);
  EXPECT_EQ(count_at({std::cos(0.3), std::sin(0.3) + 0.44, 0}), 1u);
  EXPECT_EQ(count_at({std::cos(0.3), std::sin(0.3) + 0.48, 0}), 0u);
}

TEST(MatchPriors, SaySomethingWhereTheyAreThere) {
  Options options;
  EXPECT_FALSE(MatchPriors::say_something(options));
  options.max_translation = 1;
  EXPECT_TRUE(MatchPriors::say_something(options));
}

TEST(FeatureMatching, WithPriorsThatAdmitAllIsTheSame) {
  Features source(kFpfhBins, kCount), target(kFpfhBins, kCount);
  std::mt19937 generator(7);
  std::uniform_real_distribution<float> value(0, 40);
  for (Features* features : {&source, &target}) {
    *features = Features::NullaryExpr(kFpfhBins, kCount, [&] { return value(generator); });
    features->col(3).setZero();
  }
  const Points a = random_points(kCount, 1), b = random_points(kCount, 2);
  const Points normals = unit_normals(kCount, 3);
  Options loose;
  loose.max_translation = 1e3;
  const MatchPriors priors({a, normals}, {b, normals}, loose, kBound);
  for (const bool mutual : {false, true}) {
    for (const float ratio : {0.9f, 1.0f}) {
      MatchingOptions options{mutual, ratio, 2};
      const auto free = match_features(source, target, options);
      options.priors = &priors;
      const auto bound = match_features(source, target, options);
      ASSERT_EQ(free.pairs.size(), bound.pairs.size());
      EXPECT_EQ(bound.share_compared, 1);
      for (std::size_t k = 0; k < free.pairs.size(); ++k) {
        EXPECT_EQ(free.pairs[k].source, bound.pairs[k].source);
        EXPECT_EQ(free.pairs[k].target, bound.pairs[k].target);
      }
    }
  }
}

TEST(FeatureMatching, WithPriorsIsTheNearestOfThoseTheyAdmit) {
  Features source(kFpfhBins, 1), target(kFpfhBins, 2);
  source.setConstant(10);
  target.col(0).setConstant(11);
  target.col(1).setConstant(17);
  const Points p = Vector3d(0, 0, 0), up = Vector3d(0, 0, 1);
  Points q(3, 2), ups(3, 2);
  q << 5, 0.1, 0, 0, 0, 0;
  ups << up, up;
  Options options;
  options.max_translation = 1;
  const MatchPriors priors({p, up}, {q, ups}, options, kBound);
  MatchingOptions matching;
  matching.priors = &priors;
  const auto found = match_features(source, target, matching);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_EQ(found.pairs[0].target, 1);
}

}  // namespace
}  // namespace gmcr::frontend
