#include "problem/run.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace gmcr::problem {
namespace {

/// Word operations that a clique search may take: what small graphs need, and passes over large
/// ones.
std::uint64_t max_work(const BitsetGraph& graph, int log2_least, std::uint64_t passes) {
  return (std::uint64_t{1} << log2_least) + passes *
                                                static_cast<std::uint64_t>(graph.num_vertices()) *
                                                static_cast<std::uint64_t>(graph.words_per_row());
}

/// To find a clique.
std::uint64_t work_to_find(const BitsetGraph& graph) { return max_work(graph, 18, 1); }

/// Of a search by weight whose bound is asked for.
std::uint64_t work_to_bound(const BitsetGraph& graph) { return max_work(graph, 22, 4); }

/// Bytes that the graph leaves of the budget to copies of parts of it: half of the rest, at most
/// half as many as it takes itself and some more.
std::size_t memory_left(const BitsetGraph& graph, std::size_t budget) {
  constexpr std::size_t kSome = std::size_t{1} << 26;
  const std::size_t bytes = BitsetGraph::bytes_required(graph.num_vertices());
  return std::min((budget - std::min(budget, bytes)) / 2, bytes / 2 + kSome);
}

}  // namespace

LimitHit search_of_a_sample(Limit limit) {
  return {limit, std::string(limit == Limit::Memory ? "the memory budget" : "the time budget") +
                     " does not suffice for the graph of all correspondences: a sample of them was "
                     "searched, and no number of inliers below that of all is excluded"};
}

LimitHit evidence_counted() {
  return {Limit::EvidenceSearch, "inliers were counted, as only a sample of them was searched"};
}

LimitHit weights_incomplete() {
  return {Limit::Memory,
          "the memory budget does not suffice for distinct evidence: inliers were counted"};
}

Run::Run(const Options& options) : options_(options), deadline_(options.time_limit, options.stop) {}

bool Run::stopped() {
  if (cancelled()) {
    limit({Limit::Stopped, "the caller stopped the search"});
    return true;
  }
  if (!deadline_.expired()) return false;
  limit({Limit::Time, "the time budget ended the search"});
  return true;
}

void Run::report(const char* stage, double fraction) {
  if (!options_.progress || cancelled_) return;
  cancelled_ = !options_.progress(Progress{stage, std::clamp(fraction, 0.0, 1.0)});
}

void Run::limit(const LimitHit& hit) {
  auto& limits = diagnostics_.limits_hit;
  if (std::find(limits.begin(), limits.end(), hit) == limits.end()) limits.push_back(hit);
}

Run::Clique Run::max_clique(const BitsetGraph& graph, Index must_exceed, std::uint64_t max_nodes) {
  Clique clique = find_max_clique(graph, must_exceed, max_nodes, options_.num_threads);
  note(clique);
  return clique;
}

Run::Clique Run::find_max_clique(const BitsetGraph& graph, Index must_exceed,
                                 std::uint64_t max_nodes, int num_threads) const {
  // the graph itself may have been cut short, so that its bounds say nothing
  if (has_ended()) return {{}, static_cast<double>(graph.num_vertices()), false};
  CliqueOptions clique_options;
  clique_options.time_limit = deadline_.remaining();
  clique_options.stop = options_.stop;
  clique_options.max_nodes = max_nodes;
  // a proof is worth more work only where it is asked for
  if (!options_.certify) clique_options.max_work = work_to_find(graph);
  clique_options.must_exceed = must_exceed;
  clique_options.num_threads = num_threads;
  clique_options.max_memory = memory_left(graph, options_.memory_limit);
  CliqueResult found = options_.clique_solver ? options_.clique_solver->solve(graph, clique_options)
                                              : gmcr::max_clique(graph, clique_options);
  const bool is_larger = static_cast<Index>(found.vertices.size()) > must_exceed;
  if (!is_larger) found.vertices.clear();
  const auto upper_bound =
      static_cast<double>(found.proven_optimal && !is_larger ? must_exceed : found.upper_bound);
  return {std::move(found.vertices), upper_bound, found.proven_optimal, found.nodes};
}

Run::Clique Run::find_max_weight_clique(const BitsetGraph& graph, std::span<const double> weights,
                                        double must_exceed, std::uint64_t max_nodes,
                                        int num_threads) const {
  if (has_ended()) {
    return {{}, std::accumulate(weights.begin(), weights.end(), 0.0) * (1 + 1e-9), false};
  }
  WeightedCliqueOptions clique_options;
  clique_options.time_limit = deadline_.remaining();
  clique_options.stop = options_.stop;
  clique_options.max_nodes = max_nodes;
  clique_options.max_work = options_.certify ? work_to_bound(graph) : work_to_find(graph);
  clique_options.max_memory = memory_left(graph, options_.memory_limit);
  clique_options.must_exceed = must_exceed;
  clique_options.num_threads = num_threads;
  WeightedCliqueResult found = gmcr::max_weight_clique(graph, weights, clique_options);
  const bool is_heavier = found.weight > must_exceed;
  if (!is_heavier) found.vertices.clear();
  const double upper_bound = found.proven_optimal && !is_heavier ? must_exceed : found.upper_bound;
  return {std::move(found.vertices), upper_bound, found.proven_optimal, found.nodes};
}

void Run::note(const Clique& clique) {
  diagnostics_.num_clique_nodes += clique.nodes;
  if (!clique.proven) stopped();
}

Index Run::num_in_memory() const {
  Index fits = 0, exceeds = Index{1} << 31;  // 2^59 bytes
  while (exceeds - fits > 1) {
    const Index middle = (fits + exceeds) / 2;
    (BitsetGraph::bytes_required(middle) <= options_.memory_limit ? fits : exceeds) = middle;
  }
  return fits;
}

void Run::add_work(const Diagnostics& part) {
  diagnostics_.num_candidates += part.num_candidates;
  diagnostics_.num_scale_ranges += part.num_scale_ranges;
  diagnostics_.num_clique_nodes += part.num_clique_nodes;
  for (const StageTime& stage : part.stages) add_stage_time(stage.name.c_str(), stage.seconds);
}

void Run::require_memory_for_graph(Index num_vertices) const {
  const std::size_t bytes = BitsetGraph::bytes_required(num_vertices);
  if (bytes <= options_.memory_limit) return;
  throw InvalidOption("memory_limit", std::to_string(options_.memory_limit) +
                                          " bytes, but the consistency graph of " +
                                          std::to_string(num_vertices) + " correspondences takes " +
                                          std::to_string(bytes));
}

void Run::add_stage_time(const char* stage, double seconds) {
  for (StageTime& known : diagnostics_.stages) {
    if (known.name == stage) {
      known.seconds += seconds;
      return;
    }
  }
  diagnostics_.stages.push_back({stage, seconds});
}

Diagnostics Run::record() const {
  Diagnostics record = diagnostics_;
  record.total_seconds = clock_.elapsed();
  return record;
}

}  // namespace gmcr::problem
