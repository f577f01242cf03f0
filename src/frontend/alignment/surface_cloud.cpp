#include "frontend/alignment/surface_cloud.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

/// Nearest points that span the plane of a point, itself among them: on voxels those within about
/// two, so that edges stay sharp.
constexpr std::size_t kPlanePoints = 10;
/// Share of the spread along the longest axis below which the middle one counts as none.
constexpr double kLineTolerance = 1e-6;

}  // namespace

SurfaceCloud::SurfaceCloud(const PointsRef& points, const Eigen::Vector3d& centre)
    : points_(std::make_unique<const Points>(points.colwise() - centre)),
      view_(std::make_unique<const PointsRef>(*points_)),
      adaptor_{*view_},
      tree_(std::make_unique<const KdTree>(3, adaptor_)),
      normals_(Points::Zero(3, points.cols())),
      is_known_(static_cast<std::size_t>(points.cols()), 0) {}

std::vector<Index> SurfaceCloud::nearest(const PointsRef& queries, double radius,
                                         int num_threads) const {
  std::vector<Index> found(static_cast<std::size_t>(queries.cols()), -1);
  parallel::parallel_for(queries.cols(), 256, num_threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      std::int32_t index = 0;
      double squared_distance = 0;
      tree_->knnSearch(queries.col(i).data(), 1, &index, &squared_distance);
      if (squared_distance <= radius * radius) found[static_cast<std::size_t>(i)] = index;
    }
  });
  return found;
}

void SurfaceCloud::require_normals(const std::vector<Index>& columns, int num_threads) {
  std::vector<Index> missing;
  for (const Index column : columns) {
    if (column < 0 || is_known_[static_cast<std::size_t>(column)]) continue;
    is_known_[static_cast<std::size_t>(column)] = 1;
    missing.push_back(column);
  }
  parallel::parallel_for(static_cast<Index>(missing.size()), 64, num_threads,
                         [&](Index begin, Index end) {
                           for (Index k = begin; k < end; ++k) {
                             const Index column = missing[static_cast<std::size_t>(k)];
                             normals_.col(column) = estimate_normal(column);
                           }
                         });
}

Eigen::Vector3d SurfaceCloud::estimate_normal(Index i) const {
  std::array<std::int32_t, kPlanePoints> indices;
  std::array<double, kPlanePoints> squared_distances;
  const std::size_t count = tree_->knnSearch(points_->col(i).data(), kPlanePoints, indices.data(),
                                             squared_distances.data());
  if (count < 3) return Eigen::Vector3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d offset = points_->col(indices[k]) - points_->col(i);
    sum += offset;
    outer += offset * offset.transpose();
  }
  const auto total = static_cast<double>(count);
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(outer / total - sum * sum.transpose() / (total * total));
  const Eigen::Vector3d spread = solver.eigenvalues();
  if (!(spread[1] > kLineTolerance * spread[2])) return Eigen::Vector3d::Zero();
  return solver.eigenvectors().col(0);
}

}  // namespace gmcr::frontend
