// The kernels, each on every instruction set of this machine. Bounds to compare with, in vector
// operations a pair (w lanes: w pairs share them) and bytes a pair that come from memory:
//   consistency row, double   12 for each squared length pair and 3 for e^2; then 8 at one scale,
//                             15 over a range. 7 arrays of doubles: 56 bytes, from the L2 cache.
//   consistency tile, single  8 for the squared lengths; then 10 at one scale, 16 over a range, 4
//                             more where bounds differ. A tile reads 4.5 KiB for 4096 pairs: 1
//                             byte.
//   transpose                 6 steps over 64 words: 6 bit operations a word and step.
//   residual                  21, 6 arrays of doubles: 48 bytes a point, and the bound's 8.
//   rotation row              30 and two square roots; 8 arrays of doubles: 64 bytes.
//   bit row                   and, count, add: 3 a vector of words; 16 bytes a word.
//   nearest features          17 multiply-adds of pairs of 16-bit bins, and 10 for both minima; the
//                             targets come from the L2 cache, 17 bytes a pair for four queries.
//   pair angles               about 90 and two square roots and quotients, 6 gathers, and 3 counts.
//   near, nearest points      9 for the distance; then a store and an add, or two choices.
//   squared distances         3 a value of the descriptor.
#include <hwy/targets.h>

#include <functional>
#include <string>
#include <vector>

#include "kernels/bits/bit_row.hpp"
#include "kernels/features/descriptor_distances.hpp"
#include "kernels/features/nearest_features.hpp"
#include "kernels/features/pair_angles.hpp"
#include "kernels/forced_isa.hpp"
#include "kernels/pairs/consistency_tiles.hpp"
#include "kernels/points/near_points.hpp"
#include "kernels/points/residuals.hpp"
#include "micro/themes.hpp"
#include "paper/rotation_consensus.hpp"
#include "problem/graph/consistency_graph.hpp"

namespace gmcr::bench {
namespace {

constexpr Index kCount = 4096;  // whole blocks; all arrays fit the L2 cache

const geometry::CorrespondenceArrays& arrays() {
  static const auto result = problem::consistency_arrays(random_correspondences(kCount, 0.95), 1);
  return result;
}

void time_consistency_rows(benchmark::State& state, double scale_min, double scale_max) {
  std::vector<std::uint64_t> row(kCount / 64);
  Index i = 0;
  for (auto _ : state) {
    kernels::consistency_row(arrays(), i, scale_min, scale_max, row);
    benchmark::DoNotOptimize(row.data());
    i = (i + 1) % kCount;
  }
  count_pairs(state, kCount, 56.0 * kCount);
}

void time_consistency_tiles(benchmark::State& state, double scale_min, double scale_max,
                            bool equal_bounds) {
  geometry::CorrespondenceArrays same = arrays();
  if (!equal_bounds) same.bounds[0] *= 2;
  const kernels::ConsistencyTiles tiles(same, scale_min, scale_max);
  if (!tiles.is_single_precision()) state.SkipWithError("not in single precision");
  Index k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(tiles.tile(k / 64, k % 64));
    k = (k + 1) % (64 * 64);
  }
  count_pairs(state, 64 * 64, 2 * sizeof(kernels::PairBlock));
}

void time_transpose(benchmark::State& state) {
  kernels::BitBlock block{};
  for (std::size_t r = 0; r < 64; ++r) block[r] = 0x9e3779b97f4a7c15 * (r + 1);
  for (auto _ : state) {
    kernels::transpose(block);
    benchmark::DoNotOptimize(block.data());
  }
  count_pairs(state, 64 * 64, 2 * sizeof(block));
}

void time_residuals(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        kernels::squared_residuals(Similarity(), arrays().source, arrays().target).data());
  }
  count_pairs(state, kCount, 56.0 * kCount);
}

void time_consensus(benchmark::State& state) {
  const Eigen::ArrayXd squared_bounds = arrays().bounds.square();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        kernels::consensus(Similarity(), arrays().source, arrays().target, squared_bounds)
            .indices.data());
  }
  count_pairs(state, kCount, 56.0 * kCount);
}

