// The registration of PCL that needs no guess finds a motion that ICP, the usual one, does not.
#include <pcl/point_types.h>

#include <cmath>
#include <gmcr/pcl.hpp>
#include <iostream>
#include <limits>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr surface() {
  const Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) {
      const float u = static_cast<float>(i) / 60, v = static_cast<float>(j) / 60;
      const float height = 0.25f * std::sin(7 * u) * std::cos(5 * v) +
                           0.2f * std::exp(-30 * (u - 0.3f) * (u - 0.3f) - 40 * v * v);
      cloud->push_back({u, v, height});
    }
  }
  return cloud;
}

}  // namespace

int main() {
  Eigen::Affine3f truth =
      Eigen::Translation3f(3, -2, 1) * Eigen::AngleAxisf(2, Eigen::Vector3f(1, 2, 3).normalized());
  const Cloud::Ptr source = surface(), target(new Cloud);
  pcl::transformPointCloud(*source, *target, truth);
  source->push_back(pcl::PointXYZ(std::numeric_limits<float>::quiet_NaN(), 0, 0));

  gmcr::PclRegistration<pcl::PointXYZ, pcl::PointXYZ> registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  Cloud aligned;
  registration.align(aligned);
  const float error =
      (registration.getFinalTransformation() - truth.matrix()).cwiseAbs().maxCoeff();
  std::cout << registration.result().verdict_reason << "\nerror " << error << '\n';
  const float moved = (aligned[7].getVector3fMap() - (*target)[7].getVector3fMap()).norm();
  return registration.hasConverged() && error < 0.01f && moved < 0.01f ? 0 : 1;
}
