#pragma once

#include "problem/problem.hpp"

namespace gmcr::paper {

/// `Method::Paper`: the stages of the paper one after the other, one maximum clique each, on all of
/// the input; where memory or time binds, the diagnostics say so.
///
/// The stages know of the priors what single pairs say; their pose is then fitted anew among those
/// that the priors admit.
problem::Found solve(const problem::Problem& problem, problem::Run& run);

}  // namespace gmcr::paper
