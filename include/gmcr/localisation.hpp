#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "gmcr/frontend.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

namespace frontend {
struct MapState;
}

/// A large cloud that scans are sought in, with what that needs, made once and used often.
///
/// Copies share what was made. Calls from several threads may use one map at once.
class PreparedMap {
 public:
  /// @param points    3 x N, metres, finite, N >= 1.
  /// @param frontend  `voxel_size` is read; 0 chooses it from the spacing of the points, so that a
  ///   voxel has about 16 of them. Scans are matched at it.
  /// @param up        which way is up in the map, any length > 0.
  /// @param num_threads  >= 0; 0 uses every core. The result does not depend on it.
  /// @throws std::invalid_argument where a point is not finite, there is none, `up` is 0, or the
  ///   map spreads over more than 10^8 cells of two voxels, seen from above.
  /// Cost O(N).
  explicit PreparedMap(const PointsRef& points, const FrontendOptions& frontend = {},
                       const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ(), int num_threads = 0);

  const Points& points() const;       ///< 3 x M, metres: the map on voxels of half the size
  double voxel_size() const;          ///< metres
  const Eigen::Vector3d& up() const;  ///< unit

  /// The map as a file: that of a `PreparedCloud` of `points()` without features, which reads as a
  /// cloud too. What is made of them is made again, in less time than from the points of the map.
  std::string to_bytes() const;

  /// The map of such a file, or of any prepared cloud.
  /// @param up  as in the constructor; the file does not say.
  /// @throws std::invalid_argument where it is no such file, of another version, cut or changed, or
  ///   has no points.
  static PreparedMap from_bytes(std::string_view bytes,
                                const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ(),
                                int num_threads = 0);

 private:
  explicit PreparedMap(std::shared_ptr<const frontend::MapState> state);

  friend CloudResult localise_scan(const PointsRef& scan, const PreparedMap& map,
                                   const FrontendOptions& frontend, const Options& options);

  std::shared_ptr<const frontend::MapState> state_;
};

/// Where in a map a scan was taken, from no initial pose.
///
/// Scan and map are laid level: by their verticals, and the scan by the ground around it too. What
/// stands on the ground, seen from above and told apart by its height, is compared at all positions
/// on the ground of the map and in all headings; the best places are refined and compared by how
/// much of the scan the map's surfaces cover. The verdict speaks of the scan alone: the map need
/// not be covered. Other places at which the scan fits about as well are `rivals`.
///
/// @param scan      3 x N, metres, finite, of one sweep of a sensor: `frontend.source_viewpoint`
/// says
///   where it was, in its frame.
/// @param frontend  `source_viewpoint`, `noise_bound_voxels` and `refine` are read.
/// @param options   the priors, `scale`, `num_threads`, `time_limit`, `progress` and `stop` are
/// read.
///   Without a gravity prior the z axis of the scan points up, to 15 degrees. An initial pose and
///   `max_translation` leave fewer places to look at.
/// @return matches are pairs of voxels that meet under the pose; the rest as `register_clouds`.
/// @throws std::invalid_argument where a point is not finite, an option is out of range, the scale
///   is to be estimated, or the axis of the gravity prior is not the vertical of the map.
/// Cost O(N) and that of comparing, about 10 us a square of four voxels of ground.
/// Deterministic for any thread count unless the time binds.
CloudResult localise_scan(const PointsRef& scan, const PreparedMap& map,
                          const FrontendOptions& frontend = {}, const Options& options = {});

}  // namespace gmcr
