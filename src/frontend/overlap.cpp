#include "frontend/overlap.hpp"

#include <cmath>
#include <vector>

#include "frontend/kd_tree.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {

Overlap measure_overlap(const PointsRef& source, const PointsRef& target,
                        const Similarity& target_from_source, double radius, int num_threads) {
  if (source.cols() == 0 || target.cols() == 0) return {};
  const KdTreePoints adaptor{target};
  const KdTree tree(3, adaptor);
  const Points moved = target_from_source.apply(source);
  std::vector<double> squared_distances(static_cast<std::size_t>(source.cols()));
  parallel::parallel_for(source.cols(), 256, num_threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      std::int32_t nearest = 0;
      tree.knnSearch(moved.col(i).data(), 1, &nearest,
                     &squared_distances[static_cast<std::size_t>(i)]);
    }
  });

  double sum = 0;
  double count = 0;
  for (const double squared_distance : squared_distances) {
    if (squared_distance > radius * radius) continue;
    sum += squared_distance;
    ++count;
  }
  if (count == 0) return {};
  return {count / static_cast<double>(source.cols()), std::sqrt(sum / count)};
}

}  // namespace gmcr::frontend
