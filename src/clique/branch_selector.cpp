#include "clique/branch_selector.hpp"

namespace gmcr {
namespace {

// Measured on random graphs: below these densities a repair costs more than it saves.
constexpr double kMinDensityToRecolor = 0.4;
constexpr double kMinDensityForTriples = 0.65;

double density(RowsView graph) {
  const Index n = graph.num_vertices;
  const Index ends = count_bits(graph.words, n * graph.words_per_row);
  return n < 2 ? 0.0 : static_cast<double>(ends) / (static_cast<double>(n) * (n - 1));
}

bool intersects(const Word* a, const Word* b, Index num_words) {
  for (Index w = 0; w < num_words; ++w) {
    if (a[w] & b[w]) return true;
  }
  return false;
}

/// The only bit of a & b; -1 where there is none, -2 where there are several.
Index single_common_bit(const Word* a, const Word* b, Index num_words) {
  Index found = -1;
  for (Index w = 0; w < num_words; ++w) {
    const Word common = a[w] & b[w];
    if (common == 0) continue;
    if (found >= 0 || (common & (common - 1)) != 0) return -2;
    found = w * kBitsPerWord + std::countr_zero(common);
  }
  return found;
}

}  // namespace

void BranchSelector::reset(RowsView graph) {
  graph_ = graph;
  words_ = graph.words_per_row;
  const double edge_density = density(graph);
  recolors_ = edge_density >= kMinDensityToRecolor;
  prunes_by_triple_ = edge_density >= kMinDensityForTriples;
  uncolored_.resize(words_);
  free_.resize(words_);
}

bool BranchSelector::select(const Word* candidates, Index max_pruned, std::vector<Branch>& branches,
                            std::span<const Index> seeds) {
  std::copy(candidates, candidates + words_, uncolored_.begin());
  max_pruned = std::max<Index>(0, max_pruned);
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
  }
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
    std::copy(uncolored_.begin() + first_word, uncolored_.end(), free_.begin() + first_word);
    Index class_size = 0;
    for (Index w = first_word; w < words_; ++w) {
      while (free_[w] != 0) {
        const Index v = w * kBitsPerWord + std::countr_zero(free_[w]);
        clear_bit(free_.data(), v);
        clear_bit(uncolored_.data(), v);
        if ((recolors_ && recolor(v)) || (prunes_by_triple_ && prune_by_triple(v))) {
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

bool BranchSelector::recolor(Index v) {
  const Word* row = graph_.row(v);
  for (Index c = 0; c < num_classes_; ++c) {
    if (in_triple_[c]) continue;
    const Index conflict = single_common_bit(color_class(c), row, words_);
    if (conflict == -2) continue;
    if (conflict >= 0) {
      const Word* conflict_row = graph_.row(conflict);
      Index other = 0;
      while (other < num_classes_ && (other == c || in_triple_[other] ||
                                      intersects(color_class(other), conflict_row, words_))) {
        ++other;
      }
      if (other == num_classes_) continue;
      clear_bit(color_class(c), conflict);
      set_bit(color_class(other), conflict);
    }
    set_bit(color_class(c), v);
    return true;
  }
  return false;
}

bool BranchSelector::prune_by_triple(Index v) {
  for (Index c1 = 0; c1 < num_classes_; ++c1) {
    if (in_triple_[c1]) continue;
    for (Index c2 = c1 + 1; c2 < num_classes_; ++c2) {
      if (in_triple_[c2] || has_triangle(v, color_class(c1), color_class(c2))) continue;
      in_triple_[c1] = in_triple_[c2] = 1;
      return true;
    }
  }
  return false;
}

bool BranchSelector::has_triangle(Index v, const Word* class_1, const Word* class_2) const {
  const Word* row = graph_.row(v);
  for (Index w = 0; w < words_; ++w) {
    for (Word rest = class_1[w] & row[w]; rest != 0; rest &= rest - 1) {
      const Word* other = graph_.row(w * kBitsPerWord + std::countr_zero(rest));
      for (Index i = 0; i < words_; ++i) {
        if (class_2[i] & row[i] & other[i]) return true;
      }
    }
  }
  return false;
}

}  // namespace gmcr
