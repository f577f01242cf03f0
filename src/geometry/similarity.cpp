#include "gmcr/similarity.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <stdexcept>

#include "geometry/elementary.hpp"

namespace gmcr {

Similarity Similarity::operator*(const Similarity& other) const {
  return {scale * other.scale, rotation * other.rotation, *this * other.translation};
}

Points Similarity::apply(const PointsRef& points) const {
  return ((scale * rotation) * points).colwise() + translation;
}

Similarity Similarity::inverse() const {
  const Eigen::Matrix3d transposed = rotation.transpose();
  return {1 / scale, transposed, -(transposed * translation) / scale};
}

Eigen::Matrix4d Similarity::matrix() const {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = scale * rotation;
  m.topRightCorner<3, 1>() = translation;
  return m;
}

Similarity Similarity::from_matrix(const Eigen::Matrix4d& matrix, double tolerance) {
  if (!matrix.allFinite()) throw std::invalid_argument("matrix: an entry is not finite");
  if ((matrix.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() > tolerance) {
    throw std::invalid_argument("matrix: the last row is not 0 0 0 1");
  }
  const Eigen::Matrix3d linear = matrix.topLeftCorner<3, 3>();
  const double determinant = linear.determinant();
  if (!(determinant > 0)) {
    throw std::invalid_argument("matrix: no similarity, the determinant is not positive");
  }
  const double scale = elementary::cbrt(determinant);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(linear / scale,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  if ((svd.singularValues().array() - 1).abs().maxCoeff() > tolerance) {
    throw std::invalid_argument("matrix: no similarity, the rotation is not orthonormal");
  }
  return {scale, svd.matrixU() * svd.matrixV().transpose(), matrix.topRightCorner<3, 1>()};
}

}  // namespace gmcr
