#pragma once

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "support/method.hpp"
#include "support/problem.hpp"
#include "support/records.hpp"

namespace gmcr::bench {

/// Seconds of wall time a solve.
struct TimeLimits {
  double solve = 20;
  double certify = 2;  ///< for a method that spends what is left on the certificate
};

/// Solves the problem `repetitions` times, fewer where that is slow and once where the method
/// certifies, and describes the outcome.
///
/// @param options  noise bound and time budget are set here, the rest by the method.
/// @return the fields of a record: method, input, wall times (median and quartiles, ms), what the
///   result says, the errors against the truth, the number of correspondences within the noise
///   bound of the truth, and the inliers and evidence of the truth by the method's own objective
///   ("truth_inliers", "truth_evidence"). An exception is an outcome too: status "error".
Json solve(const Problem& problem, Options options, const NamedMethod& method, TimeLimits limits,
           int repetitions);

/// Says in the record of a solve whether the pose is right, and of a wrong one why.
///
/// "success"; "missed": the truth has more evidence than the pose, so the search failed;
/// "truth_is_beaten": the pose is wrong and has at least the evidence of the truth, so the
/// objective itself prefers it.
void judge(Json& record, bool success);

/// Errors of an estimate, in degrees, metres and shares.
Json errors_of(const Similarity& estimate, const Similarity& truth, const PointsRef& points);

/// The value at `share` (0.5: median) of a sorted list, interpolated; `values` must not be empty.
double quantile(std::vector<double> values, double share);

}  // namespace gmcr::bench
