#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "synthetic/town/town.hpp"

namespace gmcr::synthetic {

/// Casts rays into a town; a grid says which houses stand near a ray.
class RayCaster {
 public:
  explicit RayCaster(const Town& town);

  /// Metres to what the ray meets first, or `range` where that is farther away.
  /// @param origin     metres, above the ground.
  /// @param direction  unit.
  double distance(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                  double range) const;

 private:
  void add(std::size_t shape, const Eigen::Vector2d& low, const Eigen::Vector2d& high);
  double meet(std::size_t shape, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
              double farthest) const;

  std::vector<TownBox> boxes_;
  std::vector<TownCylinder> cylinders_;  ///< numbered after the boxes
  Eigen::Vector2d origin_;               ///< metres: of the grid
  Index size_ = 0;                       ///< cells along each axis
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace gmcr::synthetic
