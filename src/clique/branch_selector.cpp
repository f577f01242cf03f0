#include "clique/branch_selector.hpp"

namespace gmcr {
namespace {

// Measured on random graphs: below this density the repairs cost more than they save.
constexpr double kMinDensityToRepair = 0.4;
// The repairs of a node may take this many word operations, and some more a word of the graph: they
// pay with few classes, but their cost grows with the square of the number of classes.
constexpr Index kMinRepairWords = Index{1} << 22;
constexpr Index kRepairWordsPerWord = 4;

double density(RowsView graph) {
  const Index n = graph.num_vertices;
  const Index ends = count_bits(graph.words, n * graph.words_per_row);
  return n < 2 ? 0.0 : static_cast<double>(ends) / (static_cast<double>(n) * (n - 1));
}

enum class Overlap { None, WithFirst, WithBoth };

/// Whether `a` meets `first`, and whether some of that lies in `second` too.
Overlap overlap_of(const Word* a, const Word* first, const Word* second, Index num_words) {
  Word with_first = 0;
  for (Index w = 0; w < num_words; ++w) {
    const Word common = a[w] & first[w];
    if (common & second[w]) return Overlap::WithBoth;
    with_first |= common;
  }
  return with_first != 0 ? Overlap::WithFirst : Overlap::None;
}

constexpr Index kNone = -1, kSeveral = -2;

/// The only bit of a & b, kNone or kSeveral.
Index single_common_bit(const Word* a, const Word* b, Index num_words) {
  Index found = kNone;
  for (Index w = 0; w < num_words; ++w) {
    const Word common = a[w] & b[w];
    if (common == 0) continue;
    if (found >= 0 || (common & (common - 1)) != 0) return kSeveral;
    found = w * kBitsPerWord + std::countr_zero(common);
  }
  return found;
}

}  // namespace

void BranchSelector::reset(RowsView graph, SearchBudget& budget) {
  graph_ = graph;
  budget_ = &budget;
  words_ = graph.words_per_row;
  repairs_ = density(graph) >= kMinDensityToRepair;
  uncolored_.resize(words_);
  free_.resize(words_);
}

bool BranchSelector::select(const Word* candidates, Index max_pruned, std::vector<Branch>& branches,
                            std::span<const Index> seeds) {
  std::copy(candidates, candidates + words_, uncolored_.begin());
  max_pruned = std::max<Index>(0, max_pruned);
  repair_words_left_ =
      std::max(kMinRepairWords, kRepairWordsPerWord * graph_.num_vertices * words_);
  color_classes(max_pruned, seeds);
  return append_rest(max_pruned, branches);
}

void BranchSelector::color_classes(Index max_classes, std::span<const Index> seeds) {
  num_classes_ = 0;
  num_colored_ = 0;
  Index first_word = 0;
  while (num_classes_ < max_classes) {
    while (first_word < words_ && uncolored_[first_word] == 0) ++first_word;
    if (first_word == words_) return;
    if (static_cast<Index>(classes_.size()) < (num_classes_ + 1) * words_) {
      classes_.resize(2 * (num_classes_ + 1) * words_);
    }
    Word* members = color_class(num_classes_);
    const Index num_colored_before = num_colored_;
    std::fill(members, members + words_, 0);
    std::copy(uncolored_.begin() + first_word, uncolored_.end(), free_.begin() + first_word);
    const auto take = [&](Index v, Index from_word) {
      const Word* row = graph_.row(v);
      for (Index w = from_word; w < words_; ++w) free_[w] &= ~row[w];
      clear_bit(free_.data(), v);
      clear_bit(uncolored_.data(), v);
      set_bit(members, v);
      ++num_colored_;
    };
    if (num_classes_ < static_cast<Index>(seeds.size()) &&
        test_bit(uncolored_.data(), seeds[num_classes_])) {
      take(seeds[num_classes_], first_word);
    }
    for (Index w = first_word; w < words_; ++w) {
      while (free_[w] != 0) take(w * kBitsPerWord + std::countr_zero(free_[w]), w);
    }
    ++num_classes_;
    if (!budget_->spend_work((num_colored_ - num_colored_before) * words_)) return;
  }
}

void BranchSelector::append_all(Index bound, std::vector<Branch>& branches) {
  for_each_bit(uncolored_.data(), words_, [&](Index v) {
    branches.push_back({static_cast<std::int32_t>(v), static_cast<std::int32_t>(++bound)});
  });
}

bool BranchSelector::append_rest(Index max_pruned, std::vector<Branch>& branches) {
  in_triple_.assign(num_classes_, 0);
  bool is_clique = num_colored_ == num_classes_;
  Index bound = max_pruned;
  for (Index first_word = 0; first_word < words_;) {
    if (uncolored_[first_word] == 0) {
      ++first_word;
      continue;
    }
    if (budget_->spent()) {
      append_all(bound, branches);
      return false;
    }
    std::copy(uncolored_.begin() + first_word, uncolored_.end(), free_.begin() + first_word);
    Index class_size = 0;
    for (Index w = first_word; w < words_; ++w) {
      while (free_[w] != 0 && budget_->spend_work(words_)) {
        const Index v = w * kBitsPerWord + std::countr_zero(free_[w]);
        clear_bit(free_.data(), v);
        clear_bit(uncolored_.data(), v);
        if (repair(v)) {
          is_clique = false;
          continue;
        }
        const Word* row = graph_.row(v);
        for (Index i = w; i < words_; ++i) free_[i] &= ~row[i];
        if (class_size++ == 0) ++bound;
        branches.push_back({static_cast<std::int32_t>(v), static_cast<std::int32_t>(bound)});
      }
    }
    is_clique = is_clique && class_size == 1;
  }
  return is_clique;
}

bool BranchSelector::repair(Index v) {
  if (!repairs_ || repair_words_left_ <= 0) return false;
  const Index words_left_before = repair_words_left_;
  const bool repaired = find_repair(v);
  budget_->spend_work(words_left_before - repair_words_left_);
  return repaired;
}

bool BranchSelector::find_repair(Index v) {
  const Word* row = graph_.row(v);
  Index triple_1 = -1, triple_2 = -1;
  for (Index c = 0; c < num_classes_; ++c) {
    if (in_triple_[c]) continue;
    if (repair_words_left_ <= 0) break;
    repair_words_left_ -= words_;
    const Index conflict = single_common_bit(color_class(c), row, words_);
    if (conflict == kSeveral) continue;
    if (conflict == kNone) {
      set_bit(color_class(c), v);
      return true;
    }
    const Word* conflict_row = graph_.row(conflict);
    for (Index other = c + 1; other < num_classes_; ++other) {
      if (in_triple_[other]) continue;
      repair_words_left_ -= words_;
      const Overlap overlap = overlap_of(color_class(other), conflict_row, row, words_);
      if (overlap == Overlap::WithFirst && triple_1 < 0) {
        triple_1 = c;
        triple_2 = other;
      }
      if (overlap != Overlap::None) continue;
      clear_bit(color_class(c), conflict);
      set_bit(color_class(other), conflict);
      set_bit(color_class(c), v);
      return true;
    }
  }
  if (triple_1 < 0) return false;
  in_triple_[triple_1] = in_triple_[triple_2] = 1;
  return true;
}

}  // namespace gmcr
