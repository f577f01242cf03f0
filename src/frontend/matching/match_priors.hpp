#pragma once

#include <Eigen/Core>
#include <vector>

#include "frontend/points/kd_tree.hpp"
#include "gmcr/options.hpp"

namespace gmcr::frontend {

/// The points of a cloud and their normals, on the side that their features see.
struct OrientedPoints {
  const Points& points;   ///< 3 x N, metres, the caller's frame
  const Points& normals;  ///< 3 x N, unit; 0 where there is none
};

/// What the priors say of single matches: where the partner of a point can lie, and which way its
/// normal can point.
///
/// Every point is taken to have a normal: those without have no feature either. Where the
/// translation is known to a finite distance, a partner lies within that and the noise bound of the
/// images that the admitted rotations and scales give the point. Normals are taken to be right to
/// 30 degrees.
class MatchPriors {
 public:
  /// Whether the priors say anything of single matches.
  static bool say_something(const Options& options);

  /// Keeps references to all of them.
  /// @param noise_bound  metres, target frame.
  /// Cost O(M log M).
  MatchPriors(const OrientedPoints& source, const OrientedPoints& target, const Options& options,
              double noise_bound);
  MatchPriors(const MatchPriors&) = delete;
  MatchPriors& operator=(const MatchPriors&) = delete;

  /// Columns of the target that column `i` of the source may match, ascending.
  std::vector<Index> partners_of(Index i) const;

 private:
  /// Where the image of the origin of the source frame lies.
  struct Place {
    Eigen::Vector3d centre;
    double radius = 0;  ///< metres, with the noise bound
  };
  /// Holds all partners of a point.
  struct Ball {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = 0;
  };

  /// @param expected  the point, turned by the initial pose.
  Ball ball_of(const Place& place, const Eigen::Vector3d& expected) const;
  bool is_inclined_as(Index i, Index j) const;
  /// Columns of the target, in any order.
  std::vector<Index> inclined_as(Index i) const;
  std::vector<Index> close_to_images_of(const Eigen::Vector3d& expected) const;

  OrientedPoints source_, target_;
  const Options& options_;
  ScaleRange scales_;
  std::vector<Place> places_;
  Eigen::VectorXd source_inclinations_, target_inclinations_;  ///< of normals to gravity, radians
  std::vector<Index> by_inclination_;                          ///< columns of the target
  PointsRef target_view_;
  KdTreePoints adaptor_;
  KdTree tree_;
};

}  // namespace gmcr::frontend
