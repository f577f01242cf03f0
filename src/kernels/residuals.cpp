#include "kernels/residuals.hpp"

namespace gmcr::kernels {

void squared_residuals(const Similarity& target_from_source, const PointsRef& source,
                       const PointsRef& target, Eigen::Ref<Eigen::ArrayXd> squared) {
  const Eigen::Matrix3d m = target_from_source.scale * target_from_source.rotation;
  const Eigen::Vector3d& t = target_from_source.translation;
  for (Index i = 0; i < source.cols(); ++i) {
    const double x = source(0, i), y = source(1, i), z = source(2, i);
    const double dx = target(0, i) - (m(0, 0) * x + m(0, 1) * y + m(0, 2) * z + t[0]);
    const double dy = target(1, i) - (m(1, 0) * x + m(1, 1) * y + m(1, 2) * z + t[1]);
    const double dz = target(2, i) - (m(2, 0) * x + m(2, 1) * y + m(2, 2) * z + t[2]);
    squared[i] = dx * dx + dy * dy + dz * dz;
  }
}

}  // namespace gmcr::kernels
