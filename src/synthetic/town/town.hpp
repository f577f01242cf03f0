#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "synthetic/random.hpp"

namespace gmcr::synthetic {

/// An upright box that is turned about the vertical.
struct TownBox {
  Eigen::Vector2d centre;     ///< metres
  Eigen::Vector2d direction;  ///< unit: of its first edge
  Eigen::Vector2d half;       ///< metres: half its edges
  double low, high;           ///< metres
};

/// An upright cylinder.
struct TownCylinder {
  Eigen::Vector2d centre;
  double radius;
  double low, high;
};

struct TownOptions {
  double extent = 200;  ///< metres: side of the square that the streets cover, > 0
  double block = 80;    ///< metres between streets, at least 50
  /// Share of the rows of houses that are alike: one house again and again, at one distance.
  double repeated_share = 0.5;
  std::uint64_t seed = 0;
  std::uint64_t cars_seed = 0;  ///< of what is parked: another one is another day
};

/// Flat ground at height 0, a grid of streets, rows of houses along them, trees, poles and cars.
struct Town {
  std::vector<TownBox> boxes;
  std::vector<TownCylinder> cylinders;
  /// Ends of the middle line of each street.
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> streets;
  double extent = 0;  ///< metres
};

/// The same town for the same options, up to the rounding of sine and cosine.
Town make_town(const TownOptions& options);

/// A place on a street.
struct TownPlace {
  Eigen::Vector2d position;
  double heading;  ///< radians, along the street
};

/// Places along all streets, so many metres apart.
std::vector<TownPlace> drive(const Town& town, double step);

/// A place on a street beside its middle line, with any heading.
TownPlace random_place(const Town& town, Random& random);

}  // namespace gmcr::synthetic
