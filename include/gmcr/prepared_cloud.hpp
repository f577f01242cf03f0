#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "gmcr/frontend.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

namespace frontend {
class CloudScales;
}

/// A cloud with what matching it needs (voxels, normals, features), made once and used often.
///
/// Copies share what was made. What another setting needs is made when it is first asked for, and
/// kept too, so that a cloud that takes part in many pairs is prepared once for each voxel size.
/// Calls from several threads wait for one another while something is made.
class PreparedCloud {
 public:
  /// Prepares the cloud for the first attempt at a pair.
  /// @param points    3 x N, metres, finite. A point that fills more than 1 % of them is kept once.
  /// @param frontend  `voxel_size` (0: from the cloud), `normal_radius`, `feature_radius`,
  ///   `orientation` and `source_viewpoint`, which is that of this cloud, are read.
  /// @param num_threads  >= 0; 0 uses every core. The result does not depend on it.
  /// @throws std::invalid_argument as `match_clouds`.
  /// Cost O(N).
  explicit PreparedCloud(const PointsRef& points, const FrontendOptions& frontend = {},
                         int num_threads = 0);

  /// The other cloud of a pair with this one: with its radii, and nothing made before it is asked
  /// for.
  /// @param viewpoint  of the other cloud, metres.
  /// @throws std::invalid_argument where a point is not finite.
  PreparedCloud beside(const PointsRef& points, const Eigen::Vector3d& viewpoint) const;

  const Points& points() const;              ///< 3 x N, metres, as they were given
  double voxel_size() const;                 ///< metres: that a pair is matched at, see below
  double normal_radius() const;              ///< voxels
  double feature_radius() const;             ///< voxels
  const Eigen::Vector3d& viewpoint() const;  ///< metres; 0: where `FrontendOptions` say

  /// The cloud as a file, with the voxels, normals and features that are known by now: a binary PLY
  /// with further elements (docs/files.md), whose vertices are the points.
  std::string to_bytes() const;

  /// Whether bytes are, or begin, such a file, of whatever version.
  static bool is_prepared(std::string_view bytes);

  /// The cloud of such a file.
  /// @throws std::invalid_argument where it is no such file, of another version, cut or changed.
  static PreparedCloud from_bytes(std::string_view bytes);

 private:
  struct State;
  explicit PreparedCloud(std::shared_ptr<State> state);

  friend CloudMatches match_clouds(const PreparedCloud& source, const PreparedCloud& target,
                                   const FrontendOptions& frontend, const Options& options);
  friend CloudResult register_clouds(const PreparedCloud& source, const PreparedCloud& target,
                                     const FrontendOptions& frontend, const Options& options);

  std::shared_ptr<State> state_;
};

/// `match_clouds` of prepared clouds: the same matches as of their points, sooner.
///
/// Where no voxel size is given it is chosen from those of the two clouds as from their points:
/// with a known scale the smaller one. Clouds that were prepared with one voxel size use what they
/// have.
/// @throws std::invalid_argument as `match_clouds`, and where a radius or a viewpoint is neither
///   that of the prepared cloud nor the default one.
CloudMatches match_clouds(const PreparedCloud& source, const PreparedCloud& target,
                          const FrontendOptions& frontend = {}, const Options& options = {});

/// `register_clouds` of prepared clouds, in the same way.
CloudResult register_clouds(const PreparedCloud& source, const PreparedCloud& target,
                            const FrontendOptions& frontend = {}, const Options& options = {});

}  // namespace gmcr
