#include "clique/clique.hpp"

#include <algorithm>

#include "clique/graph/degeneracy.hpp"
#include "clique/graph/packed_graph.hpp"

namespace gmcr::clique {

BitsetGraph induced_subgraph(const BitsetGraph& graph, std::span<const Index> vertices) {
  PackedGraph packed;
  packed.assign(graph, vertices);
  BitsetGraph subgraph(packed.num_vertices());
  // rows of the packed graph may be padded
  for (Index v = 0; v < packed.num_vertices(); ++v) {
    std::copy_n(packed.row(v), subgraph.words_per_row(), subgraph.mutable_row(v).begin());
  }
  return subgraph;
}

std::vector<Index> core_order(const BitsetGraph& graph) {
  std::vector<Index> order = degeneracy_order(graph).order;
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace gmcr::clique
