#include "clique/nearly_complete/complement_search.hpp"

#include "clique/graph/colouring.hpp"
#include "clique/graph/degeneracy.hpp"
#include "clique/nearly_complete/complement_kernel.hpp"
#include "clique/search/local_search.hpp"

namespace gmcr::clique {
namespace {

// Steps of the local search a pair that is no edge: few to begin with, then enough to level off on
// noisy inliers. Branch and bound settles small parts as fast.
constexpr Index kFewStepsPerMissing = 4, kManyStepsPerMissing = 64;
constexpr Index kSmallPart = 256;

Index num_missing(RowsView graph) {
  const Index n = graph.num_vertices;
  return n * (n - 1) - count_bits(graph.words, n * graph.words_per_row);
}

}  // namespace

Index ComplementSearch::run() {
  const ComplementKernel kernel = reduce_by_complement(graph_, budget_);
  std::vector<char> is_known(graph_.num_vertices, 0);
  for (const Index v : incumbent_.clique()) is_known[v] = 1;
  std::vector<Part> parts;
  Index bound = static_cast<Index>(kernel.taken.size());
  for (const std::vector<Index>& vertices : kernel.parts) {
    parts.push_back(prepare(vertices, is_known));
    bound += parts.back().bound;
  }
  const auto offer = [&] {
    std::vector<Index> clique = kernel.taken;
    for (const Part& part : parts) {
      for (const Index v : part.clique) clique.push_back(part.graph.original(v));
    }
    incumbent_.offer(std::move(clique));
  };
  offer();
  for (Part& part : parts) {
    if (bound <= incumbent_.to_beat() || budget_.spent()) break;
    bound -= part.bound;
    search(part, std::max<Index>(0, incumbent_.to_beat() - bound));
    bound += part.bound;
    offer();
  }
  return bound;
}

ComplementSearch::Part ComplementSearch::prepare(const std::vector<Index>& vertices,
                                                 const std::vector<char>& is_known) {
  Part part;
  part.bound = static_cast<Index>(vertices.size());
  PackedGraph unordered;
  if (!unordered.assign(graph_, vertices, &budget_)) return part;
  const Degeneracy cores = degeneracy_order(unordered.view(), &budget_);
  std::vector<Index> order;
  for (auto v = cores.order.rbegin(); v != cores.order.rend(); ++v) {
    order.push_back(unordered.original(*v));
    part.core.push_back(cores.core[*v]);
  }
  if (!part.graph.assign(graph_, order, &budget_)) return part;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (is_known[order[i]]) part.clique.push_back(static_cast<Index>(i));
  }
  part.bound = std::min(part.bound, cores.degeneracy + 1);
  bound_by_colors(part);
  const RowsView view = part.graph.view();
  for (const Index steps : {kFewStepsPerMissing, kManyStepsPerMissing}) {
    if (part.bound <= static_cast<Index>(part.clique.size())) break;
    if (steps == kManyStepsPerMissing && view.num_vertices <= kSmallPart) break;
    part.clique = improve_by_swaps(view, part.clique, steps * num_missing(view), budget_);
    bound_by_colors(part);
  }
  return part;
}

void ComplementSearch::bound_by_colors(Part& part) {
  const RowsView view = part.graph.view();
  std::vector<Word> all(view.words_per_row, 0);
  for (Index v = 0; v < view.num_vertices; ++v) set_bit(all.data(), v);
  part.bound = std::min(part.bound, color_greedily(view, all, part.clique, &budget_).num_colors);
}

void ComplementSearch::search(Part& part, Index must_exceed) {
  Incumbent incumbent(part.clique, must_exceed);
  const Index bound = RootSearch(part.graph, part.core, incumbent, budget_, num_threads_).run();
  part.bound = std::min(part.bound, std::max(bound, incumbent.size()));
  part.clique = incumbent.clique();
}

}  // namespace gmcr::clique
