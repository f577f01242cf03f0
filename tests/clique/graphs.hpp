#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "clique/graph/packed_graph.hpp"
#include "gmcr/bitset_graph.hpp"

namespace gmcr::test {

/// Each pair is an edge with the given probability.
BitsetGraph random_graph(Index num_vertices, double density, std::uint64_t seed);

/// `num_vertices` chosen at random of `graph` become a clique; returns them, ascending.
std::vector<Index> plant_clique(BitsetGraph& graph, Index num_vertices, std::uint64_t seed);

BitsetGraph complete_graph(Index num_vertices);

/// Vertices i and j are neighbours iff i % num_parts != j % num_parts.
BitsetGraph complete_multipartite_graph(Index num_vertices, Index num_parts);

BitsetGraph disjoint_cliques(std::span<const Index> sizes);

/// Mycielski's construction: as triangle-free as `graph`, with one colour more.
BitsetGraph mycielskian(const BitsetGraph& graph);

/// `graph` with the same numbers, in padded rows.
clique::PackedGraph packed(const BitsetGraph& graph);

BitsetGraph complement_of(const BitsetGraph& graph);

/// Vertex v of `graph` is new_number[v] of the result.
BitsetGraph renumbered(const BitsetGraph& graph, std::span<const Index> new_number);

std::vector<Index> random_permutation(Index size, std::uint64_t seed);

/// Whether `vertices` ascend, are vertices of `graph` and pairwise neighbours.
bool is_ascending_clique(const BitsetGraph& graph, std::span<const Index> vertices);

}  // namespace gmcr::test
