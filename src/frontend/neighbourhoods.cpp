#include "frontend/neighbourhoods.hpp"

#include <algorithm>
#include <utility>

#include "frontend/kd_tree.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr Index kGrain = 256;

/// Neighbours of a run of points, in order.
struct Chunk {
  std::vector<std::size_t> counts;
  std::vector<std::int32_t> indices;
  std::vector<double> squared_distances;
};

Chunk search_chunk(const KdTree& tree, const PointsRef& points, double squared_radius, Index begin,
                   Index end) {
  Chunk chunk;
  std::vector<std::pair<std::int32_t, double>> found;
  nanoflann::SearchParams unsorted;
  unsorted.sorted = false;
  for (Index i = begin; i < end; ++i) {
    found.clear();
    tree.radiusSearch(points.col(i).data(), squared_radius, found, unsorted);
    std::size_t count = 0;
    for (const auto& [index, squared_distance] : found) {
      if (index == i) continue;
      chunk.indices.push_back(index);
      chunk.squared_distances.push_back(squared_distance);
      ++count;
    }
    chunk.counts.push_back(count);
  }
  return chunk;
}

}  // namespace

Neighbourhoods find_neighbourhoods(const PointsRef& points, double radius, int num_threads) {
  Neighbourhoods result;
  result.offsets.assign(1, 0);
  if (points.cols() == 0) return result;

  const KdTreePoints adaptor{points};
  const KdTree tree(3, adaptor);
  std::vector<Chunk> chunks(static_cast<std::size_t>((points.cols() + kGrain - 1) / kGrain));
  parallel::parallel_for(points.cols(), kGrain, num_threads, [&](Index begin, Index end) {
    chunks[static_cast<std::size_t>(begin / kGrain)] =
        search_chunk(tree, points, radius * radius, begin, end);
  });

  for (const Chunk& chunk : chunks) {
    for (std::size_t count : chunk.counts) {
      result.offsets.push_back(result.offsets.back() + count);
    }
  }
  result.indices.reserve(result.offsets.back());
  result.squared_distances.reserve(result.offsets.back());
  for (const Chunk& chunk : chunks) {
    result.indices.insert(result.indices.end(), chunk.indices.begin(), chunk.indices.end());
    result.squared_distances.insert(result.squared_distances.end(), chunk.squared_distances.begin(),
                                    chunk.squared_distances.end());
  }
  return result;
}

}  // namespace gmcr::frontend
