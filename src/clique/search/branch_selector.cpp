#include "clique/search/branch_selector.hpp"

#include <utility>

#include "kernels/branch_choice.hpp"

namespace gmcr::clique {
namespace {

// Measured on random graphs: below this density the repairs cost more than they save.
constexpr double kMinDensityToRepair = 0.4;
// The repairs of a node may take this many word operations, and some more a word of the graph: they
// pay with few classes, but their cost grows with the square of the number of classes.
constexpr Index kMinRepairWork = Index{1} << 22;
constexpr Index kRepairWorkPerWord = 4;
constexpr Index kNumRows = 4, kNumTallies = 3, kNumLists = 9;  // of scratch memory

double density(RowsView graph) {
  const Index n = graph.num_vertices;
  const Index ends = count_bits(graph.words, n * graph.words_per_row);
  return n < 2 ? 0.0 : static_cast<double>(ends) / (static_cast<double>(n) * (n - 1));
}

bool spend(void* budget, Index num_words) {
  return static_cast<SearchBudget*>(budget)->spend_work(num_words);
}

}  // namespace

void BranchSelector::reset(const PackedGraph& graph) {
  graph_ = graph.view();
  repairs_ = density(graph_) >= kMinDensityToRepair;
  rows_.resize(kNumRows * graph_.words_per_row + kNumTallies * graph_.num_vertices);
  // one more, as a list may be written to behind its end
  lists_.resize(kNumLists * (graph_.num_vertices + 1));
}

bool BranchSelector::select(const Word* candidates, Index max_pruned, SearchBudget& budget,
                            std::vector<Branch>& branches, std::span<const Index> seeds) {
  kernels::BranchChoice choice;
  choice.rows = graph_.words;
  choice.candidates = candidates;
  choice.num_words = graph_.words_per_row;
  choice.max_classes = std::clamp<Index>(max_pruned, 0, graph_.num_vertices);
  choice.repairs = repairs_;
  choice.max_repair_work =
      std::max(kMinRepairWork, kRepairWorkPerWord * graph_.num_vertices * graph_.words_per_row);
  choice.seeds = seeds.data();
  choice.num_seeds = static_cast<Index>(seeds.size());
  choice.spend = spend;
  choice.budget = &budget;
  Word* row = rows_.data();
  for (Word** scratch : {&choice.uncolored, &choice.free, &choice.in_use, &choice.compatible}) {
    *scratch = std::exchange(row, row + graph_.words_per_row);
  }
  for (Word** scratch : {&choice.members, &choice.compatible_members, &choice.other_members}) {
    *scratch = std::exchange(row, row + graph_.num_vertices);
  }
  std::int32_t* list = lists_.data();
  for (std::int32_t** scratch :
       {&choice.first_member, &choice.unit_vertices, &choice.unit_classes, &choice.involved,
        &choice.class_of, &choice.next_member, &choice.removed_by, &choice.branch_vertices,
        &choice.branch_bounds}) {
    *scratch = std::exchange(list, list + graph_.num_vertices + 1);
  }
  kernels::choose_branches(choice);
  for (Index i = 0; i < choice.num_branches; ++i) {
    branches.push_back({choice.branch_vertices[i], choice.branch_bounds[i]});
  }
  return choice.is_clique;
}

}  // namespace gmcr::clique