void time_rotation_rows(benchmark::State& state) {
  kernels::DirectionArrays directions{
      arrays().source.rowwise().normalized(), arrays().target.rowwise().normalized(),
      Eigen::ArrayXd::Constant(kCount, 0.99), Eigen::ArrayXd::Constant(kCount, 0.14)};
  std::vector<std::uint64_t> row(kCount / 64);
  Index k = 0;
  for (auto _ : state) {
    kernels::rotation_row(directions, k, row);
    benchmark::DoNotOptimize(row.data());
    k = (k + 1) % kCount;
  }
  count_pairs(state, kCount, 64.0 * kCount);
}

/// Rows of 4,096 and of 512 bits, half of them set.
void time_bit_rows(benchmark::State& state, Index num_words, bool sum) {
  std::vector<std::uint64_t> a(static_cast<std::size_t>(num_words), 0x5555aaaa3333cccc);
  std::vector<std::int64_t> values(static_cast<std::size_t>(64 * num_words), 3);
  for (auto _ : state) {
    benchmark::DoNotOptimize(a.data());
    benchmark::DoNotOptimize(sum ? kernels::sum_over_common_bits(a.data(), a.data(), num_words,
                                                                 values.data(), 64 * num_words)
                                 : kernels::count_common_bits(a.data(), a.data(), num_words));
  }
  count_pairs(state, 64.0 * static_cast<double>(num_words), 16.0 * static_cast<double>(num_words));
}

/// A chain of 1,000 times two dependent instructions: half of the time of a pair is a cycle.
void time_clock(benchmark::State& state) {
  std::uint64_t x = 1;
  for (auto _ : state) {
    for (int k = 0; k < 1000; ++k) x ^= x << 13;
    benchmark::DoNotOptimize(x);
  }
  count_pairs(state, 1000, 0);
}

/// Histograms that look like features: 33 values that sum to 600.
std::vector<float> random_features(Index count) {
  std::vector<float> values(static_cast<std::size_t>(33 * count));
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = static_cast<float>((0x9e3779b97f4a7c15 * (k + 1)) >> 40) * (36.0f / (1 << 24));
  }
  return values;
}

void time_nearest_features(benchmark::State& state) {
  const std::vector<float> values = random_features(kCount);
  const kernels::IntegerFeatures features(values.data(), 33, kCount, 64);
  kernels::NearestSources of_targets(features);
  kernels::NearestFeature nearest[kernels::kFeatureQueries];
  Index first = 0;
  for (auto _ : state) {
    kernels::nearest_features(features, first, kernels::kFeatureQueries, features, nearest,
                              of_targets);
    benchmark::DoNotOptimize(nearest);
    first = (first + kernels::kFeatureQueries) % kCount;
  }
  count_pairs(state, kernels::kFeatureQueries * kCount, 68.0 * kCount);
}

void time_squared_distances(benchmark::State& state) {
  const std::vector<float> values = random_features(kCount);
  const kernels::GroupedDescriptors<float> targets(
      33, kCount, [&](Index d, Index i) { return values[static_cast<std::size_t>(33 * i + d)]; });
  std::vector<float> distances(kCount);
  for (auto _ : state) {
    kernels::squared_distances(targets, values.data(), distances.data());
    benchmark::DoNotOptimize(distances.data());
  }
  count_pairs(state, kCount, 132.0 * kCount);
}

/// Points about one, as many as the neighbourhood of a feature has.
constexpr Index kNeighbours = 80;

