#include <stdexcept>
#include <string>

#include "gmcr/registration.hpp"
#include "problem/input.hpp"
#include "problem/objective.hpp"
#include "registration/degeneracy.hpp"
#include "registration/uncertainty.hpp"
#include "search/scale_modes.hpp"

namespace gmcr {
namespace {

/// A given pose is judged by a given bound.
void require_given_noise(const Options& options) {
  if (options.noise_mode == NoiseMode::Given) return;
  throw InvalidOption("noise_mode", "is 'estimated', but a given pose needs a noise bound");
}

/// @throws std::invalid_argument where a pose is none.
void require_pose(const Similarity& pose) {
  if (pose.scale > 0 && pose.matrix().allFinite()) return;
  throw std::invalid_argument("target_from_source: is not finite, or its scale is not positive");
}

}  // namespace

Consensus evaluate_consensus(const Similarity& target_from_source, const PointsRef& source,
                             const PointsRef& target, const Options& options) {
  problem::validate_input(source, target, options);
  require_given_noise(options);
  require_pose(target_from_source);
  const problem::Correspondences input = problem::correspondences_of(source, target, options);
  const problem::Hypothesis judged =
      problem::Objective(input, options.evidence, options.memory_limit / 4,
                         problem::DistinctEvidence::kAllScales, search::octaves_of(options, input))
          .judge(target_from_source);
  return {judged.inliers, judged.evidence};
}

Uncertainty evaluate_uncertainty(const Similarity& target_from_source, const PointsRef& source,
                                 const PointsRef& target, const std::vector<Index>& inliers,
                                 const Options& options) {
  problem::validate_input(source, target, options);
  require_given_noise(options);
  require_pose(target_from_source);
  for (const Index i : inliers) {
    if (i >= 0 && i < source.cols()) continue;
    throw std::invalid_argument("inliers: " + std::to_string(i) + " is not one of " +
                                std::to_string(source.cols()) + " correspondences");
  }
  const problem::Correspondences input = problem::correspondences_of(source, target, options);
  Uncertainty uncertainty =
      registration::measure_uncertainty(target_from_source, input, inliers, options,
                                        parallel::Deadline(options.time_limit, options.stop));
  const bool determined = uncertainty.covariance &&
                          registration::degeneracy_reason(source, target_from_source, inliers,
                                                          input.bounds(inliers).maxCoeff(), options)
                              .empty();
  if (!determined) uncertainty.covariance.reset();
  return uncertainty;
}

}  // namespace gmcr
