#pragma once

namespace gmcr::kernels {

/// Rounding of the ends of an interval of scales, relative to the sum of its terms: 16 units in the
/// last place.
inline constexpr double kScaleRounding = 0x1p-48;

/// Source points closer than this, metres, agree at every scale or at none.
inline constexpr double kCoincident = 1e-100;

}  // namespace gmcr::kernels