void time_pair_angles(benchmark::State& state) {
  const Eigen::MatrixX3d normals = arrays().target.rowwise().normalized();
  const Eigen::MatrixX3d& points = arrays().source;
  const kernels::OrientedPoints oriented{points.col(0).data(),  points.col(1).data(),
                                         points.col(2).data(),  normals.col(0).data(),
                                         normals.col(1).data(), normals.col(2).data()};
  std::vector<std::int32_t> neighbours(kNeighbours);
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    neighbours[k] = static_cast<std::int32_t>(7 * k + 1);
  }
  std::int32_t counts[kernels::kPairAngles * kernels::kAngleRow] = {};
  for (auto _ : state) {
    kernels::count_pair_angles(oriented, 0, neighbours.data(), kNeighbours, counts);
    benchmark::DoNotOptimize(counts);
  }
  count_pairs(state, kNeighbours, 48.0 * kNeighbours);
}

/// Nine runs of 9 points, as in the grid of a surface; a third of them is near.
void time_near_points(benchmark::State& state, bool only_nearest) {
  constexpr std::int32_t kRun = 9;
  const Eigen::MatrixX3d& points = arrays().source;
  const kernels::PointColumns columns{points.col(0).data(), points.col(1).data(),
                                      points.col(2).data()};
  std::vector<kernels::PointRun> runs;
  for (std::int32_t r = 0; r < kRun; ++r) runs.push_back({100 * r, 100 * r + kRun});
  std::vector<std::int64_t> indices(kRun * kRun + kernels::NearPoints::kSlack);
  std::vector<double> squared_distances(indices.size());
  const double query[] = {0, 0, 0};
  for (auto _ : state) {
    if (only_nearest) {
      benchmark::DoNotOptimize(kernels::nearest_point(columns, runs, query, 0.2));
    } else {
      benchmark::DoNotOptimize(kernels::near_points(columns, runs, query, 0.2,
                                                    {indices.data(), squared_distances.data()}));
    }
  }
  count_pairs(state, kRun * kRun, 24.0 * kRun * kRun);
}

using Run = std::function<void(benchmark::State&)>;

void register_on_every_isa(const std::string& name, const Run& run) {
  for (const std::int64_t target : testing::available_isas()) {
    benchmark::RegisterBenchmark((name + "/" + hwy::TargetName(target)).c_str(),
                                 [run, target](benchmark::State& state) {
                                   const testing::ForcedIsa forced(target);
                                   run(state);
                                 });
  }
}

}  // namespace

void register_kernels() {
  const auto rows = [](double low, double high) {
    return [=](benchmark::State& state) { time_consistency_rows(state, low, high); };
  };
  const auto tiles = [](double low, double high, bool equal_bounds) {
    return [=](benchmark::State& state) { time_consistency_tiles(state, low, high, equal_bounds); };
  };
  const auto bit_rows = [](Index words, bool sum) {
    return [=](benchmark::State& state) { time_bit_rows(state, words, sum); };
  };
  register_on_every_isa("consistency_row/one_scale", rows(1, 1));
  register_on_every_isa("consistency_row/range", rows(0.9, 1));
  register_on_every_isa("consistency_tile/one_scale", tiles(1, 1, true));
  register_on_every_isa("consistency_tile/one_scale_many_bounds", tiles(1, 1, false));
  register_on_every_isa("consistency_tile/range", tiles(0.9, 1, true));
  register_on_every_isa("transpose", time_transpose);
  register_on_every_isa("squared_residuals", time_residuals);
  register_on_every_isa("consensus", time_consensus);
  register_on_every_isa("rotation_row", time_rotation_rows);
  register_on_every_isa("count_common_bits/4096", bit_rows(64, false));
  register_on_every_isa("count_common_bits/512", bit_rows(8, false));
  register_on_every_isa("sum_over_common_bits/4096", bit_rows(64, true));
  benchmark::RegisterBenchmark("clock", time_clock);
  register_on_every_isa("nearest_features", time_nearest_features);
  register_on_every_isa("squared_distances", time_squared_distances);
  register_on_every_isa("pair_angles", time_pair_angles);
  register_on_every_isa("near_points", [](auto& state) { time_near_points(state, false); });
  register_on_every_isa("nearest_point", [](auto& state) { time_near_points(state, true); });
}

}  // namespace gmcr::bench
