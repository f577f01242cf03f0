#include "clique/search/greedy.hpp"

#include <numeric>
#include <stdexcept>
#include <string>

#include "clique/graph/packed_graph.hpp"
#include "kernels/bits/bit_row.hpp"

namespace gmcr::clique {
namespace {

/// A clique that grows, and the vertices adjacent to all of it.
struct GrowingClique {
  std::vector<Index> clique;
  std::vector<Word> candidates;

  GrowingClique(RowsView graph, Index start, std::span<const Word> allowed)
      : clique{start}, candidates(graph.row(start), graph.row(start) + graph.words_per_row) {
    for (std::size_t w = 0; w < allowed.size(); ++w) candidates[w] &= allowed[w];
  }

  bool is_candidate(Index v) const { return test_bit(candidates.data(), v); }

  void add(RowsView graph, Index v) {
    clique.push_back(v);
    const Word* row = graph.row(v);
    for (Index w = 0; w < graph.words_per_row; ++w) candidates[w] &= row[w];
  }

  Index num_candidates() const {
    return count_bits(candidates.data(), static_cast<Index>(candidates.size()));
  }
};

void check_arguments(RowsView graph, Index start, std::span<const Index> priority) {
  if (start < 0 || start >= graph.num_vertices) {
    throw std::invalid_argument("start: " + std::to_string(start) + " is no vertex of a graph of " +
                                std::to_string(graph.num_vertices));
  }
  if (!priority.empty() && static_cast<Index>(priority.size()) != graph.num_vertices) {
    throw std::invalid_argument("priority: " + std::to_string(priority.size()) + " values for " +
                                std::to_string(graph.num_vertices) + " vertices");
  }
}

/// Ascending vertices, by descending priority; equal ones stay in their order.
std::vector<Index> by_priority(std::vector<Index> vertices, std::span<const Index> priority) {
  if (vertices.empty()) return vertices;
  Index least = priority[vertices.front()], most = least;
  for (const Index v : vertices) {
    least = std::min(least, priority[v]);
    most = std::max(most, priority[v]);
  }
  constexpr Index kMostSteps = 8;  // counted for each vertex before sorting takes less time
  if (most - least > kMostSteps * static_cast<Index>(vertices.size())) {
    std::stable_sort(vertices.begin(), vertices.end(),
                     [&](Index a, Index b) { return priority[a] > priority[b]; });
    return vertices;
  }
  std::vector<Index> place(most - least + 2, 0);
  for (const Index v : vertices) ++place[most - priority[v] + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<Index> sorted(vertices.size());
  for (const Index v : vertices) sorted[place[most - priority[v]]++] = v;
  return sorted;
}

std::vector<Index> candidates_by_priority(std::span<const Word> mask,
                                          std::span<const Index> priority) {
  std::vector<Index> candidates;
  for_each_bit(mask.data(), static_cast<Index>(mask.size()),
               [&](Index v) { candidates.push_back(v); });
  return priority.empty() ? candidates : by_priority(std::move(candidates), priority);
}

/// A clique of `graph`, as numbers of it: adds the vertex with the most neighbours among the
/// candidates until none is left.
std::vector<Index> clique_by_candidate_degree(RowsView graph) {
  std::vector<Index> clique, degree(graph.num_vertices), alive(graph.num_vertices);
  for (Index v = 0; v < graph.num_vertices; ++v) {
    degree[v] = graph.degree(v);
    alive[v] = v;
  }
  const Index words = graph.words_per_row;
  std::vector<Word> left(words, ~Word{0});
  while (!alive.empty()) {
    const Index best = *std::max_element(alive.begin(), alive.end(),
                                         [&](Index a, Index b) { return degree[a] < degree[b]; });
    clique.push_back(best);
    const Word* row = graph.row(best);
    const auto drop = std::stable_partition(alive.begin(), alive.end(),
                                            [&](Index v) { return test_bit(row, v); });
    for (Index w = 0; w < words; ++w) left[w] &= row[w];
    const auto num_left = drop - alive.begin(), num_dropped = alive.end() - drop;
    // to count the neighbours of one vertex that are left costs some words; to tell the neighbours
    // of one that is not, about a quarter of what is left
    if (num_left * words < num_dropped * num_left / 4) {
      for (auto v = alive.begin(); v != drop; ++v) {
        degree[*v] = kernels::count_common_bits(graph.row(*v), left.data(), words);
      }
    } else {
      for (auto v = drop; v != alive.end(); ++v) {
        const Word* gone = graph.row(*v);
        for (Index w = 0; w < words; ++w) {
          for (Word rest = gone[w] & left[w]; rest != 0; rest &= rest - 1) {
            --degree[w * kBitsPerWord + std::countr_zero(rest)];
          }
        }
      }
    }
    alive.erase(drop, alive.end());
  }
  return clique;
}

}  // namespace

std::vector<Index> greedy_clique(RowsView graph, Index start, std::span<const Index> priority,
                                 Index max_candidates, std::span<const Word> allowed) {
  check_arguments(graph, start, priority);
  GrowingClique growing(graph, start, allowed);
  std::vector<Index> candidates = candidates_by_priority(growing.candidates, priority);
  Index num_candidates = static_cast<Index>(candidates.size());
  for (const Index v : candidates) {
    if (num_candidates <= max_candidates) break;
    if (!growing.is_candidate(v)) continue;
    growing.add(graph, v);
    if (max_candidates > 0) num_candidates = growing.num_candidates();
  }
  if (max_candidates > 0) {
    std::erase_if(candidates, [&](Index v) { return !growing.is_candidate(v); });
    PackedGraph packed;
    packed.assign(graph, candidates);
    for (const Index v : clique_by_candidate_degree(packed.view())) {
      growing.clique.push_back(packed.original(v));
    }
  }
  std::sort(growing.clique.begin(), growing.clique.end());
  return std::move(growing.clique);
}

}  // namespace gmcr::clique
