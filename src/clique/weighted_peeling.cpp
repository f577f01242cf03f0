#include "clique/weighted_peeling.hpp"

#include <numeric>

namespace gmcr {

void WeightedPeeling::reset(RowsView graph, std::span<const std::int64_t> units,
                            SearchBudget& budget) {
  graph_ = graph;
  units_ = units;
  budget_ = &budget;
  num_alive_ = 0;
  alive_.assign(graph.words_per_row, 0);
  for (Index v = 0; v < graph.num_vertices; ++v) {
    if (units[v] == 0) continue;
    set_bit(alive_.data(), v);
    ++num_alive_;
  }
  const std::int64_t total = std::accumulate(units.begin(), units.end(), std::int64_t{0});
  neighborhood_.resize(graph.num_vertices);
  for (Index v = 0; v < graph.num_vertices; ++v) {
    neighborhood_[v] = total;
    Index degree = 0;
    std::int64_t sum = units[v];
    if (budget.spent()) continue;
    for_each_bit(graph.row(v), graph.words_per_row, [&](Index u) {
      sum += units[u];
      ++degree;
    });
    neighborhood_[v] = sum;
    budget.spend_work(graph.words_per_row + degree);
  }
}

void WeightedPeeling::peel(std::int64_t to_beat) {
  const auto drop = [&](Index v) {
    clear_bit(alive_.data(), v);
    --num_alive_;
    dropped_.push_back(v);
  };
  dropped_.clear();
  for_each_bit(alive_.data(), graph_.words_per_row, [&](Index v) {
    if (neighborhood_[v] <= to_beat) drop(v);
  });
  while (!dropped_.empty() && num_alive_ > 0) {
    const Index v = dropped_.back();
    dropped_.pop_back();
    Index degree = 0;
    const Word* row = graph_.row(v);
    for (Index w = 0; w < graph_.words_per_row; ++w) {
      for (Word rest = row[w] & alive_[w]; rest != 0; rest &= rest - 1) {
        const Index u = w * kBitsPerWord + std::countr_zero(rest);
        neighborhood_[u] -= units_[v];
        ++degree;
        if (neighborhood_[u] <= to_beat) drop(u);
      }
    }
    if (!budget_->spend_work(graph_.words_per_row + degree)) return;
  }
}

std::int64_t WeightedPeeling::heaviest_neighborhood() const {
  std::int64_t heaviest = 0;
  for_each_bit(alive_.data(), graph_.words_per_row,
               [&](Index v) { heaviest = std::max(heaviest, neighborhood_[v]); });
  return heaviest;
}

}  // namespace gmcr
