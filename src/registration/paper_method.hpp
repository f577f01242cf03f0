#pragma once

#include "registration/gmcr_method.hpp"

namespace gmcr {

/// `Method::Paper`: the stages of the paper one after the other, one maximum clique each, on all of
/// the input; where memory or time binds, the diagnostics say so.
/// @param scales  where the scale must lie; min == max: it is known.
MethodResult solve_paper(SolveContext& context, const Correspondences& correspondences,
                         const ScaleRange& scales);

}  // namespace gmcr
