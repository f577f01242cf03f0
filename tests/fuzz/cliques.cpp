// Cliques of small graphs, under any options and weights, against all vertex subsets.
#include <algorithm>
#include <cmath>
#include <vector>

#include "fuzz/bytes.hpp"
#include "fuzz/target.hpp"
#include "gmcr/clique.hpp"

namespace gmcr::fuzz {
namespace {

constexpr Index kMostVertices = 18;

BitsetGraph graph_of(Bytes& input) {
  const auto n = static_cast<Index>(input.below(kMostVertices + 1));
  const bool is_dense = input.flag();
  BitsetGraph graph(n);
  for (Index u = 1; u < n; ++u) {
    const auto row = input.raw<std::uint32_t>();
    for (Index v = 0; v < u; ++v) {
      if (((row >> v) & 1u) != (is_dense ? 1u : 0u)) graph.add_edge(u, v);
    }
  }
  return graph;
}

/// Weight of the heaviest clique among `candidates`, ascending, by trying all.
double heaviest(const BitsetGraph& graph, const std::vector<double>& weights,
                const std::vector<Index>& candidates) {
  double best = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Index v = candidates[i];
    std::vector<Index> rest;
    for (std::size_t j = i + 1; j < candidates.size(); ++j) {
      if (graph.has_edge(v, candidates[j])) rest.push_back(candidates[j]);
    }
    best = std::max(best, weights[static_cast<std::size_t>(v)] + heaviest(graph, weights, rest));
  }
  return best;
}

double heaviest(const BitsetGraph& graph, const std::vector<double>& weights) {
  std::vector<Index> all;
  for (Index v = 0; v < graph.num_vertices(); ++v) all.push_back(v);
  return heaviest(graph, weights, all);
}

bool is_clique(const BitsetGraph& graph, const std::vector<Index>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (vertices[j] >= vertices[i] || !graph.has_edge(vertices[i], vertices[j])) return false;
    }
  }
  return true;
}

/// Limits that may bind.
template <typename CliqueLimits>
void limit(CliqueLimits& options, Bytes& input) {
  if (input.flag()) options.max_nodes = input.below(20);
  if (input.flag()) options.max_work = input.raw<std::uint16_t>();
  if (input.flag()) options.max_memory = input.raw<std::uint16_t>();
  if (input.flag()) options.time_limit = input.flag() ? 0 : 1e-6;
  options.num_threads = static_cast<int>(1 + input.below(3));
}

void check_largest(const BitsetGraph& graph, Bytes& input) {
  CliqueOptions options;
  limit(options, input);
  options.must_exceed = static_cast<Index>(input.below(8));
  if (graph.num_vertices() > 0 && input.flag()) {
    options.initial_clique = {
        static_cast<Index>(input.below(static_cast<std::size_t>(graph.num_vertices())))};
  }
  const CliqueResult found = max_clique(graph, options);
  const std::vector<double> ones(static_cast<std::size_t>(graph.num_vertices()), 1.0);
  const auto largest = static_cast<Index>(heaviest(graph, ones));
  const auto size = static_cast<Index>(found.vertices.size());
  require(is_clique(graph, found.vertices), "a clique");
  require(largest <= found.upper_bound, "no clique above the bound");
  require(found.nodes <= options.max_nodes, "no more nodes than allowed");
  if (found.proven_optimal) {
    require(found.upper_bound <= std::max(size, options.must_exceed), "what proven means");
    require(size == largest || largest <= options.must_exceed, "the largest where it is proven");
  }
}

void check_heaviest(const BitsetGraph& graph, Bytes& input) {
  std::vector<double> weights;
  for (Index v = 0; v < graph.num_vertices(); ++v) weights.push_back(input.number());
  WeightedCliqueOptions options;
  limit(options, input);
  if (input.flag()) options.must_exceed = std::abs(input.number());
  WeightedCliqueResult found;
  try {
    found = max_weight_clique(graph, weights, options);
  } catch (const std::invalid_argument&) {
    double sum = std::isfinite(options.must_exceed) ? 0 : options.must_exceed;
    bool is_positive = true;
    for (const double weight : weights) {
      sum += weight;
      is_positive = is_positive && weight >= 0;
    }
    require(!is_positive || !std::isfinite(sum), "weights are refused for a reason");
    return;
  }
  const double most = heaviest(graph, weights);
  double weight = 0;
  for (const Index v : found.vertices) weight += weights[static_cast<std::size_t>(v)];
  constexpr double kRounding = 1e-11;
  require(is_clique(graph, found.vertices), "a clique");
  require(weight == found.weight, "its weight");
  require(most <= found.upper_bound * (1 + kRounding), "no heavier clique than the bound");
  if (found.proven_optimal) {
    require(most <= std::max(weight, options.must_exceed) * (1 + kRounding),
            "the heaviest where it is proven");
  }
}

}  // namespace

void find_cliques(std::string_view bytes) {
  Bytes input(bytes);
  const BitsetGraph graph = graph_of(input);
  if (input.flag()) {
    check_largest(graph, input);
  } else {
    check_heaviest(graph, input);
  }
}

}  // namespace gmcr::fuzz
