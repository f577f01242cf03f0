#include <igraph.h>

#include <vector>

#include "clique/oracles.hpp"

extern "C" int cliquer_clique_number(int num_vertices, int num_edges, const int* ends);
extern "C" int cliquer_clique_weight(int num_vertices, int num_edges, const int* ends,
                                     const int* weights);

namespace gmcr::test {
namespace {

template <typename T>
std::vector<T> edge_ends(const BitsetGraph& graph) {
  std::vector<T> ends;
  for (Index u = 0; u < graph.num_vertices(); ++u) {
    for (Index v = u + 1; v < graph.num_vertices(); ++v) {
      if (!graph.has_edge(u, v)) continue;
      ends.push_back(static_cast<T>(u));
      ends.push_back(static_cast<T>(v));
    }
  }
  return ends;
}

}  // namespace

Index igraph_clique_number(const BitsetGraph& graph) {
  const auto ends = edge_ends<igraph_integer_t>(graph);
  igraph_vector_int_t edges;
  igraph_vector_int_init_array(&edges, ends.data(), static_cast<igraph_integer_t>(ends.size()));
  igraph_t converted;
  igraph_create(&converted, &edges, graph.num_vertices(), IGRAPH_UNDIRECTED);
  igraph_integer_t size = 0;
  igraph_clique_number(&converted, &size);
  igraph_destroy(&converted);
  igraph_vector_int_destroy(&edges);
  return size;
}

Index cliquer_clique_number(const BitsetGraph& graph) {
  const std::vector<int> ends = edge_ends<int>(graph);
  return ::cliquer_clique_number(static_cast<int>(graph.num_vertices()),
                                 static_cast<int>(ends.size() / 2), ends.data());
}

Index cliquer_clique_weight(const BitsetGraph& graph, std::span<const int> weights) {
  const std::vector<int> ends = edge_ends<int>(graph);
  return ::cliquer_clique_weight(static_cast<int>(graph.num_vertices()),
                                 static_cast<int>(ends.size() / 2), ends.data(), weights.data());
}

}  // namespace gmcr::test
