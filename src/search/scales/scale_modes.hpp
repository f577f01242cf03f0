#pragma once

#include "search/scales/voted_bins.hpp"

namespace gmcr::search {

/// L7: candidate cliques at the scales of most evidence, at one of them whatever the time.
void explore_modes(PoseSearch& search, VotedBins& voted);

}  // namespace gmcr::search
