#include "frontend/points/neighbourhoods.hpp"

#include "frontend/points/point_grid.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {

Neighbourhoods find_neighbourhoods(const PointsRef& points, double radius, int num_threads) {
  const PointGrid grid(points, radius);
  const kernels::PointColumns columns = grid.columns();
  constexpr Index kBlock = Neighbourhoods::kBlock;
  Neighbourhoods result;
  result.blocks_.resize(static_cast<std::size_t>((points.cols() + kBlock - 1) / kBlock));
  parallel::parallel_for(points.cols(), kBlock, num_threads, [&](Index begin, Index end) {
    Neighbourhoods::Block& block = result.blocks_[static_cast<std::size_t>(begin / kBlock)];
    std::vector<std::int64_t> slots;
    std::vector<double> squared_distances;
    PointGrid::Runs about;
    for (Index i = begin; i < end; ++i) {
      const auto runs = grid.runs_about(points.col(i).data(), about);
      const auto room =
          static_cast<std::size_t>(PointGrid::num_points(runs) + kernels::NearPoints::kSlack);
      if (room > slots.size()) {
        slots.resize(room);
        squared_distances.resize(room);
      }
      const auto count = static_cast<std::size_t>(
          kernels::near_points(columns, runs, points.col(i).data(), radius * radius,
                               {slots.data(), squared_distances.data()}));
      for (std::size_t k = 0; k < count; ++k) {
        const Index point = grid.point(slots[k]);
        if (point == i) continue;
        block.indices.push_back(static_cast<std::int32_t>(point));
        block.squared_distances.push_back(squared_distances[k]);
      }
      block.ends.push_back(block.indices.size());
    }
  });
  return result;
}

}  // namespace gmcr::frontend
