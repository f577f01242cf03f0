#pragma once

#include <cstddef>

#include "frontend/features/cloud_scales.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Matches that agree at a guess from which on it needs no second opinion.
inline constexpr std::size_t kSureOfScale = 30;

/// Whether the scale of two clouds is guessed from a first matching, and then sought near that: not
/// where the caller asks for a proof or for poses at other scales.
bool narrows_scale(const Options& options);

/// Scales within a tenth of a guess, of those that the caller allows.
/// @param scale  one that they allow.
ScaleRange scales_about(double scale, const Options& options);

/// The options with voxels that are of one size at the scale, where sizes are not given.
FrontendOptions at_scale(FrontendOptions frontend, double scale, CloudScales& source,
                         CloudScales& target);

/// Adds poses of the matches at the scale of the result to its alternatives, for the surfaces to
/// choose from: at all scales each would take a search over the scale.
/// @param options  of the caller; `time_limit` is what is left.
void add_poses_at_scale(CloudResult& result, const Options& options, int num_poses);

}  // namespace gmcr::frontend
