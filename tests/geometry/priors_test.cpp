#include "gmcr/priors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace gmcr::geometry {
namespace {

using Eigen::Vector3d;

GravityPrior upright(double max_tilt) {
  return {Vector3d(0, 0, 2), Vector3d(0, 0, 9.81), max_tilt};
}

TEST(Priors, AdmitWhatIsWithinEveryLimit) {
  Priors priors;
  Similarity pose;
  pose.rotation = Eigen::AngleAxisd(0.1, Vector3d::UnitX()).toRotationMatrix();
  pose.translation = Vector3d(0, 0, 2);
  EXPECT_TRUE(priors.empty());
  EXPECT_TRUE(priors.admit(pose));
  priors.gravity = upright(0.1);
  EXPECT_FALSE(priors.empty());
  EXPECT_TRUE(priors.admit(pose));
  priors.gravity = upright(0.0999);
  EXPECT_FALSE(priors.admit(pose));
  priors.gravity.reset();
  priors.initial_pose = InitialPose{Similarity{}, 0.1};
  EXPECT_TRUE(priors.admit(pose));
  priors.initial_pose->max_rotation = 0.0999;
  EXPECT_FALSE(priors.admit(pose));
  priors.initial_pose = InitialPose{Similarity{}, 0.2, 2};
  EXPECT_TRUE(priors.admit(pose));
  priors.initial_pose->max_translation = 1.999;
  EXPECT_FALSE(priors.admit(pose));
  priors.initial_pose.reset();
  priors.max_translation = 2;
  EXPECT_TRUE(priors.admit(pose));
  priors.max_translation = 1.999;
  EXPECT_FALSE(priors.admit(pose));
}

TEST(Priors, NameTheFieldThatIsOutOfRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  struct Case {
    const char* field;
    std::function<void(Priors&)> spoil;
  };
  const std::vector<Case> cases = {
      {"gravity.source", [](Priors& p) { p.gravity->source.setZero(); }},
      {"gravity.source", [](Priors& p) { p.gravity->source[1] = std::nan(""); }},
      {"gravity.target", [&](Priors& p) { p.gravity->target[2] = kInfinity; }},
      {"gravity.max_tilt", [](Priors& p) { p.gravity->max_tilt = -0.1; }},
      {"gravity.max_tilt", [](Priors& p) { p.gravity->max_tilt = 30; }},
      {"initial_pose.max_rotation", [](Priors& p) { p.initial_pose->max_rotation = 3.2; }},
      {"initial_pose.max_rotation", [](Priors& p) { p.initial_pose->max_rotation = std::nan(""); }},
      {"initial_pose.max_translation", [](Priors& p) { p.initial_pose->max_translation = -1; }},
      {"initial_pose.target_from_source.rotation",
       [](Priors& p) { p.initial_pose->target_from_source.rotation *= 1.01; }},
      {"initial_pose.target_from_source.rotation",
       [](Priors& p) { p.initial_pose->target_from_source.rotation *= -1; }},
      {"initial_pose.target_from_source.translation",
       [](Priors& p) { p.initial_pose->target_from_source.translation[0] = std::nan(""); }},
      {"max_translation", [](Priors& p) { p.max_translation = 0; }},
      {"max_translation", [](Priors& p) { p.max_translation = std::nan(""); }},
  };
  for (const auto& [field, spoil] : cases) {
    Priors priors;
    priors.gravity = upright(std::numbers::pi);
    priors.initial_pose = InitialPose{Similarity{}, std::numbers::pi, 0};
    EXPECT_NO_THROW(priors.validate());
    spoil(priors);
    try {
      priors.validate();
      FAIL() << field;
    } catch (const std::invalid_argument& error) {
      const std::string expected = "priors." + std::string(field) + ":";
      EXPECT_EQ(std::string(error.what()).rfind(expected, 0), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace gmcr::geometry
