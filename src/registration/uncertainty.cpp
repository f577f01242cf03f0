#include "registration/uncertainty.hpp"

#include "estimation/covariance.hpp"
#include "registration/consistent_scales.hpp"

namespace gmcr::registration {
namespace {

bool scale_is_free(const Options& options) {
  if (options.scale_mode == ScaleMode::Known) return false;
  return !options.scale_range || options.scale_range->min < options.scale_range->max;
}

}  // namespace

Uncertainty measure_uncertainty(const Similarity& target_from_source,
                                const problem::Correspondences& input,
                                const std::vector<Index>& inliers, const Options& options,
                                const parallel::Deadline& deadline) {
  const bool free = scale_is_free(options);
  Uncertainty uncertainty;
  uncertainty.covariance = estimation::estimate_covariance(
      target_from_source, input.source, input.target, input.bounds, inliers, free);
  const double scale = target_from_source.scale;
  uncertainty.consistent_scales = {scale, scale};
  if (!free) return uncertainty;
  const problem::Correspondences chosen = problem::subset(input, inliers);
  const Eigen::ArrayXd residuals =
      (chosen.target - target_from_source.apply(chosen.source)).colwise().norm();
  uncertainty.consistent_scales =
      consistent_scales({chosen.source.transpose(), chosen.target.transpose(), chosen.bounds},
                        residuals, scale, options.num_threads, deadline);
  return uncertainty;
}

}  // namespace gmcr::registration
