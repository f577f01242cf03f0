#include "clique/weighted/greedy.hpp"

#include <bit>

#include "clique/graph/packed_graph.hpp"
#include "kernels/bits/bit_row.hpp"

namespace gmcr::clique {
namespace {

// More candidates than these are taken by priority: to rank them costs the square of their number.
constexpr Index kMaxCandidatesToRank = 1024;

}  // namespace

std::vector<Index> greedy_heavy_clique(RowsView graph, std::span<const std::int64_t> units,
                                       Index start, std::span<const Word> candidates,
                                       std::span<const std::int64_t> priority,
                                       SearchBudget& budget) {
  std::vector<Index> clique{start}, alive;
  for_each_bit(candidates.data(), graph.words_per_row, [&](Index v) { alive.push_back(v); });
  while (static_cast<Index>(alive.size()) > kMaxCandidatesToRank) {
    const Index best = *std::max_element(
        alive.begin(), alive.end(), [&](Index a, Index b) { return priority[a] < priority[b]; });
    clique.push_back(best);
    std::erase_if(alive, [&](Index v) { return !test_bit(graph.row(best), v); });
    if (!budget.spend_work(static_cast<Index>(alive.size()))) return clique;
  }
  PackedGraph packed;
  if (!packed.assign(graph, alive, &budget)) return clique;

  const Index n = packed.num_vertices(), words = packed.words_per_row();
  std::vector<std::int64_t> weight(n), neighbourhood(n);
  for (Index v = 0; v < n; ++v) weight[v] = units[packed.original(v)];
  std::vector<Word> left(words, ~Word{0});
  const auto sum_around = [&](Index v) {
    return weight[v] +
           kernels::sum_over_common_bits(packed.row(v), left.data(), words, weight.data(), n);
  };
  alive.resize(n);
  for (Index v = 0; v < n; ++v) {
    alive[v] = v;
    neighbourhood[v] = sum_around(v);
  }
  while (!alive.empty() && budget.spend_work(n)) {
    const Index best = *std::max_element(alive.begin(), alive.end(), [&](Index a, Index b) {
      return neighbourhood[a] < neighbourhood[b];
    });
    clique.push_back(packed.original(best));
    const Word* row = packed.row(best);
    const auto drop = std::stable_partition(alive.begin(), alive.end(),
                                            [&](Index v) { return v != best && test_bit(row, v); });
    for (Index w = 0; w < words; ++w) left[w] &= row[w];
    // what is left of many is summed anew, of few the others are taken away
    const auto num_left = drop - alive.begin(), num_dropped = alive.end() - drop;
    budget.spend_work(n * num_dropped);
    if (num_left < num_dropped) {
      for (auto v = alive.begin(); v != drop; ++v) neighbourhood[*v] = sum_around(*v);
    } else {
      for (auto v = drop; v != alive.end(); ++v) {
        const Word* gone = packed.row(*v);
        for (Index w = 0; w < words; ++w) {
          for (Word rest = gone[w] & left[w]; rest != 0; rest &= rest - 1) {
            neighbourhood[w * kBitsPerWord + std::countr_zero(rest)] -= weight[*v];
          }
        }
      }
    }
    alive.erase(drop, alive.end());
  }
  return clique;
}

}  // namespace gmcr::clique
