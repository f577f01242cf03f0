// Two raw point clouds to a pose, with no initial guess.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

#include "gmcr/frontend.hpp"
#include "gmcr/metrics.hpp"

namespace {

/// A bumpy sheet, seen as a sensor at the origin would: `shift` moves the part that is in view.
gmcr::Points sheet(double shift) {
  gmcr::Points points(3, 120 * 120);
  for (int i = 0; i < 120 * 120; ++i) {
    const double x = i % 120 * 0.01 + shift, y = i / 120 * 0.01;
    points.col(i) << x, y,
        2 + 0.1 * std::sin(9 * x * x + 3 * y) + 0.08 * std::cos(11 * y * y - 4 * x);
  }
  return points;
}

}  // namespace

int main() {
  gmcr::Similarity truth;
  truth.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  truth.translation = Eigen::Vector3d(0.1, 0.2, 0);
  const gmcr::Points source = sheet(0), target = truth.apply(sheet(0.2));

  const gmcr::CloudResult result = gmcr::register_clouds(source, target);  // nothing to choose

  const gmcr::Similarity& pose = result.registration.target_from_source;
  std::printf("%s: %zu of %td matches agree, %.0f %% of the source meets the target\n",
              to_string(result.verdict), result.registration.inliers.size(),
              result.matches.source.cols(), 100 * result.fitness);
  std::printf("rotation error %.3f degrees\n",
              gmcr::rotation_error_deg(pose.rotation, truth.rotation));
  return gmcr::mean_point_error(pose, truth, source) < 0.02 ? 0 : 1;
}
