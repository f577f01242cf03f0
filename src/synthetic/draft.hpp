#pragma once

#include <functional>

#include "gmcr/synthetic.hpp"
#include "synthetic/random.hpp"

namespace gmcr::synthetic {

/// Number of outliers that the options ask for.
Index num_outliers(const SyntheticOptions& options);

/// Transform drawn as the options say.
Similarity draw_transform(const SyntheticOptions& options, Random& random);

/// Error of one target point, drawn as the options say.
Eigen::Vector3d draw_noise(const SyntheticOptions& options, Random& random);

/// A problem that grows by one correspondence at a time; inliers and outliers are kept honest.
class Draft {
 public:
  Draft(const SyntheticOptions& options, const Similarity& target_from_source);

  /// Whether `target` is the image of `source` up to the noise bound.
  bool fits(const Eigen::Vector3d& source, const Eigen::Vector3d& target) const;

  void add_inlier(const Eigen::Vector3d& source, const Eigen::Vector3d& target);

  /// Calls `draw` until it gives a pair that does not fit, and adds that.
  /// @throws std::invalid_argument after 1,000 vain draws.
  void add_outlier(const std::function<std::pair<Eigen::Vector3d, Eigen::Vector3d>()>& draw);

  /// The problem, its correspondences in random order.
  SyntheticProblem shuffled(Random& random) const;

 private:
  void add(const Eigen::Vector3d& source, const Eigen::Vector3d& target, bool is_inlier);

  SyntheticProblem problem_;
  Index size_ = 0;
};

}  // namespace gmcr::synthetic
