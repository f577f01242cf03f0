#include <cliquer/cliquer.h>

static graph_t* graph_of(int num_vertices, int num_edges, const int* ends) {
  graph_t* graph = graph_new(num_vertices);
  for (int k = 0; k < num_edges; ++k) GRAPH_ADD_EDGE(graph, ends[2 * k], ends[2 * k + 1]);
  return graph;
}

static clique_options silent_options(void) {
  clique_options options = *clique_default_options;
  options.time_function = NULL; /* it prints */
  return options;
}

/* Clique number of the graph with `num_edges` edges {ends[2k], ends[2k + 1]}. */
int cliquer_clique_number(int num_vertices, int num_edges, const int* ends) {
  graph_t* graph = graph_of(num_vertices, num_edges, ends);
  clique_options options = silent_options();
  const int size = clique_unweighted_max_weight(graph, &options);
  graph_free(graph);
  return size;
}

/* Weight of the heaviest clique of such a graph, whose vertices weigh `weights` > 0. */
int cliquer_clique_weight(int num_vertices, int num_edges, const int* ends, const int* weights) {
  graph_t* graph = graph_of(num_vertices, num_edges, ends);
  for (int v = 0; v < num_vertices; ++v) graph->weights[v] = weights[v];
  clique_options options = silent_options();
  const int weight = clique_max_weight(graph, &options);
  graph_free(graph);
  return weight;
}
