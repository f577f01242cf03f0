#include "clique/graph/colouring.hpp"

#include "clique/graph/search_budget.hpp"

namespace gmcr::clique {
namespace {

/// Takes one independent set out of `uncolored`, smallest indices first, from vertex `first` if it
/// is >= 0, and calls visit(v) for each member. `free` is scratch.
template <typename Visit>
void take_class(RowsView graph, Word* uncolored, Word* free, Index first, Visit visit) {
  const Index words = graph.words_per_row;
  std::copy(uncolored, uncolored + words, free);
  const auto take = [&](Index v, Index from_word) {
    const Word* row = graph.row(v);
    for (Index w = from_word; w < words; ++w) free[w] &= ~row[w];
    clear_bit(free, v);
    clear_bit(uncolored, v);
    visit(v);
  };
  if (first >= 0) take(first, 0);
  for (Index w = 0; w < words; ++w) {
    while (free[w] != 0) take(w * kBitsPerWord + std::countr_zero(free[w]), w);
  }
}

}  // namespace

Coloring color_greedily(RowsView graph, std::span<const Word> subset, std::span<const Index> seeds,
                        SearchBudget* budget) {
  Coloring result;
  std::vector<Word> uncolored(subset.begin(), subset.end());
  std::vector<Word> free(subset.size());
  std::size_t next_seed = 0;
  while (any_bit(uncolored.data(), graph.words_per_row)) {
    Index seed = next_seed < seeds.size() ? seeds[next_seed] : -1;
    ++next_seed;
    if (seed >= 0 && !test_bit(uncolored.data(), seed)) seed = -1;
    const auto add_to_class = [&](Index v) {
      result.order.push_back(v);
      result.color.push_back(result.num_colors);
    };
    const std::size_t class_begin = result.order.size();
    take_class(graph, uncolored.data(), free.data(), seed, add_to_class);
    ++result.num_colors;
    const Index class_size = static_cast<Index>(result.order.size() - class_begin);
    if (budget && !budget->spend_work((class_size + 1) * graph.words_per_row)) {
      for_each_bit(uncolored.data(), graph.words_per_row, [&](Index v) {
        add_to_class(v);
        ++result.num_colors;
      });
      break;
    }
  }
  return result;
}

bool colors_with(RowsView graph, std::span<const Word> subset, Index max_colors,
                 std::vector<Word>& scratch, SearchBudget* budget) {
  const Index words = graph.words_per_row;
  scratch.resize(2 * subset.size());
  std::copy(subset.begin(), subset.end(), scratch.begin());
  Word* uncolored = scratch.data();
  for (Index c = 0; c < max_colors && any_bit(uncolored, words); ++c) {
    Index class_size = 0;
    take_class(graph, uncolored, uncolored + words, -1, [&](Index) { ++class_size; });
    if (budget && !budget->spend_work((class_size + 1) * words)) return false;
  }
  return !any_bit(uncolored, words);
}

}  // namespace gmcr::clique
