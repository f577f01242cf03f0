#include "kernels/residuals.hpp"

namespace gmcr::kernels {

Eigen::ArrayXd squared_residuals(const Similarity& target_from_source,
                                 const Eigen::MatrixX3d& source, const Eigen::MatrixX3d& target) {
  const Eigen::Matrix3d m = target_from_source.scale * target_from_source.rotation;
  const Eigen::Vector3d& t = target_from_source.translation;
  const double *xs = source.col(0).data(), *ys = source.col(1).data(), *zs = source.col(2).data();
  const double *us = target.col(0).data(), *vs = target.col(1).data(), *ws = target.col(2).data();
  Eigen::ArrayXd squared(source.rows());
  for (Index i = 0; i < source.rows(); ++i) {
    const double x = xs[i], y = ys[i], z = zs[i];
    const double du = us[i] - (m(0, 0) * x + m(0, 1) * y + m(0, 2) * z + t[0]);
    const double dv = vs[i] - (m(1, 0) * x + m(1, 1) * y + m(1, 2) * z + t[1]);
    const double dw = ws[i] - (m(2, 0) * x + m(2, 1) * y + m(2, 2) * z + t[2]);
    squared[i] = du * du + dv * dv + dw * dw;
  }
  return squared;
}

}  // namespace gmcr::kernels
