#include "estimation/spread.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace gmcr::estimation {

Spread measure_spread(const PointsRef& points, const std::vector<Index>& indices) {
  if (indices.empty()) return {};
  const Points chosen = points(Eigen::all, indices);
  const Points centred = chosen.colwise() - chosen.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(centred * centred.transpose());
  const Eigen::Vector3d axis = eigen.eigenvectors().col(2);
  const Points off_axis = centred - axis * (axis.transpose() * centred);
  return {centred.colwise().norm().maxCoeff(), off_axis.colwise().norm().maxCoeff()};
}

double reach_from_line(const PointsRef& points, const std::vector<Index>& indices,
                       const Eigen::Vector3d& direction) {
  if (indices.empty()) return 0;
  const Points chosen = points(Eigen::all, indices);
  const Points centred = chosen.colwise() - chosen.rowwise().mean().eval();
  const Eigen::Vector3d axis = direction.stableNormalized();
  return (centred - axis * (axis.transpose() * centred)).colwise().norm().maxCoeff();
}

}  // namespace gmcr::estimation
