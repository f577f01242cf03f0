#include <gtest/gtest.h>
#include <open3d/geometry/KDTreeSearchParam.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/Feature.h>

#include "frontend/features/fpfh.hpp"
#include "frontend/features/normals.hpp"
#include "frontend/shapes.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;

open3d::geometry::PointCloud to_open3d(const Points& points) {
  open3d::geometry::PointCloud cloud;
  for (const auto& p : points.colwise()) cloud.points_.emplace_back(p);
  return cloud;
}

TEST(Open3dOracle, EstimatesTheSameNormalsUpToTheSign) {
  const Points points = bumpy_sphere(3000, 1);
  const double radius = 0.3;
  const Points normals =
      estimate_normals(points, find_neighbourhoods(points, radius, 0), radius, 0);
  auto cloud = to_open3d(points);
  cloud.EstimateNormals(open3d::geometry::KDTreeSearchParamRadius(radius), false);
  for (Index i = 0; i < points.cols(); ++i) {
    EXPECT_GT(std::abs(normals.col(i).dot(cloud.normals_[static_cast<std::size_t>(i)])), 1 - 1e-6)
        << i;
  }
}

TEST(Open3dOracle, ComputesTheSameFpfh) {
  const Points points = bumpy_sphere(3000, 2);
  const double radius = 0.5;
  const Neighbourhoods near = find_neighbourhoods(points, radius, 0);
  // estimated normals of two points can be equal, and then only rounding tells which of the two
  // the frame sits at; these are all different
  const Points normals = points.colwise().normalized();
  const Features features = compute_fpfh(points, normals, near, 0);

  auto cloud = to_open3d(points);
  for (const auto& normal : normals.colwise()) cloud.normals_.emplace_back(normal);
  const auto expected = open3d::pipelines::registration::ComputeFPFHFeature(
      cloud, open3d::geometry::KDTreeSearchParamRadius(radius));
  ASSERT_EQ(expected->data_.cols(), features.cols());
  EXPECT_LT((features.cast<double>() - expected->data_).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace gmcr::frontend
