#include "synthetic/draft.hpp"

#include <cmath>

namespace gmcr::synthetic {

Index num_outliers(const SyntheticOptions& options) {
  const auto count = static_cast<double>(options.num_correspondences);
  // 90 correspondences at a rate of 0.95 are 4.5 inliers, whatever the rounding of the product.
  const double slack = 1e-9 * count;
  return options.num_correspondences -
         static_cast<Index>(std::floor(count - options.outlier_rate * count + 0.5 + slack));
}

Similarity draw_transform(const SyntheticOptions& options, Random& random) {
  Similarity transform;
  transform.scale = random.uniform(options.scale_range.min, options.scale_range.max);
  transform.rotation = random.rotation();
  transform.translation = random.in_cube(options.max_translation);
  return transform;
}

Eigen::Vector3d draw_noise(const SyntheticOptions& options, Random& random) {
  const double extent = options.noise_extent;
  if (options.noise_shape == NoiseShape::Ball) return random.in_ball(extent);
  if (options.noise_shape == NoiseShape::Cube) return random.in_cube(extent);
  Eigen::Vector3d noise;
  do {
    for (double& coordinate : noise) coordinate = extent / 3 * random.normal();
  } while (noise.norm() > extent);
  return noise;
}

Draft::Draft(const SyntheticOptions& options, const Similarity& target_from_source) {
  const Index count = options.num_correspondences;
  problem_.source.resize(3, count);
  problem_.target.resize(3, count);
  problem_.is_inlier.resize(static_cast<std::size_t>(count));
  problem_.target_from_source = target_from_source;
  problem_.noise_bound = options.noise_bound;
}

bool Draft::fits(const Eigen::Vector3d& source, const Eigen::Vector3d& target) const {
  return (target - problem_.target_from_source * source).norm() <= problem_.noise_bound;
}

void Draft::add(const Eigen::Vector3d& source, const Eigen::Vector3d& target, bool is_inlier) {
  problem_.source.col(size_) = source;
  problem_.target.col(size_) = target;
  problem_.is_inlier[static_cast<std::size_t>(size_)] = is_inlier;
  ++size_;
}

SyntheticProblem Draft::shuffled(Random& random) const {
  SyntheticProblem result = problem_;
  const std::vector<Index> order = random.sample(size_, size_);
  for (Index i = 0; i < size_; ++i) {
    const Index from = order[static_cast<std::size_t>(i)];
    result.source.col(i) = problem_.source.col(from);
    result.target.col(i) = problem_.target.col(from);
    result.is_inlier[static_cast<std::size_t>(i)] =
        problem_.is_inlier[static_cast<std::size_t>(from)];
  }
  return result;
}

}  // namespace gmcr::synthetic
