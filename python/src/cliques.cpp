#include "bindings.hpp"
#include "conversion/interruptible.hpp"
#include "conversion/option_record.hpp"
#include "gmcr/clique.hpp"

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
  bind_checked_options<CliqueOptions>(
      module, "CliqueOptions", "How a clique search may end early and what it may start from.");
  bind_checked_options<WeightedCliqueOptions>(
      module, "WeightedCliqueOptions",
      "How a search for a clique of maximum weight may end early.");
  bind_clique_results(module);
  nb::class_<BitsetGraph>(module, "Graph", "Undirected simple graph, one bit a vertex pair.")
      .def_static("from_matrix", [](const DenseArray& matrix) { return graph_of(matrix); })
      .def_static("from_edges", [](const EdgeArray& edges, Index num_vertices) {
        return graph_of(edges, num_vertices);
      });
  module.def("max_clique", [](const BitsetGraph& graph, const CliqueOptions& options) {
    return interruptible(options,
                         [&](const CliqueOptions& watched) { return max_clique(graph, watched); });
  });
  module.def("max_weight_clique", [](const BitsetGraph& graph, nb::handle weights,
                                     const WeightedCliqueOptions& options) {
    const auto values = Convert<std::vector<double>>::from_python(weights, "weights");
    return interruptible(options, [&](const WeightedCliqueOptions& watched) {
      return max_weight_clique(graph, values, watched);
    });
  });
}

}  // namespace gmcr::python
