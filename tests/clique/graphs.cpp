#include "clique/graphs.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "clique/oracles.hpp"

namespace gmcr::test {

BitsetGraph random_graph(Index num_vertices, double density, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  BitsetGraph graph(num_vertices);
  const double limit = density * 18446744073709551616.0;
  for (Index u = 0; u < num_vertices; ++u) {
    for (Index v = u + 1; v < num_vertices; ++v) {
      if (static_cast<double>(generator()) < limit) graph.add_edge(u, v);
    }
  }
  return graph;
}

std::vector<Index> plant_clique(BitsetGraph& graph, Index num_vertices, std::uint64_t seed) {
  std::vector<Index> clique = random_permutation(graph.num_vertices(), seed);
  clique.resize(static_cast<std::size_t>(num_vertices));
  std::sort(clique.begin(), clique.end());
  for (std::size_t i = 0; i < clique.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) graph.add_edge(clique[i], clique[j]);
  }
  return clique;
}

BitsetGraph complete_graph(Index num_vertices) { return complement_of(BitsetGraph(num_vertices)); }

BitsetGraph complete_multipartite_graph(Index num_vertices, Index num_parts) {
  BitsetGraph graph(num_vertices);
  for (Index u = 0; u < num_vertices; ++u) {
    for (Index v = u + 1; v < num_vertices; ++v) {
      if (u % num_parts != v % num_parts) graph.add_edge(u, v);
    }
  }
  return graph;
}

BitsetGraph disjoint_cliques(std::span<const Index> sizes) {
  BitsetGraph graph(std::accumulate(sizes.begin(), sizes.end(), Index{0}));
  Index first = 0;
  for (const Index size : sizes) {
    for (Index u = first; u < first + size; ++u) {
      for (Index v = u + 1; v < first + size; ++v) graph.add_edge(u, v);
    }
    first += size;
  }
  return graph;
}

BitsetGraph mycielskian(const BitsetGraph& graph) {
  const Index n = graph.num_vertices();
  BitsetGraph result(2 * n + 1);
  for (Index u = 0; u < n; ++u) {
    result.add_edge(n + u, 2 * n);
    for (Index v = 0; v < n; ++v) {
      if (u == v || !graph.has_edge(u, v)) continue;
      result.add_edge(u, v);
      result.add_edge(u, n + v);
    }
  }
  return result;
}

clique::PackedGraph packed(const BitsetGraph& graph) {
  std::vector<Index> all(static_cast<std::size_t>(graph.num_vertices()));
  std::iota(all.begin(), all.end(), Index{0});
  clique::PackedGraph result;
  result.assign(graph, all);
  return result;
}

BitsetGraph complement_of(const BitsetGraph& graph) {
  BitsetGraph result(graph.num_vertices());
  for (Index u = 0; u < graph.num_vertices(); ++u) {
    for (Index v = u + 1; v < graph.num_vertices(); ++v) {
      if (!graph.has_edge(u, v)) result.add_edge(u, v);
    }
  }
  return result;
}

BitsetGraph renumbered(const BitsetGraph& graph, std::span<const Index> new_number) {
  BitsetGraph result(graph.num_vertices());
  for (Index u = 0; u < graph.num_vertices(); ++u) {
    for (Index v = u + 1; v < graph.num_vertices(); ++v) {
      if (graph.has_edge(u, v)) {
        result.add_edge(new_number[static_cast<std::size_t>(u)],
                        new_number[static_cast<std::size_t>(v)]);
      }
    }
  }
  return result;
}

std::vector<Index> random_permutation(Index size, std::uint64_t seed) {
  std::vector<Index> permutation(static_cast<std::size_t>(size));
  std::iota(permutation.begin(), permutation.end(), Index{0});
  std::shuffle(permutation.begin(), permutation.end(), std::mt19937_64(seed));
  return permutation;
}

bool is_ascending_clique(const BitsetGraph& graph, std::span<const Index> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i] < 0 || vertices[i] >= graph.num_vertices()) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (vertices[j] >= vertices[i] || !graph.has_edge(vertices[j], vertices[i])) return false;
    }
  }
  return true;
}

Index brute_force_clique_number(const BitsetGraph& graph) {
  const Index n = graph.num_vertices();
  // is_clique[s]: set s without its smallest vertex is one, and that vertex is adjacent to the
  // rest.
  std::vector<char> is_clique(std::size_t{1} << n, 1);
  int largest = 0;
  for (std::size_t set = 1; set < is_clique.size(); ++set) {
    const std::size_t rest = set & (set - 1);
    const std::uint64_t neighbors = graph.row(std::countr_zero(set))[0];
    is_clique[set] = is_clique[rest] && (rest & ~neighbors) == 0;
    if (is_clique[set]) largest = std::max(largest, std::popcount(set));
  }
  return largest;
}

double brute_force_clique_weight(const BitsetGraph& graph, std::span<const double> weights) {
  const Index n = graph.num_vertices();
  // Weight of each vertex subset; negative where it is no clique.
  std::vector<double> weight(std::size_t{1} << n, 0);
  double heaviest = 0;
  for (std::size_t set = 1; set < weight.size(); ++set) {
    const std::size_t rest = set & (set - 1);
    const int v = std::countr_zero(set);
    const bool is_clique = weight[rest] >= 0 && (rest & ~graph.row(v)[0]) == 0;
    weight[set] = is_clique ? weight[rest] + weights[static_cast<std::size_t>(v)] : -1;
    heaviest = std::max(heaviest, weight[set]);
  }
  return heaviest;
}

}  // namespace gmcr::test
