#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::frontend {

/// How far the rays of a sensor went: the nearest range in each cell of an image about its
/// viewpoint, a square where the cloud lies to one side of it, the six sides of a cube where it
/// lies all around. Cells hold several points each.
class RangeImage {
 public:
  /// @param points     3 x N, metres, finite; of many, some tens of thousands by a fixed stride.
  /// @param viewpoint  metres, the same frame.
  /// Cost O(N). Deterministic.
  RangeImage(const PointsRef& points, const Eigen::Vector3d& viewpoint);

  const Eigen::Vector3d& viewpoint() const { return viewpoint_; }

  /// Whether a sensor at the viewpoint may have seen all points at once: they lie to one side, as
  /// far as a camera sees, or all around, and few cells have points behind a gap. 14 % of the
  /// points of real views at most, half of those of whole objects and of merged scans. False of few
  /// points, of which none hides another.
  bool is_view() const { return is_view_; }

  /// Whether the rays about a place went on behind it.
  /// @param ray     from the viewpoint to the place, metres.
  /// @param margin  metres that they went on, at least.
  bool sees_through(const Eigen::Vector3d& ray, double margin) const;

 private:
  /// A side and the place on it, as cells of the finest image.
  struct Pixel {
    std::uint16_t side, row, column;
  };
  struct Seen {
    Pixel pixel;
    float range;  ///< metres
  };
  std::optional<Pixel> pixel_of(const Eigen::Vector3d& ray) const;
  std::size_t cell_of(const Pixel& pixel) const;
  bool lies_aside(const Points& rays);
  void coarsen(const std::vector<Seen>& seen);
  void fill(const std::vector<Seen>& seen, double diagonal);

  Eigen::Vector3d viewpoint_;
  bool is_all_around_ = false;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< rows: right, up, forward
  Eigen::Vector2d corner_ = -Eigen::Vector2d::Ones();   ///< of a side, right and up over forward
  double width_ = 2;                                    ///< of a side, the same
  int coarseness_ = 0;                                  ///< halvings of the finest image
  std::vector<float> nearest_;         ///< metres, infinite where nothing is; none: no image
  std::vector<float> nearest_around_;  ///< the same with the cells next to it
  bool is_view_ = false;
};

/// The image of a cloud that may be one view from there; else null.
std::shared_ptr<const RangeImage> view_from(const Eigen::Vector3d& viewpoint,
                                            const PointsRef& points);

}  // namespace gmcr::frontend
