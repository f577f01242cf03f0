#pragma once

#include <benchmark/benchmark.h>

#include "problem/correspondences.hpp"

namespace gmcr::bench {

/// Each of these registers the benchmarks of one theme.
void register_kernels();
void register_stages();

/// Correspondences of `rate` outliers, noise bound 0.01 m, in a cube of 1 m.
problem::Correspondences random_correspondences(Index count, double rate);

/// Counters of a benchmark that treats `pairs` pairs an iteration, writing or reading `bytes`.
inline void count_pairs(benchmark::State& state, double pairs, double bytes) {
  using benchmark::Counter;
  state.counters["time/pair"] =
      Counter(pairs, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["pairs"] = Counter(pairs, Counter::kIsIterationInvariantRate);
  state.counters["bytes"] =
      Counter(bytes, Counter::kIsIterationInvariantRate, Counter::OneK::kIs1024);
}

}  // namespace gmcr::bench
