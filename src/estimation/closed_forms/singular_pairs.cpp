#include "estimation/closed_forms/singular_pairs.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gmcr/types.hpp"

namespace gmcr::estimation {
namespace {

/// Turns two columns of `product`, and of `right` alike, so that those of `product` are orthogonal.
/// @return whether they were not yet.
bool make_orthogonal(Eigen::Matrix3d& product, Eigen::Matrix3d& right, Index p, Index q) {
  constexpr double kTolerance = 2 * std::numeric_limits<double>::epsilon();
  const double pp = product.col(p).squaredNorm(), qq = product.col(q).squaredNorm();
  const double pq = product.col(p).dot(product.col(q));
  if (!(std::abs(pq) > kTolerance * std::sqrt(pp * qq))) return false;
  const double zeta = (qq - pp) / (2 * pq);
  const double tangent = std::copysign(1 / (std::abs(zeta) + std::sqrt(1 + zeta * zeta)), zeta);
  const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
  for (Eigen::Matrix3d* m : {&product, &right}) {
    const Eigen::Vector3d column = m->col(p);
    m->col(p) = cosine * column - sine * m->col(q);
    m->col(q) = sine * column + cosine * m->col(q);
  }
  return true;
}

}  // namespace

SingularPairs leading_singular_pairs(const Eigen::Matrix3d& matrix) {
  constexpr int kMaxSweeps = 30;
  const double magnitude = matrix.cwiseAbs().maxCoeff();
  SingularPairs pairs;
  if (!(magnitude > 0)) return pairs;
  Eigen::Matrix3d product = matrix / magnitude, right = Eigen::Matrix3d::Identity();
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool turned = make_orthogonal(product, right, 0, 1);
    turned |= make_orthogonal(product, right, 0, 2);
    turned |= make_orthogonal(product, right, 1, 2);
    if (!turned) break;
  }
  const Eigen::Vector3d norms = product.colwise().norm();
  std::array<Index, 3> order{0, 1, 2};
  for (const std::size_t a : {0, 1, 0}) {
    if (norms[order[a]] < norms[order[a + 1]]) std::swap(order[a], order[a + 1]);
  }
  for (const Index k : {0, 1}) {
    const Index column = order[static_cast<std::size_t>(k)];
    pairs.values[k] = magnitude * norms[column];
    pairs.left.col(k) = product.col(column) / norms[column];
    pairs.right.col(k) = right.col(column);
  }
  return pairs;
}

}  // namespace gmcr::estimation
