#pragma once

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "support/method.hpp"
#include "support/records.hpp"

namespace gmcr::bench {

/// Correspondences with their truth.
struct Problem {
  Points source;
  Points target;
  Similarity truth;
  double noise_bound = 0;
};

/// Solves the problem `repetitions` times, fewer where that is slow, and describes the outcome.
///
/// @param options  method, evidence and noise bound are set here.
/// @return the fields of a record: method, input, wall times (median and quartiles, ms), what the
///   result says, the errors against the truth, and the number of correspondences within the noise
///   bound of the truth. An exception is an outcome too: status "error".
Json solve(const Problem& problem, Options options, const NamedMethod& method, int repetitions);

/// Errors of an estimate, in degrees, metres and shares.
Json errors_of(const Similarity& estimate, const Similarity& truth, const PointsRef& points);

/// The value at `share` (0.5: median) of a sorted list, interpolated; `values` must not be empty.
double quantile(std::vector<double> values, double share);

}  // namespace gmcr::bench
