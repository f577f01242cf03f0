#include "clique/solvers.hpp"

#include <igraph.h>

#include <memory>

#include "gmcr/clique.hpp"

extern "C" void* cliquer_graph(int num_vertices, int num_edges, const int* ends);
extern "C" int cliquer_solve(void* graph);

namespace gmcr::bench {
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

std::function<CliqueAnswer()> prepare_gmcr(const BitsetGraph& graph, int num_threads) {
  return [&graph, num_threads]() -> CliqueAnswer {
    CliqueOptions options;
    options.num_threads = num_threads;
    const CliqueResult result = max_clique(graph, options);
    return {static_cast<Index>(result.vertices.size()), result.proven_optimal};
  };
}

/// Lives until the process ends, which is soon.
igraph_t* igraph_of(const BitsetGraph& graph) {
  const auto ends = edge_ends<igraph_integer_t>(graph);
  igraph_vector_int_t edges;
  igraph_vector_int_init_array(&edges, ends.data(), static_cast<igraph_integer_t>(ends.size()));
  igraph_t* const converted = std::make_unique<igraph_t>().release();
  igraph_create(converted, &edges, graph.num_vertices(), IGRAPH_UNDIRECTED);
  igraph_vector_int_destroy(&edges);
  return converted;
}

std::function<CliqueAnswer()> prepare_igraph_number(const BitsetGraph& graph) {
  return [converted = igraph_of(graph)]() -> CliqueAnswer {
    igraph_integer_t size = 0;
    igraph_clique_number(converted, &size);
    return {size, true};
  };
}

std::function<CliqueAnswer()> prepare_igraph_largest(const BitsetGraph& graph) {
  return [converted = igraph_of(graph)]() -> CliqueAnswer {
    igraph_vector_int_list_t cliques;
    igraph_vector_int_list_init(&cliques, 0);
    igraph_largest_cliques(converted, &cliques);
    const Index size = igraph_vector_int_list_size(&cliques) == 0
                           ? 0
                           : igraph_vector_int_size(igraph_vector_int_list_get_ptr(&cliques, 0));
    igraph_vector_int_list_destroy(&cliques);
    return {size, true};
  };
}

std::function<CliqueAnswer()> prepare_cliquer(const BitsetGraph& graph) {
  const std::vector<int> ends = edge_ends<int>(graph);
  void* const converted = cliquer_graph(static_cast<int>(graph.num_vertices()),
                                        static_cast<int>(ends.size() / 2), ends.data());
  return [converted]() -> CliqueAnswer { return {cliquer_solve(converted), true}; };
}

}  // namespace

std::vector<CliqueContestant> clique_contestants() {
  return {{"gmcr", [](const BitsetGraph& graph) { return prepare_gmcr(graph, 0); }},
          {"gmcr-1", [](const BitsetGraph& graph) { return prepare_gmcr(graph, 1); }},
          {"igraph", prepare_igraph_number},
          {"igraph-largest", prepare_igraph_largest},
          {"cliquer", prepare_cliquer}};
}

}  // namespace gmcr::bench
