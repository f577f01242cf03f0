#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/invalid_option.hpp"
#include "gmcr/registration.hpp"

namespace gmcr {
namespace {

using Eigen::Vector3d;
using testing::bumpy_sphere;
using testing::some_motion;

constexpr Index kEach = 6000;

std::vector<Similarity> places() {
  Similarity far = some_motion();
  far.rotation = Eigen::AngleAxisd(2, Vector3d::UnitY()) * far.rotation;
  far.translation += Vector3d(4, 0, 1);
  return {some_motion(), far};
}

/// The object in two places, each point drawn anew.
Points scene() {
  Points all(3, 2 * kEach);
  all << places()[0].apply(bumpy_sphere(kEach, 2)), places()[1].apply(bumpy_sphere(kEach, 3));
  return all;
}

FrontendOptions of_whole_objects() {
  FrontendOptions frontend;
  frontend.orientation = NormalOrientation::Outward;
  frontend.voxel_size = 0.06;
  frontend.max_attempts = 1;
  return frontend;
}

double error_at(const CloudResult& instance, const Similarity& place) {
  const Points source = bumpy_sphere(500, 1);
  const Points error = instance.registration.target_from_source.apply(source) - place.apply(source);
  return error.colwise().norm().mean();
}

TEST(RegisterCloudInstances, FindsTheObjectInBothPlaces) {
  const Points source = bumpy_sphere(kEach, 1);
  const Points target = scene();
  FrontendOptions frontend = of_whole_objects();
  frontend.orientation = NormalOrientation::Automatic;  // outward is not outward of two objects
  frontend.source_viewpoint = frontend.target_viewpoint = Vector3d(0, 0, 50);
  const auto found = register_cloud_instances(source, target, frontend);
  ASSERT_EQ(found.size(), 2u);
  const bool in_order = error_at(found[0], places()[0]) < error_at(found[0], places()[1]);
  EXPECT_LT(error_at(found[0], places()[in_order ? 0 : 1]), 0.02);
  EXPECT_LT(error_at(found[1], places()[in_order ? 1 : 0]), 0.02);
  for (const CloudResult& instance : found) EXPECT_TRUE(instance.rivals.empty());
  EXPECT_LT(found[1].num_target_points, 1.3 * kEach) << "the first one is taken away";
}

TEST(RegisterCloudInstances, StopAtTheirLimits) {
  const Points source = bumpy_sphere(kEach, 1);
  FrontendOptions frontend = of_whole_objects();
  const Points target = some_motion().apply(bumpy_sphere(kEach, 2));
  InstanceOptions limits;
  EXPECT_EQ(register_cloud_instances(source, target, frontend, {}, limits).size(), 1u);
  limits.max_instances = 0;
  EXPECT_THROW(register_cloud_instances(source, target, frontend, {}, limits), InvalidOption);
}

TEST(RegisterCloudInstances, OfNothingIsOneWithoutAPose) {
  const auto found = register_cloud_instances(Points(3, 0), Points(3, 0));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].registration.status, Status::Ok);
}

}  // namespace
}  // namespace gmcr
