#pragma once

#include <list>
#include <mutex>
#include <optional>
#include <vector>

#include "frontend/features/surface.hpp"

namespace gmcr::frontend {

/// What is known of a cloud at one scale and side of its normals.
struct KnownSurface {
  double voxel_size = 0;                         ///< metres
  double normal_radius = 0, feature_radius = 0;  ///< voxels
  NormalOrientation side = NormalOrientation::TowardViewpoint;
  Eigen::Vector3d viewpoint = Eigen::Vector3d::Zero();  ///< metres, of that side
  Points voxels;                                        ///< metres
  Points normals;  ///< of arbitrary sign; 0 where there is none
  Features features;
};

/// A cloud at the scales that were asked for, each made once: attempts at other settings share
/// voxels, normals and features. Calls from several threads wait for one another.
class CloudScales {
 public:
  /// @param points  3 x N, metres, finite; must outlive this.
  explicit CloudScales(const PointsRef& points) : points_(points) {}
  CloudScales(const CloudScales&) = delete;
  CloudScales& operator=(const CloudScales&) = delete;

  const PointsRef& points() const { return points_; }

  /// Size of the cloud, metres (`robust_extent`); 0 where it has no points.
  double extent();

  /// The voxel size of this cloud by itself, metres: the one that was set, or a share of the
  /// extent; 1 where it has no extent, and any size serves.
  double voxel_size();
  void set_voxel_size(double voxel_size) { voxel_size_ = voxel_size; }

  /// The surface at this voxel size, with the radii of the options. The reference holds as long as
  /// this.
  const Surface& surface(double voxel_size, const FrontendOptions& frontend, int num_threads,
                         StageClock& clock);

  /// Its features with its normals turned to a side.
  /// @param surface  of this cloud.
  /// @param side     not `Automatic`.
  const Features& features(const Surface& surface, NormalOrientation side,
                           const Eigen::Vector3d& viewpoint, int num_threads, StageClock& clock);

  /// What was made, or added, by now.
  std::vector<KnownSurface> known() const;
  void add(KnownSurface known);

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

  double known_extent();
  Scale* find(double voxel_size, double normal_radius, double feature_radius);

  const PointsRef& points_;
  mutable std::mutex mutex_;
  std::optional<double> extent_, voxel_size_;
  std::list<Scale> scales_;
};

}  // namespace gmcr::frontend
