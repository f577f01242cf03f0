#include "estimation/rotation.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <stdexcept>

namespace gmcr {

std::optional<Eigen::Matrix3d> rotation_from_covariance(const Eigen::Matrix3d& covariance) {
  constexpr double kRankTolerance = 1e-12;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d& singular = svd.singularValues();
  if (!(singular[1] > kRankTolerance * singular[0])) return std::nullopt;
  const double handedness = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Eigen::Vector3d(1, 1, handedness).asDiagonal() * svd.matrixV().transpose();
}

Eigen::Matrix3d least_rotation(const Eigen::Matrix3d& covariance) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (!(svd.singularValues()[0] > 0)) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d from = svd.matrixV().col(0), to = svd.matrixU().col(0);
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

std::optional<Eigen::Matrix3d> estimate_rotation(const PointsRef& a, const PointsRef& b) {
  if (a.cols() != b.cols()) throw std::invalid_argument("b: number of columns differs from a");
  if (a.cols() < 2) return std::nullopt;
  return rotation_from_covariance(b * a.transpose());
}

}  // namespace gmcr
