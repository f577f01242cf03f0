#pragma once

#include <string>

namespace gmcr::geometry {

/// Names the units that the sizes of two clouds look like, such as "the source seems to be in
/// meters and the target in millimeters"; empty where the ratio is near that of no two.
/// @param ratio  size of the target over that of the source, > 0, no unit.
std::string units_of_ratio(double ratio);

}  // namespace gmcr::geometry
