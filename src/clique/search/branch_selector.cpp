#include "clique/search/branch_selector.hpp"

#include <algorithm>

namespace gmcr::clique {
namespace {

// Measured on random graphs: below this density the repairs cost more than they save.
constexpr double kMinDensityToRepair = 0.4;
// The repairs of a node may take this many word operations, and some more a word of the graph: they
// pay with few classes, but their cost grows with the square of the number of classes.
constexpr Index kMinRepairWork = Index{1} << 22;
constexpr Index kRepairWorkPerWord = 4;

double density(RowsView graph) {
  const Index n = graph.num_vertices;
  return n < 2 ? 0.0
               : static_cast<double>(graph.num_edge_ends()) / (static_cast<double>(n) * (n - 1));
}

}  // namespace

void BranchSelector::reset(const PackedGraph& graph) {
  graph_ = graph.view();
  repairs_ = density(graph_) >= kMinDensityToRepair;
  scratch_.resize(graph_.num_vertices);
}

bool BranchSelector::select(const Word* candidates, Index max_pruned, SearchBudget& budget,
                            std::vector<Branch>& branches, std::span<const Index> seeds) {
  kernels::BranchInput input;
  input.rows = graph_.words;
  input.candidates = candidates;
  input.num_words = graph_.words_per_row;
  input.max_classes = std::clamp<Index>(max_pruned, 0, graph_.num_vertices);
  input.repairs = repairs_;
  input.max_repair_work =
      std::max(kMinRepairWork, kRepairWorkPerWord * graph_.num_vertices * graph_.words_per_row);
  input.seeds = seeds;
  input.spend = [&budget](Index num_words) { return budget.spend_work(num_words); };
  const kernels::BranchChoice choice = kernels::choose_branches(input, scratch_);
  branches.insert(branches.end(), choice.branches.begin(), choice.branches.end());
  return choice.is_clique;
}

}  // namespace gmcr::clique
