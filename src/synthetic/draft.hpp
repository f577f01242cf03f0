#pragma once

#include <stdexcept>
#include <string>

#include "gmcr/synthetic.hpp"
#include "synthetic/random.hpp"

namespace gmcr::synthetic {

/// Number of outliers that the options ask for: all but the inliers, whose number is rounded,
/// halves up.
Index num_outliers(const SyntheticOptions& options);

/// Transform drawn as the options say.
Similarity draw_transform(const SyntheticOptions& options, Random& random);

/// Error of one target point, drawn as the options say.
Eigen::Vector3d draw_noise(const SyntheticOptions& options, Random& random);

/// The first value that `draw` gives, a function () -> std::optional<Value>.
/// @throws std::invalid_argument after 1,000 vain draws.
template <typename Draw>
auto draw_outlier(const SyntheticOptions& options, Draw draw) {
  for (int attempt = 0; attempt < 1000; ++attempt) {
    if (auto value = draw()) return *value;
  }
  throw std::invalid_argument("noise_bound: " + std::to_string(options.noise_bound) +
                              " leaves no room for outliers");
}

/// A problem that grows by one correspondence at a time.
class Draft {
 public:
  Draft(const SyntheticOptions& options, const Similarity& target_from_source);

  /// Whether `target` is the image of `source` up to the noise bound.
  bool fits(const Eigen::Vector3d& source, const Eigen::Vector3d& target) const;

  /// @param is_inlier  what `fits` says, up to rounding.
  void add(const Eigen::Vector3d& source, const Eigen::Vector3d& target, bool is_inlier);

  /// The problem, its correspondences in random order.
  SyntheticProblem shuffled(Random& random) const;

 private:
  SyntheticProblem problem_;
  Index size_ = 0;
};

}  // namespace gmcr::synthetic
