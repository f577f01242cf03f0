#include "frontend/judgement/overlap.hpp"

#include <cmath>
#include <vector>

namespace gmcr::frontend {

Overlap measure_overlap(const SurfaceCloud& source, SurfaceCloud& target,
                        const Similarity& target_from_source, double radius, int num_threads) {
  const Points moved = target_from_source.apply(source.points());
  const std::vector<Index> nearest = target.nearest(moved, radius, num_threads);
  double sum = 0;
  double count = 0;
  for (Index i = 0; i < moved.cols(); ++i) {
    const Index j = nearest[static_cast<std::size_t>(i)];
    if (j < 0) continue;
    sum += (moved.col(i) - target.point(j)).squaredNorm();
    ++count;
  }
  if (count == 0) return {};
  return {count / static_cast<double>(source.size()), std::sqrt(sum / count)};
}

}  // namespace gmcr::frontend
