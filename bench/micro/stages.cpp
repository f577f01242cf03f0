// The stages of a solve, one at a time where they stand alone; the others, such as the votes for a
// scale and the poses of cliques, are counters of the whole solve.
#include <map>
#include <string>
#include <vector>

#include "clique/clique.hpp"
#include "gmcr/registration.hpp"
#include "micro/themes.hpp"
#include "problem/graph/consistency_graph.hpp"
#include "problem/graph/symmetric_blocks.hpp"
#include "problem/objective/objective.hpp"

namespace gmcr::bench {
namespace {

constexpr double kRate = 0.95;  // of outliers

BitsetGraph graph_of(const problem::Correspondences& correspondences) {
  return problem::consistency_graph(problem::consistency_arrays(correspondences, 1), {1, 1}, 1);
}

double pairs_of(Index count) { return 0.5 * static_cast<double>(count * (count - 1)); }

double bytes_of(const BitsetGraph& graph) {
  return static_cast<double>(BitsetGraph::bytes_required(graph.num_vertices()));
}

void time_graph(benchmark::State& state, double scale_min) {
  const auto arrays = problem::consistency_arrays(random_correspondences(state.range(0), kRate), 1);
  BitsetGraph graph;
  for (auto _ : state) graph = problem::consistency_graph(arrays, {scale_min, 1}, 1);
  count_pairs(state, pairs_of(state.range(0)), bytes_of(graph));
}

void time_mirror(benchmark::State& state) {
  BitsetGraph graph = graph_of(random_correspondences(state.range(0), kRate));
  for (auto _ : state) problem::mirror_upper_blocks(graph, 1);
  count_pairs(state, pairs_of(state.range(0)), bytes_of(graph));
}

void time_degeneracy(benchmark::State& state) {
  const BitsetGraph graph = graph_of(random_correspondences(state.range(0), kRate));
  for (auto _ : state) benchmark::DoNotOptimize(clique::core_order(graph).data());
  count_pairs(state, pairs_of(state.range(0)), bytes_of(graph));
}

void time_max_clique(benchmark::State& state) {
  const BitsetGraph graph = graph_of(random_correspondences(state.range(0), kRate));
  for (auto _ : state) benchmark::DoNotOptimize(max_clique(graph).vertices.data());
}

void time_max_weight_clique(benchmark::State& state) {
  const problem::Correspondences correspondences = random_correspondences(state.range(0), kRate);
  const BitsetGraph graph = graph_of(correspondences);
  const problem::Objective objective(correspondences, Evidence::Distinct, std::size_t{1} << 30);
  std::vector<double> weights;
  for (Index i = 0; i < correspondences.size(); ++i) weights.push_back(objective.weight(i, 1));
  for (auto _ : state) benchmark::DoNotOptimize(max_weight_clique(graph, weights).vertices.data());
}

void time_evidence(benchmark::State& state) {
  const problem::Correspondences correspondences = random_correspondences(state.range(0), kRate);
  for (auto _ : state) {
    const problem::Objective objective(correspondences, Evidence::Distinct, std::size_t{1} << 30);
    benchmark::DoNotOptimize(objective.is_weighted());
  }
}

void time_judge(benchmark::State& state) {
  const problem::Correspondences correspondences = random_correspondences(state.range(0), kRate);
  const problem::Objective objective(correspondences, Evidence::Distinct, std::size_t{1} << 30);
  for (auto _ : state) benchmark::DoNotOptimize(objective.judge({Similarity()}).evidence);
  count_pairs(state, static_cast<double>(state.range(0)),
              56.0 * static_cast<double>(state.range(0)));
}

void time_solve(benchmark::State& state, ScaleMode scale_mode) {
  const problem::Correspondences correspondences = random_correspondences(state.range(0), kRate);
  Options options;
  options.noise_bound = correspondences.bounds[0];
  options.scale_mode = scale_mode;
  options.num_threads = 1;
  std::map<std::string, double> milliseconds;
  for (auto _ : state) {
    const Result result =
        register_correspondences(correspondences.source, correspondences.target, options);
    for (const StageTime& stage : result.diagnostics.stages) {
      milliseconds[stage.name] += 1e3 * stage.seconds;
    }
  }
  for (const auto& [name, total] : milliseconds) {
    state.counters[name + "_ms"] = total / static_cast<double>(state.iterations());
  }
}

}  // namespace

void register_stages() {
  using benchmark::RegisterBenchmark;
  constexpr auto kUnit = benchmark::kMillisecond;
  const auto graph = [](double scale_min) {
    return [=](benchmark::State& state) { time_graph(state, scale_min); };
  };
  const auto solve = [](ScaleMode mode) {
    return [=](benchmark::State& state) { time_solve(state, mode); };
  };
  RegisterBenchmark("stage/graph/one_scale", graph(1))
      ->Arg(1000)
      ->Arg(5000)
      ->Arg(20000)
      ->Unit(kUnit);
  RegisterBenchmark("stage/graph/range", graph(0.9))->Arg(1000)->Arg(5000)->Unit(kUnit);
  RegisterBenchmark("stage/mirror", time_mirror)->Arg(5000)->Unit(kUnit);
  RegisterBenchmark("stage/degeneracy", time_degeneracy)->Arg(1000)->Arg(5000)->Unit(kUnit);
  RegisterBenchmark("stage/max_clique", time_max_clique)->Arg(1000)->Arg(5000)->Unit(kUnit);
  RegisterBenchmark("stage/max_weight_clique", time_max_weight_clique)->Arg(1000)->Unit(kUnit);
  RegisterBenchmark("stage/evidence", time_evidence)->Arg(1000)->Arg(5000)->Unit(kUnit);
  RegisterBenchmark("stage/judge", time_judge)->Arg(1000)->Arg(5000);
  RegisterBenchmark("solve/known_scale", solve(ScaleMode::Known))
      ->Arg(1000)
      ->Arg(5000)
      ->Unit(kUnit);
  RegisterBenchmark("solve/unknown_scale", solve(ScaleMode::Estimated))->Arg(500)->Unit(kUnit);
}

}  // namespace gmcr::bench
