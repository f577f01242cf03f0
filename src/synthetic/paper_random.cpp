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
      draft.add_inlier(cloud.col(s), target_cloud.col(s));
    } else {
      draft.add_outlier([&] {
        const Index t = random.index(target_cloud.cols());
        return std::pair(Eigen::Vector3d(cloud.col(s)), Eigen::Vector3d(target_cloud.col(t)));
      });
    }
  }
  return draft.shuffled(random);
}

}  // namespace gmcr::synthetic
