#pragma once

#include <cstdint>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::problem {

/// Number k of a sequence of 64 bits without a pattern, the same on every machine.
std::uint64_t mixed(std::uint64_t k);

/// `count` of the numbers from 0 to n - 1, ascending: one of each of `count` parts of equal size,
/// at a place that follows no pattern of the input. All of them where `count` is at least n.
///
/// The same on every machine. Cost O(count).
std::vector<Index> stratified_selection(Index n, Index count);

/// The middle one of the values, the upper of two; at least one.
double median(std::vector<double> values);

/// Coordinate-wise median, metres; the origin where there are no points. It stays among most of the
/// points wherever the others are. Cost O(N).
Eigen::Vector3d median_point(const PointsRef& points);

/// The same of a selection of the points: enough that it lies among most of them. Cost O(1).
Eigen::Vector3d middle_of(const PointsRef& points);

}  // namespace gmcr::problem
