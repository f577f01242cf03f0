#include "kernels/points/residuals.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "kernels/points/residuals_simd.hpp"

namespace gmcr::kernels {
namespace {

constexpr Index kBlock = 64;

PosePoints arrays_of(const Similarity& target_from_source, const Eigen::MatrixX3d& source,
                     const Eigen::MatrixX3d& target) {
  PosePoints points{};
  for (Index row = 0; row < 3; ++row) {
    for (Index column = 0; column < 3; ++column) {
      points.matrix[3 * row + column] =
          target_from_source.scale * target_from_source.rotation(row, column);
    }
    points.translation[row] = target_from_source.translation[row];
    points.source[row] = source.col(row).data();
    points.target[row] = target.col(row).data();
  }
  return points;
}

/// Squared residuals of correspondences [begin, end).
void write_squared_residuals(const PosePoints& points, Index begin, Index end, double* squared) {
  const double *m = points.matrix, *t = points.translation;
  for (Index i = begin; i < end; ++i) {
    const double x = points.source[0][i], y = points.source[1][i], z = points.source[2][i];
    // Eq. (1): b_i - (s R a_i + t)
    const double du = points.target[0][i] - (m[0] * x + m[1] * y + m[2] * z + t[0]);
    const double dv = points.target[1][i] - (m[3] * x + m[4] * y + m[5] * z + t[1]);
    const double dw = points.target[2][i] - (m[6] * x + m[7] * y + m[8] * z + t[2]);
    squared[i - begin] = du * du + dv * dv + dw * dw;
  }
}

}  // namespace

Eigen::ArrayXd squared_residuals_reference(const Similarity& target_from_source,
                                           const Eigen::MatrixX3d& source,
                                           const Eigen::MatrixX3d& target) {
  Eigen::ArrayXd squared(source.rows());
  write_squared_residuals(arrays_of(target_from_source, source, target), 0, source.rows(),
                          squared.data());
  return squared;
}

Eigen::ArrayXd squared_residuals(const Similarity& target_from_source,
                                 const Eigen::MatrixX3d& source, const Eigen::MatrixX3d& target) {
  const PosePoints points = arrays_of(target_from_source, source, target);
  Eigen::ArrayXd squared(source.rows());
  const Index num_full = source.rows() / kBlock * kBlock;
  squared_residuals_of_blocks(points, num_full / kBlock, squared.data());
  write_squared_residuals(points, num_full, source.rows(), squared.data() + num_full);
  return squared;
}

Consensus consensus(const Similarity& target_from_source, const Eigen::MatrixX3d& source,
                    const Eigen::MatrixX3d& target, const Eigen::ArrayXd& squared_bounds,
                    double factor) {
  const PosePoints points = arrays_of(target_from_source, source, target);
  Consensus result;
  std::array<double, kBlock> squared{};
  for (Index begin = 0; begin < source.rows(); begin += kBlock) {
    const Index end = std::min(begin + kBlock, source.rows());
    std::uint64_t agree = 0;
    if (end - begin == kBlock) {
      agree = agreeing_of_block(points, begin, squared_bounds.data(), factor, squared.data());
    } else {
      write_squared_residuals(points, begin, end, squared.data());
      for (Index i = begin; i < end; ++i) {
        // Eq. (3): |b_i - s R a_i - t|^2 <= eps_i^2
        const bool agrees =
            squared[static_cast<std::size_t>(i - begin)] <= factor * squared_bounds[i];
        agree |= std::uint64_t{agrees} << (i - begin);
      }
    }
    for (; agree != 0; agree &= agree - 1) {
      const int k = std::countr_zero(agree);
      result.indices.push_back(begin + k);
      result.squared_residuals.push_back(squared[static_cast<std::size_t>(k)]);
    }
  }
  return result;
}

}  // namespace gmcr::kernels
