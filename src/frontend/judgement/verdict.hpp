#pragma once

#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Judges the pose of `result` by its matches and surfaces; writes verdict and reason.
///
/// The matches alone say trusted, doubtful or untrusted; those that were not filtered are never
/// trusted. What the surfaces leave open, rivals at which they meet as well, and surfaces that do
/// not meet closely can only make it worse: one motion left open, or a rival, is doubtful, two open
/// motions are untrusted.
void judge(CloudResult& result);

/// Whether the one doubt is that the surfaces lie apart, by no more than the noise of a sensor.
bool is_doubted_for_noise(const CloudResult& result);

}  // namespace gmcr::frontend
