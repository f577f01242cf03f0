#include <numeric>
#include <stdexcept>
#include <string>

#include "clique/graph/core_filter.hpp"
#include "clique/graph/degrees.hpp"
#include "clique/survivor_search.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::clique {
namespace {

constexpr Index kNumFirstStarts = 4;

/// The initial clique, ascending and checked against `graph`; any vertex where it is empty.
std::vector<Index> checked_clique(const BitsetGraph& graph, std::vector<Index> clique) {
  if (clique.empty() && graph.num_vertices() > 0) return {0};
  std::sort(clique.begin(), clique.end());
  std::vector<Word> members(graph.words_per_row(), 0);
  for (const Index v : clique) {
    if (v < 0 || v >= graph.num_vertices()) {
      throw std::invalid_argument("initial_clique: " + std::to_string(v) +
                                  " is no vertex of a graph of " +
                                  std::to_string(graph.num_vertices()));
    }
    const Word* row = graph.row(v).data();
    for (Index w = 0; w < graph.words_per_row(); ++w) {
      if ((members[w] & ~row[w]) == 0) continue;
      const Index u = w * kBitsPerWord + std::countr_zero(members[w] & ~row[w]);
      throw std::invalid_argument("initial_clique: {" + std::to_string(u) + ", " +
                                  std::to_string(v) + "} is no edge");
    }
    set_bit(members.data(), v);
  }
  return clique;
}

/// Steps from cheap to costly, each of which may settle the question.
class CliqueSolver {
 public:
  CliqueSolver(const BitsetGraph& graph, const CliqueOptions& options)
      : graph_(graph),
        incumbent_(checked_clique(graph, options.initial_clique), options.must_exceed),
        budget_(parallel::Deadline(options.time_limit, options.stop), options.max_nodes,
                options.max_work),
        must_exceed_(options.must_exceed),
        upper_bound_(graph.num_vertices()),
        num_threads_(options.num_threads),
        max_memory_(options.max_memory) {}

  CliqueResult solve() {
    if (!settled()) bound_by_degrees();
    // Most likely nothing exceeds a given size: bounds may show it without any clique.
    if (!settled() && must_exceed_ == 0) grow_first_cliques();
    if (!settled()) search_survivors();
    CliqueResult result;
    result.vertices = incumbent_.clique();
    std::sort(result.vertices.begin(), result.vertices.end());
    result.upper_bound = std::max(upper_bound_, incumbent_.size());
    result.proven_optimal = upper_bound_ <= incumbent_.to_beat();
    result.nodes = budget_.nodes();
    return result;
  }

 private:
  bool settled() { return upper_bound_ <= incumbent_.to_beat() || budget_.out_of_time(); }
  void lower_bound_to(Index bound) { upper_bound_ = std::min(upper_bound_, bound); }

  /// A clique of k + 1 vertices needs as many of degree k or more.
  void bound_by_degrees() {
    degree_ = degrees_of(graph_, num_threads_);
    std::vector<Index> num_with_degree(graph_.num_vertices, 0);
    for (const Index degree : degree_) ++num_with_degree[degree];
    Index degree = graph_.num_vertices - 1, num_at_least = num_with_degree[degree];
    while (num_at_least <= degree) num_at_least += num_with_degree[--degree];
    lower_bound_to(degree + 1);
  }

  void grow_first_cliques() {
    std::vector<Index> starts(graph_.num_vertices);
    std::iota(starts.begin(), starts.end(), Index{0});
    const auto by_degree = [&](Index a, Index b) {
      return degree_[a] != degree_[b] ? degree_[a] > degree_[b] : a < b;
    };
    const Index count = std::min(kNumFirstStarts, graph_.num_vertices);
    std::partial_sort(starts.begin(), starts.begin() + count, starts.end(), by_degree);
    starts.resize(count);
    grow_cliques(graph_, starts, degree_, incumbent_, budget_, upper_bound_);
  }

  void search_survivors() {
    const std::vector<Word> alive =
        drop_small_degrees(graph_, degree_, incumbent_.to_beat(), num_threads_, budget_);
    std::vector<Index> survivors;
    for_each_bit(alive.data(), graph_.words_per_row, [&](Index v) { survivors.push_back(v); });
    const Index count = static_cast<Index>(survivors.size());
    lower_bound_to(std::max(count, incumbent_.to_beat()));
    if (settled()) return;
    const std::size_t bytes = BitsetGraph::bytes_required(count);
    if (4 * count > 3 * graph_.num_vertices || bytes > max_memory_) {
      SurvivorSearch search(graph_, incumbent_, budget_, num_threads_, max_memory_);
      lower_bound_to(search.run(alive, must_exceed_ > 0));
      return;
    }
    PackedGraph packed;
    if (!packed.assign(graph_, survivors, &budget_)) return;
    Incumbent inner = incumbent_within(packed, graph_.num_vertices, incumbent_);
    std::vector<Word> all(packed.words_per_row(), 0);
    set_first_bits(all.data(), count);
    SurvivorSearch search(packed.view(), inner, budget_, num_threads_, max_memory_ - bytes);
    lower_bound_to(search.run(all, must_exceed_ > 0));
    incumbent_.offer(originals_of(packed, inner.clique()));
  }

  RowsView graph_;
  Incumbent incumbent_;
  SearchBudget budget_;
  Index must_exceed_;
  Index upper_bound_;
  int num_threads_;
  std::size_t max_memory_;
  std::vector<Index> degree_;
};

}  // namespace
}  // namespace gmcr::clique

namespace gmcr {

CliqueResult max_clique(const BitsetGraph& graph, const CliqueOptions& options) {
  options.validate();
  return clique::CliqueSolver(graph, options).solve();
}

}  // namespace gmcr
