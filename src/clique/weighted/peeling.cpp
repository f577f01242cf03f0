#include "clique/weighted/peeling.hpp"

#include <algorithm>
#include <numeric>

#include "clique/graph/degrees.hpp"
#include "kernels/bits/bit_row.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::clique {
namespace {

// A pass over the graph that drops less than one vertex of so many is the last.
constexpr Index kLeastShareToRepeat = 16;
// Words of vertices whose neighbourhoods are summed at a time.
constexpr Index kWordsPerRound = 64;

}  // namespace

void WeightedPeeling::reset(RowsView graph, std::span<const std::int64_t> units,
                            std::int64_t to_beat, SearchBudget& budget, int num_threads) {
  graph_ = graph;
  num_threads_ = threads_for(graph, num_threads);
  units_ = units;
  budget_ = &budget;
  num_alive_ = 0;
  alive_.assign(graph.words_per_row, 0);
  for (Index v = 0; v < graph.num_vertices; ++v) {
    if (units[v] == 0) continue;
    set_bit(alive_.data(), v);
    ++num_alive_;
  }
  drop_few_neighbours(to_beat);
  sum_neighbourhoods();
}

/// Counts take a fraction of the time of sums, and of most graphs leave little to sum.
void WeightedPeeling::drop_few_neighbours(std::int64_t to_beat) {
  const Index words = graph_.words_per_row;
  std::int64_t heaviest = 0;
  for (const std::int64_t weight : units_) heaviest = std::max(heaviest, weight);
  if (heaviest == 0) return;
  const Index least_degree = static_cast<Index>(to_beat / heaviest);  // degree + 1 must exceed it
  for (Index dropped = num_alive_; dropped > num_alive_ / kLeastShareToRepeat;) {
    dropped = 0;
    for_each_bit(alive_.data(), words, [&](Index v) {
      if (!budget_->spend_work(words)) return;
      if (kernels::count_common_bits(graph_.row(v), alive_.data(), words) >= least_degree) return;
      clear_bit(alive_.data(), v);
      ++dropped;
    });
    num_alive_ -= dropped;
    if (dropped == 0) break;
  }
}

void WeightedPeeling::sum_neighbourhoods() {
  const Index n = graph_.num_vertices, words = graph_.words_per_row;
  const std::int64_t total = std::accumulate(units_.begin(), units_.end(), std::int64_t{0});
  neighbourhood_.assign(n, total);
  for (Index first = 0; first < words; first += kWordsPerRound) {
    const Index last = std::min(words, first + kWordsPerRound);
    if (!budget_->spend_work(count_bits(alive_.data() + first, last - first) * words)) return;
    parallel::parallel_for(last - first, 1, num_threads_, [&](Index begin, Index end) {
      for_each_bit(alive_.data() + first + begin, end - begin, [&](Index bit) {
        const Index v = (first + begin) * kBitsPerWord + bit;
        neighbourhood_[v] = units_[v] + kernels::sum_over_common_bits(graph_.row(v), alive_.data(),
                                                                      words, units_.data(), n);
      });
    });
  }
}

void WeightedPeeling::peel(std::int64_t to_beat) {
  drop_light(to_beat);
  // where most vertices go, new sums cost less than to tell all their neighbours
  while (static_cast<Index>(dropped_.size()) > num_alive_ && num_alive_ > 0) {
    sum_neighbourhoods();
    if (budget_->spent()) return;
    drop_light(to_beat);
  }
  while (!dropped_.empty() && num_alive_ > 0) {
    const Index v = dropped_.back();
    dropped_.pop_back();
    Index degree = 0;
    const Word* row = graph_.row(v);
    for (Index w = 0; w < graph_.words_per_row; ++w) {
      for (Word rest = row[w] & alive_[w]; rest != 0; rest &= rest - 1) {
        const Index u = w * kBitsPerWord + std::countr_zero(rest);
        neighbourhood_[u] -= units_[v];
        ++degree;
        if (neighbourhood_[u] <= to_beat) drop(u);
      }
    }
    if (!budget_->spend_work(graph_.words_per_row + degree)) return;
  }
}

void WeightedPeeling::drop_light(std::int64_t to_beat) {
  dropped_.clear();
  for_each_bit(alive_.data(), graph_.words_per_row, [&](Index v) {
    if (neighbourhood_[v] <= to_beat) drop(v);
  });
}

void WeightedPeeling::drop(Index v) {
  clear_bit(alive_.data(), v);
  --num_alive_;
  dropped_.push_back(v);
}

std::int64_t WeightedPeeling::heaviest_neighbourhood() const {
  std::int64_t heaviest = 0;
  for_each_bit(alive_.data(), graph_.words_per_row,
               [&](Index v) { heaviest = std::max(heaviest, neighbourhood_[v]); });
  return heaviest;
}

}  // namespace gmcr::clique
