// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/points/near_points_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/points/near_points.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, NearPoints::kSlack>;
using Vector = hn::Vec<Lanes>;

HWY_INLINE Vector square(Vector v) { return hn::Mul(v, v); }

struct Query {
  PointColumns points;
  Vector x, y, z;

  HWY_INLINE Query(const PointColumns& columns, const double* query)
      : points(columns),
        x(hn::Set(Lanes(), query[0])),
        y(hn::Set(Lanes(), query[1])),
        z(hn::Set(Lanes(), query[2])) {}

  /// Of the points from number i on.
  HWY_INLINE Vector squared_distances(std::int32_t i) const {
    const Lanes lanes;
    return hn::Add(hn::Add(square(hn::Sub(hn::LoadU(lanes, points.x + i), x)),
                           square(hn::Sub(hn::LoadU(lanes, points.y + i), y))),
                   square(hn::Sub(hn::LoadU(lanes, points.z + i), z)));
  }
};

}  // namespace

Index find_near(const PointColumns& points, const PointRun* runs, Index num_runs,
                const double* query, double squared_radius, std::int64_t* indices,
                double* squared_distances) {
  const Lanes lanes;
  const auto num_lanes = static_cast<std::int32_t>(hn::Lanes(lanes));
  const Query from(points, query);
  const Vector most = hn::Set(lanes, squared_radius);
  Index count = 0;
  for (Index r = 0; r < num_runs; ++r) {
    const std::int32_t end = runs[r].end;
    for (std::int32_t i = runs[r].begin; i < end; i += num_lanes) {
      const Vector squared = from.squared_distances(i);
      double squares[NearPoints::kSlack];
      std::uint8_t bits[8] = {};
      hn::StoreU(squared, lanes, squares);
      hn::StoreMaskBits(lanes, hn::Lt(squared, most), bits);
      const std::int32_t num_inside = end - i < num_lanes ? end - i : num_lanes;
      // every lane is written, and those that are near are kept: no branch to be mistaken
      for (std::int32_t lane = 0; lane < num_inside; ++lane) {
        indices[count] = i + lane;
        squared_distances[count] = squares[lane];
        count += (bits[0] >> lane) & 1;
      }
    }
  }
  return count;
}

void find_nearest(const PointColumns& points, const PointRun* runs, Index num_runs,
                  const double* query, double squared_radius, double* squared_distance,
                  std::int32_t* index) {
  const Lanes lanes;
  const auto num_lanes = static_cast<std::int32_t>(hn::Lanes(lanes));
  const Query from(points, query);
  Vector least = hn::Set(lanes, squared_radius);
  Vector least_index = hn::Set(lanes, -1.0);
  for (Index r = 0; r < num_runs; ++r) {
    const std::int32_t end = runs[r].end;
    const Vector past = hn::Set(lanes, static_cast<double>(end));
    for (std::int32_t i = runs[r].begin; i < end; i += num_lanes) {
      const Vector squared = from.squared_distances(i);
      const Vector number = hn::Iota(lanes, static_cast<double>(i));  // whole, exact
      const auto is_nearer = hn::And(hn::Lt(squared, least), hn::Lt(number, past));
      least = hn::IfThenElse(is_nearer, squared, least);
      least_index = hn::IfThenElse(is_nearer, number, least_index);
    }
  }
  double squares[NearPoints::kSlack], numbers[NearPoints::kSlack];
  hn::StoreU(least, lanes, squares);
  hn::StoreU(least_index, lanes, numbers);
  double best = squared_radius, best_number = -1;
  for (std::int32_t lane = 0; lane < num_lanes; ++lane) {
    const bool ties = squares[lane] == best && numbers[lane] < best_number;
    if (!(numbers[lane] >= 0 && (squares[lane] < best || ties))) continue;
    best = squares[lane];
    best_number = numbers[lane];
  }
  *squared_distance = best;
  *index = static_cast<std::int32_t>(best_number);
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(find_near);
HWY_EXPORT(find_nearest);

Index near_points(const PointColumns& points, std::span<const PointRun> runs, const double* query,
                  double squared_radius, NearPoints found) {
  return HWY_DYNAMIC_DISPATCH(find_near)(points, runs.data(), static_cast<Index>(runs.size()),
                                         query, squared_radius, found.indices,
                                         found.squared_distances);
}

NearestPoint nearest_point(const PointColumns& points, std::span<const PointRun> runs,
                           const double* query, double squared_radius) {
  NearestPoint nearest;
  HWY_DYNAMIC_DISPATCH(find_nearest)
  (points, runs.data(), static_cast<Index>(runs.size()), query, squared_radius,
   &nearest.squared_distance, &nearest.index);
  return nearest;
}

}  // namespace gmcr::kernels
#endif
