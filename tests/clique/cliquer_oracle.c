#include <cliquer/cliquer.h>

/* Clique number of the graph with `num_edges` edges {ends[2k], ends[2k + 1]}. */
int cliquer_clique_number(int num_vertices, int num_edges, const int* ends) {
  graph_t* graph = graph_new(num_vertices);
  for (int k = 0; k < num_edges; ++k) GRAPH_ADD_EDGE(graph, ends[2 * k], ends[2 * k + 1]);
  clique_options options = *clique_default_options;
  options.time_function = NULL; /* it prints */
  const int size = clique_unweighted_max_weight(graph, &options);
  graph_free(graph);
  return size;
}
