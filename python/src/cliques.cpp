#include "bindings.hpp"
#include "gmcr/clique.hpp"
#include "record.hpp"

namespace gmcr::python {
namespace {

using DenseArray = nb::ndarray<const bool, nb::numpy, nb::shape<-1, -1>, nb::c_contig>;
using EdgeArray = nb::ndarray<const Index, nb::numpy, nb::shape<-1, 2>, nb::c_contig>;

/// Graph of a symmetric matrix, whose diagonal is ignored.
BitsetGraph graph_of(const DenseArray& adjacency) {
  const auto n = static_cast<Index>(adjacency.shape(0));
  if (adjacency.shape(1) != adjacency.shape(0)) {
    throw std::invalid_argument("graph: expected shape (n, n)");
  }
  const Eigen::Map<const Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>> edges(adjacency.data(),
                                                                                   n, n);
  BitsetGraph graph(n);
  for (Index u = 0; u < n; ++u) {
    for (Index v = 0; v < u; ++v) {
      if (edges(v, u) != edges(u, v)) {
        throw std::invalid_argument("graph: not symmetric at (" + std::to_string(v) + ", " +
                                    std::to_string(u) + ")");
      }
      if (edges(v, u)) graph.add_edge(u, v);
    }
  }
  return graph;
}

/// Graph of vertex pairs; repetitions do no harm.
BitsetGraph graph_of(const EdgeArray& edges, Index num_vertices) {
  BitsetGraph graph(num_vertices);
  for (std::size_t k = 0; k < edges.shape(0); ++k) {
    graph.add_edge(edges.data()[2 * k], edges.data()[2 * k + 1]);
  }
  return graph;
}

void bind_clique_options(nb::module_& module) {
  Record<CliqueOptions>(module, "CliqueOptions",
                        "How a clique search may end early and what it may start from.")
      .field("time_limit", &CliqueOptions::time_limit, "Seconds, >= 0.")
      .field("max_nodes", &CliqueOptions::max_nodes, "Search nodes, never exceeded.")
      .field("initial_clique", &CliqueOptions::initial_clique,
             "Known clique to start from; may be empty.")
      .field("must_exceed", &CliqueOptions::must_exceed,
             "Report only a clique with more vertices than this; 0 reports any.")
      .field("num_threads", &CliqueOptions::num_threads,
             "0 ... 1024; 0 uses every core. The result is the same for any number.")
      .field("max_memory", &CliqueOptions::max_memory, "Bytes for copies of the graph.")
      .settable()
      .def("validate", &CliqueOptions::validate,
           "Raises ValueError naming the field and its value where one is out of range.");
  Record<WeightedCliqueOptions>(module, "WeightedCliqueOptions",
                                "How a search for a clique of maximum weight may end early.")
      .field("time_limit", &WeightedCliqueOptions::time_limit, "Seconds, >= 0.")
      .field("max_nodes", &WeightedCliqueOptions::max_nodes, "Search nodes.")
      .field("max_work", &WeightedCliqueOptions::max_work,
             "Word operations, about; 2**30 take about a second.")
      .field("max_memory", &WeightedCliqueOptions::max_memory, "Bytes for copies of the graph.")
      .field("must_exceed", &WeightedCliqueOptions::must_exceed,
             "Report only a clique that weighs more than this; 0 reports any.")
      .settable()
      .def("validate", &WeightedCliqueOptions::validate,
           "Raises ValueError naming the field and its value where one is out of range.");
}

void bind_clique_results(nb::module_& module) {
  Record<CliqueResult>(module, "CliqueResult", "What a clique search found and proved.")
      .field("vertices", &CliqueResult::vertices, "(k,) int64, ascending, read only; a clique.")
      .field("upper_bound", &CliqueResult::upper_bound, "Proven: no clique is larger.")
      .field("proven_optimal", &CliqueResult::proven_optimal,
             "Whether the search proved that there is none larger.")
      .field("nodes", &CliqueResult::nodes, "Search nodes visited.")
      .read_only([](const CliqueResult& self) {
        return nb::cast<std::string>(
            nb::str("CliqueResult({} vertices, at most {}, {} nodes)")
                .attr("format")(self.vertices.size(), self.upper_bound, self.nodes));
      });
  Record<WeightedCliqueResult>(module, "WeightedCliqueResult",
                               "What a search for a clique of maximum weight found and proved.")
      .field("vertices", &WeightedCliqueResult::vertices,
             "(k,) int64, ascending, read only; a clique.")
      .field("weight", &WeightedCliqueResult::weight, "Sum of the weights of the vertices.")
      .field("upper_bound", &WeightedCliqueResult::upper_bound, "Proven: no clique weighs more.")
      .field("proven_optimal", &WeightedCliqueResult::proven_optimal,
             "Whether the search proved that none weighs more.")
      .field("nodes", &WeightedCliqueResult::nodes, "Search nodes visited.")
      .read_only([](const WeightedCliqueResult& self) {
        return nb::cast<std::string>(
            nb::str("WeightedCliqueResult({} vertices, weight={}, at most {}, {} nodes)")
                .attr("format")(self.vertices.size(), self.weight, self.upper_bound, self.nodes));
      });
}

}  // namespace

void bind_cliques(nb::module_& module) {
  bind_clique_options(module);
  bind_clique_results(module);
  nb::class_<BitsetGraph>(module, "Graph", "Undirected simple graph, one bit a vertex pair.")
      .def_static("from_matrix", [](const DenseArray& matrix) { return graph_of(matrix); })
      .def_static("from_edges", [](const EdgeArray& edges, Index num_vertices) {
        return graph_of(edges, num_vertices);
      });
  module.def("max_clique", [](const BitsetGraph& graph, const CliqueOptions& options) {
    const nb::gil_scoped_release no_gil;
    return max_clique(graph, options);
  });
  module.def("max_weight_clique", [](const BitsetGraph& graph, nb::handle weights,
                                     const WeightedCliqueOptions& options) {
    const auto values = Convert<std::vector<double>>::from_python(weights, "weights");
    const nb::gil_scoped_release no_gil;
    return max_weight_clique(graph, values, options);
  });
}

}  // namespace gmcr::python
