#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "frontend/points/point_grid.hpp"
#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// Points of a surface, about their centroid, with what an alignment asks of them again and again:
/// the nearest point, and the normals of the points that take part. Several threads may ask at
/// once.
class SurfaceCloud {
 public:
  /// @param points  3 x N, metres, finite, N >= 1, N < 2^31.
  /// @param centre   metres: what is subtracted from them, so that no digit is lost far from 0.
  /// @param spacing  metres, > 0: of the points, about.
  /// Cost O(N).
  SurfaceCloud(const PointsRef& points, const Eigen::Vector3d& centre, double spacing);

  Index size() const { return points_.cols(); }
  Eigen::Vector3d point(Index i) const { return points_.col(i); }

  const Points& points() const { return points_; }

  /// Column of the point nearest to each query that has one within `radius` metres, else -1.
  /// @param queries  3 x M, metres, about the centre.
  /// Cost O(M) for radii of up to three spacings, and O(N) the first time for larger ones.
  /// Deterministic for any thread count.
  std::vector<Index> nearest(const PointsRef& queries, double radius, int num_threads);

  /// Makes the normals of these points known: unit, of arbitrary sign; 0 where the nearest points
  /// span no surface.
  /// @param columns  any order; -1 is skipped.
  /// Cost O(K) for the K that are not known yet, and O(N) where some have few points nearby.
  /// Deterministic for any thread count.
  void require_normals(const std::vector<Index>& columns, int num_threads);

  /// That of a point that was required.
  Eigen::Vector3d normal(Index i) const { return normals_.col(i); }

 private:
  /// Room for what a search finds.
  struct Found {
    std::vector<std::int64_t> slots;
    std::vector<double> squared_distances;
  };

  /// The grid that reaches sqrt(3)^k times as far as the first one. The mutex is held.
  const PointGrid& wider(int k);

  /// Finds the points of a grid within a radius of one of them; how many.
  std::size_t find_near(const PointGrid& grid, Index i, double radius, Found& found) const;

  /// The normal from the nearest points within the reach of a grid; nullopt where these are few.
  std::optional<Eigen::Vector3d> estimate_normal(const PointGrid& grid, Index i,
                                                 Found& found) const;

  Points points_;
  PointGrid grid_;
  std::mutex mutex_;  ///< of what follows
  std::map<int, PointGrid> wider_;
  Points normals_;
  std::vector<char> is_known_;
};

}  // namespace gmcr::frontend
