#include "registration/judgement/uncertainty.hpp"

#include "estimation/uncertainty/covariance.hpp"
#include "estimation/uncertainty/noise_mixture.hpp"
#include "registration/judgement/consistent_scales.hpp"

namespace gmcr::registration {
namespace {

bool scale_is_free(const Options& options) {
  if (options.scale_mode == ScaleMode::Known) return false;
  return !options.scale_range || options.scale_range->min < options.scale_range->max;
}

/// Correspondences whose residuals tell of the noise, ascending.
std::vector<Index> near(const Similarity& pose, const problem::CallerCorrespondences& input) {
  std::vector<Index> indices;
  for (Index i = 0; i < input.size(); ++i) {
    const double limit = estimation::NoiseMixture::kWindow * input.bounds[i];
    if ((input.target.col(i) - pose * input.source.col(i)).norm() <= limit) indices.push_back(i);
  }
  return indices;
}

}  // namespace

Uncertainty measure_uncertainty(const problem::CallerPose& pose,
                                const problem::CallerCorrespondences& input,
                                const std::vector<Index>& inliers, const Options& options,
                                const parallel::Deadline& deadline) {
  const bool free = scale_is_free(options);
  Uncertainty uncertainty;
  if (!inliers.empty()) {
    uncertainty.covariance =
        estimation::estimate_covariance(pose.similarity, input.source, input.target, input.bounds,
                                        near(pose.similarity, input), free);
  }
  const double scale = pose.scale();
  uncertainty.consistent_scales = {scale, scale};
  if (!free) return uncertainty;
  const Points source = input.source(Eigen::all, inliers),
               target = input.target(Eigen::all, inliers);
  const Eigen::ArrayXd residuals = (target - pose.similarity.apply(source)).colwise().norm();
  uncertainty.consistent_scales =
      consistent_scales({source.transpose(), target.transpose(), input.bounds(inliers)}, residuals,
                        scale, options.num_threads, deadline);
  return uncertainty;
}

}  // namespace gmcr::registration
