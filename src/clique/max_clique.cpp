#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

#include "clique/coloring.hpp"
#include "clique/complement.hpp"
#include "clique/complement_search.hpp"
#include "clique/degeneracy.hpp"
#include "clique/greedy.hpp"
#include "clique/root_search.hpp"
#include "gmcr/clique.hpp"

namespace gmcr {
namespace {

constexpr int kNumGreedyStarts = 16;
// A renumbered copy of the surviving vertices pays unless it doubles a large memory.
constexpr Index kMaxWordsOfFullCopy = Index{1} << 23;  // 64 MiB

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
class Solver {
 public:
  Solver(const BitsetGraph& graph, const CliqueOptions& options)
      : graph_(graph),
        incumbent_(checked_clique(graph, options.initial_clique), options.must_exceed),
        budget_(options.time_limit, options.max_nodes),
        must_exceed_(options.must_exceed),
        upper_bound_(graph.num_vertices()) {}

  CliqueResult solve() {
    if (!settled()) bound_by_degrees();
    // Most likely nothing exceeds a given size: a colouring may show it without any clique.
    if (!settled() && must_exceed_ > 0) bound_by_colors();
    if (!settled()) grow_first_clique();
    if (!settled()) bound_by_colors();
    if (!settled()) bound_by_cores();
    if (!settled()) grow_cliques();
    if (!settled()) search_core();
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
    degree_.resize(graph_.num_vertices);
    std::vector<Index> num_with_degree(graph_.num_vertices, 0);
    for (Index v = 0; v < graph_.num_vertices; ++v) {
      degree_[v] = graph_.degree(v);
      ++num_with_degree[degree_[v]];
    }
    Index degree = graph_.num_vertices - 1, num_at_least = num_with_degree[degree];
    while (num_at_least <= degree) num_at_least += num_with_degree[--degree];
    lower_bound_to(degree + 1);
  }

  void grow_first_clique() {
    const auto start = std::max_element(degree_.begin(), degree_.end());
    incumbent_.offer(greedy_clique_by_candidates(graph_, start - degree_.begin(), degree_));
  }

  void bound_by_colors() {
    std::vector<Word> all(graph_.words_per_row, 0);
    for (Index v = 0; v < graph_.num_vertices; ++v) set_bit(all.data(), v);
    lower_bound_to(color_greedily(graph_, all, incumbent_.clique(), &budget_).num_colors);
  }

  void bound_by_cores() {
    cores_ = degeneracy_order(graph_, &budget_);
    lower_bound_to(cores_.degeneracy + 1);
  }

  void grow_cliques() {
    // Starts of high core number that no clique so far contains.
    std::vector<char> covered(graph_.num_vertices, 0);
    int num_starts = 0;
    for (auto v = cores_.order.rbegin(); v != cores_.order.rend(); ++v) {
      if (covered[*v]) continue;
      if (settled() || num_starts++ == kNumGreedyStarts) return;
      std::vector<Index> clique = greedy_clique_by_candidates(graph_, *v, cores_.core);
      for (const Index u : clique) covered[u] = 1;
      incumbent_.offer(std::move(clique));
    }
  }

  /// Branch and bound on the vertices whose core number admits a better clique.
  void search_core() {
    std::vector<Index> survivors;
    for (auto v = cores_.order.rbegin(); v != cores_.order.rend(); ++v) {
      if (cores_.core[*v] >= incumbent_.to_beat()) survivors.push_back(*v);
    }
    const Index count = static_cast<Index>(survivors.size());
    const bool copies =
        count * words_for_bits(count) <= kMaxWordsOfFullCopy || 2 * count <= graph_.num_vertices;
    if (!copies) {
      lower_bound_to(RootSearch(graph_, cores_.core, incumbent_, budget_).run());
      return;
    }
    PackedGraph packed;
    if (!packed.assign(graph_, survivors, &budget_)) return;
    std::vector<Index> core(survivors.size());
    std::vector<Index> number(graph_.num_vertices, -1);
    for (Index i = 0; i < count; ++i) {
      core[i] = cores_.core[survivors[i]];
      number[survivors[i]] = i;
    }
    // The incumbent within the survivors: a clique, if maybe a smaller one.
    std::vector<Index> known;
    for (const Index v : incumbent_.clique()) {
      if (number[v] >= 0) known.push_back(number[v]);
    }
    Incumbent packed_incumbent(std::move(known), incumbent_.to_beat());
    lower_bound_to(is_nearly_complete(packed.view())
                       ? ComplementSearch(packed.view(), packed_incumbent, budget_).run()
                       : RootSearch(packed.view(), core, packed_incumbent, budget_).run());
    std::vector<Index> clique;
    for (const Index v : packed_incumbent.clique()) clique.push_back(packed.original(v));
    incumbent_.offer(std::move(clique));
  }

  RowsView graph_;
  Incumbent incumbent_;
  SearchBudget budget_;
  Index must_exceed_;
  Index upper_bound_;
  std::vector<Index> degree_;
  Degeneracy cores_;
};

}  // namespace

void CliqueOptions::validate() const {
  if (std::isnan(time_limit) || time_limit < 0) {
    throw std::invalid_argument("time_limit: " + std::to_string(time_limit) +
                                " is no number of seconds >= 0");
  }
  if (must_exceed < 0) {
    throw std::invalid_argument("must_exceed: " + std::to_string(must_exceed) + " is negative");
  }
}

CliqueResult max_clique(const BitsetGraph& graph, const CliqueOptions& options) {
  options.validate();
  return Solver(graph, options).solve();
}

}  // namespace gmcr
