#pragma once

#include <memory>

#include "frontend/alignment/surface_cloud.hpp"
#include "frontend/points/range_image.hpp"
#include "gmcr/similarity.hpp"

namespace gmcr::frontend {

/// Two clouds, each in a frame at its centroid, so that a pose of them is the same, digit by digit,
/// wherever on Earth they lie.
class CentredPair {
 public:
  /// @param source, target  3 x N and 3 x M, metres, finite, N and M >= 1.
  /// @param source_spacing, target_spacing  metres, each in its own frame, > 0: of the points,
  /// about.
  CentredPair(const PointsRef& source, const PointsRef& target, double source_spacing,
              double target_spacing, int num_threads);

  /// The same with a target that other pairs have too.
  /// @param target         about its centre, with the normals of all its points.
  /// @param target_centre  metres, the caller's frame.
  CentredPair(const PointsRef& source, double source_spacing, std::shared_ptr<SurfaceCloud> target,
              Eigen::Vector3d target_centre);

  /// A pose of the caller's frames between the centred ones, and back.
  Similarity centred(const Similarity& target_from_source) const;
  Similarity of_caller(const Similarity& centred) const;

  /// Metres, the caller's frame.
  const Eigen::Vector3d& source_centre() const { return source_centre_; }
  const Eigen::Vector3d& target_centre() const { return target_centre_; }
  /// For other pairs with this target.
  const std::shared_ptr<SurfaceCloud>& shared_target() const { return shared_target_; }

 private:
  struct Parts {
    Eigen::Vector3d source_centre, target_centre;
    std::shared_ptr<SurfaceCloud> source, target;
  };
  explicit CentredPair(Parts parts);

  Eigen::Vector3d source_centre_;  ///< metres, the caller's frame
  Eigen::Vector3d target_centre_;
  std::shared_ptr<SurfaceCloud> shared_source_, shared_target_;

 public:
  SurfaceCloud& source;
  SurfaceCloud& target;
  /// What the sensors saw, in the caller's frames; null where they were somewhere unknown.
  std::shared_ptr<const RangeImage> source_view, target_view;
};

/// Mean of the points, summed from the first one: no digit is lost far from 0.
Eigen::Vector3d centroid(const PointsRef& points);

}  // namespace gmcr::frontend
