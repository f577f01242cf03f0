#include <algorithm>
#include <optional>

#include "synthetic/draft.hpp"
#include "synthetic/kinds.hpp"

namespace gmcr::synthetic {

SyntheticProblem make_ball(const SyntheticOptions& options, const Points& source, Random& random) {
  const Similarity target_from_source = draw_transform(options, random);
  double radius = 0;
  for (Index i = 0; i < source.cols(); ++i) radius = std::max(radius, source.col(i).norm());
  radius *= target_from_source.scale;

  Draft draft(options, target_from_source);
  const Index num_inliers = source.cols() - num_outliers(options);
  for (Index i = 0; i < source.cols(); ++i) {
    const Eigen::Vector3d point = source.col(i);
    if (i < num_inliers) {
      draft.add(point, target_from_source * point + draw_noise(options, random), true);
      continue;
    }
    const auto target = draw_outlier(options, [&]() -> std::optional<Eigen::Vector3d> {
      const Eigen::Vector3d drawn = target_from_source.translation + random.in_ball(radius);
      if (draft.fits(point, drawn)) return std::nullopt;
      return drawn;
    });
    draft.add(point, target, false);
  }
  return draft.shuffled(random);
}

}  // namespace gmcr::synthetic
