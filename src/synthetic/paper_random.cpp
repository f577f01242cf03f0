#include <optional>

#include "synthetic/clouds.hpp"
#include "synthetic/draft.hpp"
#include "synthetic/kinds.hpp"

namespace gmcr::synthetic {

SyntheticProblem make_paper_random(const SyntheticOptions& options, const Points& cloud,
                                   Random& random) {
  const Similarity target_from_source = draw_transform(options, random);
  const Points target_cloud = paper_target_cloud(options, target_from_source, cloud, random);

  Draft draft(options, target_from_source);
  const std::vector<Index> sources = random.sample(options.num_correspondences, cloud.cols());
  const Index num_inliers = options.num_correspondences - num_outliers(options);
  for (Index i = 0; i < options.num_correspondences; ++i) {
    const Index s = sources[static_cast<std::size_t>(i)];
    if (i < num_inliers) {
      draft.add(cloud.col(s), target_cloud.col(s), true);
      continue;
    }
    const Index t = draw_outlier(options, [&]() -> std::optional<Index> {
      const Index drawn = random.index(target_cloud.cols());
      if (draft.fits(cloud.col(s), target_cloud.col(drawn))) return std::nullopt;
      return drawn;
    });
    draft.add(cloud.col(s), target_cloud.col(t), false);
  }
  return draft.shuffled(random);
}

}  // namespace gmcr::synthetic
