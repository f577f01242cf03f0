#pragma once

#include "gmcr/options.hpp"
#include "problem/correspondences.hpp"
#include "problem/scale_buckets.hpp"

namespace gmcr::problem {

/// Ratio of the sizes of the clouds: of the median distances from their median points; 1 where one
/// of them has none.
double typical_scale(const PointsRef& source, const PointsRef& target);

/// ScaleBuckets of which one has the known scale, or the typical one of all of the input, in its
/// middle.
ScaleBuckets scale_buckets_of(const Options& options, const PointsRef& source,
                              const PointsRef& target);

/// Where an unknown scale is searched for when the caller does not say: within a factor of 20 of
/// the ratios of the clouds' sizes, by their medians and by their mean squares, these at most 1e4
/// apart; of magnitudes that a scale may have.
ScaleRange default_scale_range(const Correspondences& correspondences);

/// The known scale, or the range that the caller gives, or the default one.
ScaleRange scales_to_search(const Options& options, const Correspondences& correspondences);

}  // namespace gmcr::problem
