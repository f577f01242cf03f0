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
  EXPECT_TRUE(priors.admit_all());
  EXPECT_TRUE(priors.admit(pose));
  priors.gravity = upright(0.1);
  EXPECT_FALSE(priors.admit_all());
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

}  // namespace
}  // namespace gmcr::geometry
