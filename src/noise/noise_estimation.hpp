#pragma once

#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "gmcr/types.hpp"

namespace gmcr::noise {

/// Solves with a noise bound that is chosen from the data (`NoiseMode::Estimated`).
///
/// Searches for a pose with each bound of a ladder, whose rungs double from 1e-3.5 to 0.1 of the
/// median distance of the targets, then with the bounds that these poses lead to. For each pose the
/// false alarms of its consensus sets say how sure these are without a bound
/// (`count_false_alarms`). Over all poses the tightest set that is half as sure as the surest (half
/// its log10) is kept: matches that are off by more than the noise, but not at random, make the
/// surest sets loose. The bound is its largest residual, times
///   2^(1/3)                          for the part of the noise that half as sure leaves out,
///   sqrt(3 k / (3 k - parameters))   for what a fit takes from the k residuals it was fitted to,
/// and never below the rounding of the coordinates. Then `register_correspondences` solves with it.
/// Correspondences that are given more than once count once in the choice.
///
/// The searches of the ladder are cheap ones: few nodes a clique search, an even selection of 300
/// correspondences (4 times as many, and so on, only where no consensus stands out), and fewer
/// where a loose bound lets most pairs agree; at most 1,200 with unknown scale. The poses are
/// judged on all. The search takes at most half of the time budget.
/// @param options  with `NoiseMode::Estimated`; validated, as the points.
/// @return status NoConsensus where chance explains every consensus set, with at least one false
///   alarm. `noise_estimate` is there for at least 3 distinct correspondences.
/// @throws std::invalid_argument where the graph exceeds the memory budget.
/// Cost: about 11 cheap solves and a full one. The cheap ones take 0.02 to 1 s together on 300 to
/// 5,000 correspondences, known scale at the lower end; up to 10 s with unknown scale where no
/// consensus stands out. Deterministic for any number of threads unless the time binds; the
/// selections depend on the order of the correspondences.
Result register_with_estimated_noise(const PointsRef& source, const PointsRef& target,
                                     const Options& options);

}  // namespace gmcr::noise
