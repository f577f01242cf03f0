#pragma once

#include "search/incumbent.hpp"

namespace gmcr::search {

/// Ratio of the sizes of the clouds: of the median distances from their median points; 1 where one
/// of them has none.
double typical_scale(const problem::Correspondences& correspondences);

/// Octaves of which one has the known scale, or the typical one of all of the input, in its middle.
problem::Octaves octaves_of(const Options& options, const problem::Correspondences& input);

/// Where an unknown scale is searched for when the caller does not say: within a factor of 20 of
/// the ratios of the clouds' sizes, by their medians and by their mean squares.
ScaleRange default_scale_range(const problem::Correspondences& correspondences);

/// Search for the best pose over all scales of `search.scales()` (L5).
///
/// Cuts the scales into bins and bounds each by how many others each correspondence agrees with in
/// it. Grows candidate cliques in the bins of most evidence; then, for the evidence and for the
/// number of inliers, searches the graph of the bin of largest bound for a clique that beats the
/// best pose, halves a bin whose bound stays above it, and so on until no bin can beat it, no
/// halving can lower the largest bound or the number of graphs is spent.
UpperBounds search_scales(PoseSearch& search);

}  // namespace gmcr::search
