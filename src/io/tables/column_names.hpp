#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gmcr::io {

/// Columns of x, y, z, by index.
using Axes = std::array<std::size_t, 3>;

/// Columns of points that the names of a table tell, whatever else it holds.
///
/// A name is split into words at marks, blanks and between letters and digits. One of them is a
/// coordinate: x, y, z; east, north, up and what surveyors call them (e, easting, Rechtswert; n,
/// northing, Hochwert; h, height, elevation, ...), which are x, y, z; or a number 0 to 2 behind
/// "points" or "xyz". A name of one word may start or end with x, y or z. What is left says whose
/// point it is, but for units and words such as "position", which say nothing.
struct NamedPoint {
  std::string owner;  ///< "source", "1", "scan a", or nothing
  Axes axes;          ///< in the order x, y, z, whatever that of the columns
};

/// The points of which all three coordinates are named, by their first columns.
/// @throws std::invalid_argument where a coordinate of such a point is named twice.
std::vector<NamedPoint> find_points(const std::vector<std::string>& names);

/// The point of a cloud: the one whose coordinates are named x, y, z and nothing else, or else the
/// one of no owner.
/// @throws std::invalid_argument as `find_points`.
std::optional<Axes> find_cloud_point(const std::vector<std::string>& names);

/// Whether some point has two of its coordinates named, so that the names speak of points.
bool name_coordinates(const std::vector<std::string>& names);

/// Whether a name is that of a coordinate of some point.
bool is_coordinate(const std::string& name);

/// Source and target among named points, by what their owners are called: source and target, moving
/// and fixed, from and to, a and b, p and q, 0 and 1, 1 and 2, and the like, in any order.
struct NamedMatch {
  Axes source;
  Axes target;
};

/// Nullopt where no two owners say so.
/// @throws std::invalid_argument where several pairs do.
std::optional<NamedMatch> find_match(const std::vector<NamedPoint>& points);

}  // namespace gmcr::io
