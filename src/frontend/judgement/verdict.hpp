#pragma once

#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Judges the pose of `result` by its matches and surfaces; writes verdict and reason.
///
/// The matches alone say trusted, doubtful or untrusted; those that were not filtered are never
/// trusted. Where they say nothing, an object that was turned all around is trusted where it covers
/// the view and its mirror image does not. What the surfaces leave open, rivals at which they meet
/// as well, and surfaces that do not meet closely can only make it worse: one motion left open, or
/// a rival, is doubtful, two open motions are untrusted.
void judge(CloudResult& result);

/// Whether the pose were trusted if only the mirrored source were known to be worse.
bool awaits_mirrored(const CloudResult& result);

}  // namespace gmcr::frontend
