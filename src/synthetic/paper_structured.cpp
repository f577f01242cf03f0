#include <algorithm>
#include <cmath>

#include "synthetic/clouds.hpp"
#include "synthetic/draft.hpp"
#include "synthetic/kinds.hpp"

namespace gmcr::synthetic {
namespace {

/// Indices around a base that its cluster has not used yet, the base's own first.
struct Cluster {
  std::vector<Index> sources;
  std::vector<Index> targets;
};

Index cluster_capacity(const SyntheticOptions& options) { return options.source_neighbors + 1; }

Index choose_num_bases(const SyntheticOptions& options) {
  const Index outliers = num_outliers(options);
  if (outliers == 0) return 0;
  if (options.num_bases > 0) return std::min(options.num_bases, outliers);
  const auto usual = static_cast<Index>(std::ceil(10 * options.outlier_rate)) + 2;
  const Index capacity = cluster_capacity(options);
  return std::min(outliers, std::max(usual, (outliers + capacity - 1) / capacity));
}

/// Clusters with 1 + (their share of the remaining outliers) members, drawn by dealing one by one.
std::vector<Index> deal_outliers(const SyntheticOptions& options, Index num_bases, Random& random) {
  std::vector<Index> sizes(static_cast<std::size_t>(num_bases), 1);
  std::vector<Index> open(sizes.size());
  for (std::size_t b = 0; b < open.size(); ++b) open[b] = static_cast<Index>(b);
  for (Index rest = num_outliers(options) - num_bases; rest > 0; --rest) {
    // A cluster leaves the draw when it is full.
    std::erase_if(open, [&](Index b) {
      return sizes[static_cast<std::size_t>(b)] >= cluster_capacity(options);
    });
    ++sizes[static_cast<std::size_t>(
        open[static_cast<std::size_t>(random.index(std::ssize(open)))])];
  }
  return sizes;
}

/// Target of the inlier with source `s`: a near point instead of the true one.
Index associate(const SyntheticOptions& options, const Draft& draft, const Points& cloud,
                const Points& target_cloud, Index s, Random& random) {
  std::vector<Index> near =
      nearest_points(target_cloud, cloud.cols(), s, options.association_neighbors);
  std::erase_if(near, [&](Index t) { return !draft.fits(cloud.col(s), target_cloud.col(t)); });
  return near.empty() ? s : near[static_cast<std::size_t>(random.index(std::ssize(near)))];
}

Index take_random(std::vector<Index>& pool, Random& random) {
  std::swap(pool[static_cast<std::size_t>(random.index(std::ssize(pool)))], pool.back());
  const Index taken = pool.back();
  pool.pop_back();
  return taken;
}

}  // namespace

SyntheticProblem make_paper_structured(const SyntheticOptions& options, const Points& cloud,
                                       Random& random) {
  const Similarity target_from_source = draw_transform(options, random);
  const Points target_cloud = paper_target_cloud(options, target_from_source, cloud, random);
  Draft draft(options, target_from_source);

  const Index num_inliers = options.num_correspondences - num_outliers(options);
  const Index num_bases = choose_num_bases(options);
  const std::vector<Index> anchors = random.sample(num_inliers + num_bases, cloud.cols());
  for (Index i = 0; i < num_inliers; ++i) {
    const Index s = anchors[static_cast<std::size_t>(i)];
    const Index t = associate(options, draft, cloud, target_cloud, s, random);
    draft.add_inlier(cloud.col(s), target_cloud.col(t));
  }

  const std::vector<Index> sizes = deal_outliers(options, num_bases, random);
  for (Index b = 0; b < num_bases; ++b) {
    const Index base_source = anchors[static_cast<std::size_t>(num_inliers + b)];
    Index base_target = 0;
    draft.add_outlier([&] {
      base_target = random.index(cloud.cols());
      return std::pair(Eigen::Vector3d(cloud.col(base_source)),
                       Eigen::Vector3d(target_cloud.col(base_target)));
    });
    std::vector<Index> sources =
        nearest_points(cloud, cloud.cols(), base_source, options.source_neighbors);
    std::vector<Index> targets =
        nearest_points(target_cloud, cloud.cols(), base_target, options.target_neighbors);
    for (Index member = 1; member < sizes[static_cast<std::size_t>(b)]; ++member) {
      const Index s = take_random(sources, random);
      Index t = 0;
      draft.add_outlier([&] {
        t = targets[static_cast<std::size_t>(random.index(std::ssize(targets)))];
        return std::pair(Eigen::Vector3d(cloud.col(s)), Eigen::Vector3d(target_cloud.col(t)));
      });
      std::erase(targets, t);
    }
  }
  return draft.shuffled(random);
}

}  // namespace gmcr::synthetic
