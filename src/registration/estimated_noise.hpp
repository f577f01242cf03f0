#pragma once

#include <functional>

#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "gmcr/types.hpp"

namespace gmcr::registration {

/// A solve with a given noise bound.
using Solve =
    std::function<Result(const PointsRef& source, const PointsRef& target, const Options& options)>;

/// Solves with the noise bound that the options give or, where they ask for it
/// (`NoiseMode::Estimated`), with one that is chosen from the data (`noise::choose_noise`).
/// @return status NoConsensus where chance explains every consensus set, with at least one false
///   alarm. `noise_estimate` is there where the noise was to be estimated and at least 3
///   correspondences are distinct.
Result with_noise_bound(const PointsRef& source, const PointsRef& target, const Options& options,
                        const Solve& solve);

}  // namespace gmcr::registration
