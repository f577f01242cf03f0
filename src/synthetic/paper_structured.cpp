#include <algorithm>
#include <cmath>
#include <optional>

#include "synthetic/clouds.hpp"
#include "synthetic/draft.hpp"
#include "synthetic/kinds.hpp"

namespace gmcr::synthetic {
namespace {

/// Points of the two clouds from which the members of a cluster of outliers are drawn.
struct Cluster {
  std::vector<Index> sources;
  std::vector<Index> targets;
};

Index cluster_capacity(const SyntheticOptions& options) { return options.source_neighbours + 1; }

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
      nearest_points(target_cloud, cloud.cols(), s, options.association_neighbours);
  std::erase_if(near, [&](Index t) { return !draft.fits(cloud.col(s), target_cloud.col(t)); });
  return near.empty() ? s : near[static_cast<std::size_t>(random.index(std::ssize(near)))];
}

/// Cluster around the source `base_source` and a random target, none of whose pairs fits the truth.
/// The bases come first in both lists.
Cluster draw_cluster(const SyntheticOptions& options, const Draft& draft, const Points& cloud,
                     const Points& target_cloud, Index base_source, Random& random) {
  Cluster cluster;
  cluster.sources = nearest_points(cloud, cloud.cols(), base_source, options.source_neighbours);
  cluster.sources.insert(cluster.sources.begin(), base_source);
  cluster.targets = draw_outlier(options, [&]() -> std::optional<std::vector<Index>> {
    const Index base_target = random.index(cloud.cols());
    std::vector<Index> targets =
        nearest_points(target_cloud, cloud.cols(), base_target, options.target_neighbours);
    targets.insert(targets.begin(), base_target);
    for (const Index s : cluster.sources) {
      for (const Index t : targets) {
        if (draft.fits(cloud.col(s), target_cloud.col(t))) return std::nullopt;
      }
    }
    return targets;
  });
  return cluster;
}

/// Takes a random one but the first, which is the base.
Index take_random(std::vector<Index>& pool, Random& random) {
  std::swap(pool[static_cast<std::size_t>(1 + random.index(std::ssize(pool) - 1))], pool.back());
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
    draft.add(cloud.col(s), target_cloud.col(t), true);
  }

  const std::vector<Index> sizes = deal_outliers(options, num_bases, random);
  for (Index b = 0; b < num_bases; ++b) {
    Cluster cluster = draw_cluster(options, draft, cloud, target_cloud,
                                   anchors[static_cast<std::size_t>(num_inliers + b)], random);
    draft.add(cloud.col(cluster.sources[0]), target_cloud.col(cluster.targets[0]), false);
    for (Index member = 1; member < sizes[static_cast<std::size_t>(b)]; ++member) {
      const Index s = take_random(cluster.sources, random);
      const Index t = take_random(cluster.targets, random);
      draft.add(cloud.col(s), target_cloud.col(t), false);
    }
  }
  return draft.shuffled(random);
}

}  // namespace gmcr::synthetic
