#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

#include "clique/weighted/greedy.hpp"
#include "clique/weighted/root_search.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

constexpr int kNumGreedyStarts = 16;
constexpr int kNumGreedyStartsOfProof = 2;  // where most likely no clique is heavy enough

/// Steps from cheap to costly, each of which may settle the question.
class WeightSolver {
 public:
  WeightSolver(const BitsetGraph& graph, const FixedPointWeights& weights,
               const WeightedCliqueOptions& options)
      : graph_(graph),
        weights_(weights),
        incumbent_(weights, options.must_exceed),
        budget_(parallel::Deadline(options.time_limit, options.stop), options.max_nodes,
                options.max_work),
        num_threads_(options.num_threads),
        max_memory_(options.max_memory),
        upper_bound_(weights.total()) {}

  WeightedCliqueResult solve(std::span<const double> weights) {
    const bool asks_for_proof = incumbent_.to_beat() > 0;
    if (!settled()) offer_heaviest_vertex();
    // Most likely nothing exceeds a given weight: a bound may show it without any clique.
    if (!settled()) peel_graph();
    if (!settled()) bound_by_colours();
    if (!settled()) grow_cliques(asks_for_proof ? kNumGreedyStartsOfProof : kNumGreedyStarts);
    if (!settled()) search_survivors();
    WeightedCliqueResult result;
    result.vertices = incumbent_.clique();
    std::sort(result.vertices.begin(), result.vertices.end());
    for (const Index v : result.vertices) result.weight += weights[v];
    result.upper_bound = std::max(result.weight, weights_.weight_of(upper_bound_));
    result.proven_optimal = upper_bound_ <= incumbent_.to_beat();
    result.nodes = budget_.nodes();
    return result;
  }

 private:
  bool settled() { return upper_bound_ <= incumbent_.to_beat() || budget_.out_of_time(); }
  void lower_bound_to(std::int64_t bound) { upper_bound_ = std::min(upper_bound_, bound); }

  void offer_heaviest_vertex() {
    const auto units = weights_.units();
    incumbent_.offer({std::max_element(units.begin(), units.end()) - units.begin()});
  }

  void peel_graph() {
    peeling_.reset(graph_, weights_.units(), incumbent_.to_beat(), budget_, num_threads_);
    peel();
  }

  void peel() {
    peeling_.peel(incumbent_.to_beat());
    lower_bound_to(std::max(incumbent_.to_beat(), peeling_.heaviest_neighbourhood()));
  }

  void bound_by_colours() {
    WeightedColouring colouring;
    colouring.reset(graph_, weights_.units(), budget_);
    lower_bound_to(std::max(incumbent_.to_beat(), colouring.bound(peeling_.alive().data())));
  }

  /// From the heaviest neighbourhoods that no clique so far covers.
  void grow_cliques(int num_starts) {
    std::vector<char> covered(graph_.num_vertices, 0);
    std::vector<Word> candidates(graph_.words_per_row);
    for (int i = 0; i < num_starts && !settled(); ++i) {
      Index start = -1;
      for_each_bit(peeling_.alive().data(), graph_.words_per_row, [&](Index v) {
        if (covered[v]) return;
        if (start < 0 || peeling_.neighbourhoods()[v] > peeling_.neighbourhoods()[start]) start = v;
      });
      if (start < 0) return;
      const Word* row = graph_.row(start);
      for (Index w = 0; w < graph_.words_per_row; ++w) candidates[w] = row[w] & peeling_.alive()[w];
      std::vector<Index> clique = greedy_heavy_clique(graph_, weights_.units(), start, candidates,
                                                      peeling_.neighbourhoods(), budget_);
      for (const Index v : clique) covered[v] = 1;
      incumbent_.offer(std::move(clique));
      peel();
    }
  }

  /// Branch and bound on what is left, if it may be copied and its first colouring can be paid:
  /// else the copy would be all that comes of it.
  void search_survivors() {
    const Index count = peeling_.num_alive();
    if (PackedGraph::bytes_required(count) > max_memory_) return;
    if (WeightedColouring::most_work(count, words_for_bits(count)) > budget_.work_left()) return;
    std::vector<Index> order = best_first_order(peeling_);
    // The classes of a colouring that starts with a clique fit it.
    std::vector<char> known(graph_.num_vertices, 0);
    for (const Index v : incumbent_.clique()) known[v] = 1;
    std::stable_partition(order.begin(), order.end(), [&](Index v) { return known[v]; });
    OrderedPart part;
    if (!part.assign(graph_, weights_.units(), order, budget_)) return;
    lower_bound_to(WeightedRootSearch(part, incumbent_, budget_).run());
  }

  RowsView graph_;
  const FixedPointWeights& weights_;
  WeightedIncumbent incumbent_;
  SearchBudget budget_;
  int num_threads_;
  std::size_t max_memory_;
  std::int64_t upper_bound_;
  WeightedPeeling peeling_;
};

bool are_equal(std::span<const std::int64_t> units) {
  return std::adjacent_find(units.begin(), units.end(), std::not_equal_to<>()) == units.end();
}

/// With equal weights the heaviest clique is the largest, which takes less to find.
WeightedCliqueResult solve_equal_weights(const BitsetGraph& graph, std::span<const double> weights,
                                         const FixedPointWeights& fixed,
                                         const WeightedCliqueOptions& options) {
  const std::int64_t unit = fixed.units().front();
  const std::int64_t to_beat = fixed.rounding().to_beat(fixed.units_of(options.must_exceed));
  CliqueOptions size_options;
  size_options.time_limit = options.time_limit;
  size_options.max_nodes = options.max_nodes;
  size_options.must_exceed = static_cast<Index>(to_beat / unit);
  size_options.stop = options.stop;
  size_options.num_threads = options.num_threads;
  size_options.max_memory = options.max_memory;
  CliqueResult largest = max_clique(graph, size_options);
  WeightedCliqueResult result;
  result.vertices = std::move(largest.vertices);
  for (const Index v : result.vertices) result.weight += weights[v];
  const Index max_size = std::min(largest.upper_bound, graph.num_vertices());
  result.upper_bound = std::max(result.weight, fixed.weight_of(max_size * unit));
  result.proven_optimal = largest.proven_optimal;
  result.nodes = largest.nodes;
  return result;
}

}  // namespace
}  // namespace gmcr::clique

namespace gmcr {

WeightedCliqueResult max_weight_clique(const BitsetGraph& graph, std::span<const double> weights,
                                       const WeightedCliqueOptions& options) {
  options.validate();
  if (static_cast<Index>(weights.size()) != graph.num_vertices()) {
    throw std::invalid_argument("weights: " + std::to_string(weights.size()) + " values for " +
                                std::to_string(graph.num_vertices()) + " vertices");
  }
  const clique::FixedPointWeights fixed(weights);
  if (fixed.total() > 0 && clique::are_equal(fixed.units())) {
    return clique::solve_equal_weights(graph, weights, fixed, options);
  }
  return clique::WeightSolver(graph, fixed, options).solve(weights);
}

}  // namespace gmcr
