#include "clique/weighted/colouring.hpp"

#include <algorithm>
#include <limits>

namespace gmcr::clique {
void WeightedColoring::reset(RowsView graph, std::span<const std::int64_t> units,
                             SearchBudget& budget) {
  graph_ = graph;
  units_ = units;
  budget_ = &budget;
  uncolored_.resize(graph.words_per_row);
  free_.resize(graph.words_per_row);
  left_.resize(graph.num_vertices);
}

void WeightedColoring::start(const Word* candidates, Splitting splitting) {
  Index num_candidates = 0;
  for (Index w = 0; w < graph_.words_per_row; ++w) {
    uncolored_[w] = candidates[w];
    for (Word rest = candidates[w]; rest != 0; rest &= rest - 1) {
      const Index v = w * kBitsPerWord + std::countr_zero(rest);
      left_[v] = units_[v];
      ++num_candidates;
    }
  }
  const Index effort = splitting == Splitting::Full ? kMaxSplitEffort : 0;
  split_words_left_ = effort * num_candidates * graph_.words_per_row;
  first_word_ = 0;
  cost_ = 0;
}

/// Fills class_ with one more independent set, which is empty where all is coloured. First come the
/// vertices that it leaves nothing of.
void WeightedColoring::take_class() {
  const Index words = graph_.words_per_row;
  class_.clear();
  num_done_ = 0;
  while (first_word_ < words && uncolored_[first_word_] == 0) ++first_word_;
  std::copy(uncolored_.begin() + first_word_, uncolored_.end(), free_.begin() + first_word_);
  std::int64_t lightest = std::numeric_limits<std::int64_t>::max(), heaviest = 0;
  for (Index w = first_word_; w < words; ++w) {
    while (free_[w] != 0) {
      const Index v = w * kBitsPerWord + std::countr_zero(free_[w]);
      const Word* row = graph_.row(v);
      for (Index i = w; i < words; ++i) free_[i] &= ~row[i];
      clear_bit(free_.data(), v);
      class_.push_back(v);
      lightest = std::min(lightest, left_[v]);
      heaviest = std::max(heaviest, left_[v]);
    }
  }
  const Index size = static_cast<Index>(class_.size());
  if (lightest < heaviest) split_words_left_ -= size * words;
  const std::int64_t part = split_words_left_ > 0 ? lightest : heaviest;
  cost_ += size > 0 ? part : 0;
  for (Index& v : class_) {
    left_[v] -= std::min(part, left_[v]);
    if (left_[v] > 0) continue;
    clear_bit(uncolored_.data(), v);
    std::swap(v, class_[num_done_++]);
  }
  budget_->spend_work((size + 1) * words);
}

bool WeightedColoring::select(const Word* candidates, std::int64_t max_pruned, Splitting splitting,
                              std::vector<WeightedBranch>& branches) {
  start(candidates, splitting);
  bool is_clique = true;
  for (take_class(); !class_.empty(); take_class()) {
    is_clique = is_clique && class_.size() == 1;
    if (cost_ > max_pruned) {
      for (Index i = 0; i < num_done_; ++i) branches.push_back({class_[i], cost_});
    }
    if (budget_->spent()) {
      is_clique = false;
      for_each_bit(uncolored_.data(), graph_.words_per_row, [&](Index v) {
        cost_ += left_[v];
        if (cost_ > max_pruned) branches.push_back({v, cost_});
      });
      break;
    }
  }
  return is_clique;
}

bool WeightedColoring::covers(const Word* candidates, std::int64_t max_units) {
  start(candidates, Splitting::None);
  do {
    take_class();
    if (cost_ > max_units || budget_->spent()) return false;
  } while (!class_.empty());
  return true;
}

std::int64_t WeightedColoring::bound(const Word* candidates) {
  const Index words = graph_.words_per_row;
  std::vector<Index> rest;
  for_each_bit(candidates, words, [&](Index v) { rest.push_back(v); });
  std::stable_sort(rest.begin(), rest.end(),
                   [&](Index a, Index b) { return units_[a] > units_[b]; });
  std::int64_t cost = 0;
  while (!rest.empty() && !budget_->spent()) {
    cost += units_[rest.front()];
    std::fill(free_.begin(), free_.end(), ~Word{0});
    Index num_taken = 0;
    std::erase_if(rest, [&](Index v) {
      if (!test_bit(free_.data(), v)) return false;
      const Word* row = graph_.row(v);
      for (Index w = 0; w < words; ++w) free_[w] &= ~row[w];
      ++num_taken;
      return true;
    });
    budget_->spend_work((num_taken + 1) * words + static_cast<Index>(rest.size()));
  }
  for (const Index v : rest) cost += units_[v];
  return cost;
}

}  // namespace gmcr::clique
