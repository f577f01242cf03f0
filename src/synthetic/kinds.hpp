#pragma once

#include "gmcr/synthetic.hpp"
#include "synthetic/random.hpp"

namespace gmcr::synthetic {

// One function a kind; the protocols are those of gmcr::make_synthetic.

/// @param source  the N source points.
SyntheticProblem make_ball(const SyntheticOptions& options, const Points& source, Random& random);

/// @param cloud  the source cloud, `num_cloud_points` points.
SyntheticProblem make_paper_random(const SyntheticOptions& options, const Points& cloud,
                                   Random& random);

/// @param cloud  the source cloud, `num_cloud_points` points.
SyntheticProblem make_paper_structured(const SyntheticOptions& options, const Points& cloud,
                                       Random& random);

}  // namespace gmcr::synthetic
