#include <cliquer/cliquer.h>

/* Graph with `num_edges` edges {ends[2k], ends[2k + 1]}. */
void* cliquer_graph(int num_vertices, int num_edges, const int* ends) {
  graph_t* graph = graph_new(num_vertices);
  for (int k = 0; k < num_edges; ++k) GRAPH_ADD_EDGE(graph, ends[2 * k], ends[2 * k + 1]);
  return graph;
}

int cliquer_solve(void* graph) {
  clique_options options = *clique_default_options;
  options.time_function = NULL; /* it prints */
  return clique_unweighted_max_weight(graph, &options);
}
