#pragma once

#include <list>
#include <optional>

#include "frontend/surface.hpp"

namespace gmcr::frontend {

/// A cloud at the scales that were asked for, each made once: attempts at other settings share
/// voxels, normals and features.
class CloudScales {
 public:
  /// @param points  3 x N, metres, finite; must outlive this.
  explicit CloudScales(const PointsRef& points) : points_(points) {}
  CloudScales(const CloudScales&) = delete;
  CloudScales& operator=(const CloudScales&) = delete;

  const PointsRef& points() const { return points_; }

  /// `robust_extent` of the points; 0 where there are none.
  double extent();

  /// The surface at this voxel size, with the radii of the options.
  const Surface& surface(double voxel_size, const FrontendOptions& frontend, int num_threads,
                         StageClock& clock);

  /// Its features with its normals turned to a side.
  /// @param surface  of this cloud.
  /// @param side     not `Automatic`.
  const Features& features(const Surface& surface, NormalOrientation side,
                           const Eigen::Vector3d& viewpoint, int num_threads, StageClock& clock);

 private:
  struct Described {
    NormalOrientation side;
    Eigen::Vector3d viewpoint;
    Features features;
  };
  struct Scale {
    double normal_radius, feature_radius;  ///< voxels
    Surface surface;
    std::list<Described> described;
  };

  const PointsRef& points_;
  std::optional<double> extent_;
  std::list<Scale> scales_;
};

}  // namespace gmcr::frontend
