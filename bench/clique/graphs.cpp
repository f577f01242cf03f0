#include "clique/graphs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include "gmcr/synthetic.hpp"

namespace gmcr::bench {
namespace {

constexpr double kSigma = 0.01;  // metres an axis
constexpr std::uint64_t kSeed = 1;

BitsetGraph graph_of_pairs(Index num_vertices, const std::function<bool(Index, Index)>& is_edge) {
  BitsetGraph graph(num_vertices);
  for (Index u = 0; u < num_vertices; ++u) {
    for (Index v = u + 1; v < num_vertices; ++v) {
      if (is_edge(u, v)) graph.add_edge(u, v);
    }
  }
  return graph;
}

/// Pairs of correspondences whose lengths agree within twice the noise bound.
BitsetGraph consistency(Index num_correspondences, double outlier_rate, double bound_in_sigmas) {
  SyntheticOptions options;
  options.num_correspondences = num_correspondences;
  options.outlier_rate = outlier_rate;
  options.seed = kSeed;
  options.noise_shape = NoiseShape::Gaussian;
  options.noise_extent = options.noise_bound = 3 * kSigma;
  const SyntheticProblem drawn = make_synthetic(options);
  const double tolerance = 2 * bound_in_sigmas * kSigma;
  return graph_of_pairs(num_correspondences, [&](Index i, Index j) {
    const double source = (drawn.source.col(i) - drawn.source.col(j)).norm();
    const double target = (drawn.target.col(i) - drawn.target.col(j)).norm();
    return std::abs(source - target) <= tolerance;
  });
}

double uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator()) / 18446744073709551616.0;
}

BitsetGraph random_graph(Index num_vertices, double density) {
  std::mt19937_64 generator(kSeed);
  return graph_of_pairs(num_vertices, [&](Index, Index) { return uniform(generator) < density; });
}

/// Words of `num_bits` bits that differ in at least `distance` of them.
BitsetGraph hamming(int num_bits, int distance) {
  return graph_of_pairs(Index{1} << num_bits, [=](Index u, Index v) {
    return std::popcount(static_cast<std::uint64_t>(u ^ v)) >= distance;
  });
}

/// Words of `num_bits` bits, `weight` of them set, that differ in at least `distance`.
BitsetGraph johnson(int num_bits, int weight, int distance) {
  std::vector<std::uint64_t> words;
  for (std::uint64_t word = 0; word < std::uint64_t{1} << num_bits; ++word) {
    if (std::popcount(word) == weight) words.push_back(word);
  }
  return graph_of_pairs(static_cast<Index>(words.size()), [&](Index u, Index v) {
    return std::popcount(words[static_cast<std::size_t>(u)] ^ words[static_cast<std::size_t>(v)]) >=
           distance;
  });
}

/// Words over {0, 1, 2, 3} that differ in two places or more, in one of them by 2.
BitsetGraph keller(int num_places) {
  return graph_of_pairs(Index{1} << (2 * num_places), [=](Index u, Index v) {
    int num_different = 0, num_opposite = 0;
    for (int place = 0; place < num_places; ++place) {
      const Index difference = ((u >> (2 * place)) - (v >> (2 * place))) & 3;
      num_different += difference != 0;
      num_opposite += difference == 2;
    }
    return num_different >= 2 && num_opposite >= 1;
  });
}

/// As the "brock" graphs: a hidden clique whose members have the degree of the others.
BitsetGraph hidden_clique(Index num_vertices, double density, Index size) {
  std::mt19937_64 generator(kSeed);
  const double n = static_cast<double>(num_vertices), k = static_cast<double>(size);
  const double to_rest = (density * (n - 1) - (k - 1)) / (n - k);
  return graph_of_pairs(num_vertices, [&](Index u, Index v) {
    if (v < size) return true;  // u < v: both are members
    return uniform(generator) < (u < size ? to_rest : density);
  });
}

/// As the "san" graphs: `size` independent sets, with a clique of one vertex of each.
BitsetGraph partite_with_clique(Index num_vertices, double density, Index size) {
  std::mt19937_64 generator(kSeed);
  return graph_of_pairs(num_vertices, [&](Index u, Index v) {
    if (v < size) return true;
    return u % size != v % size && uniform(generator) < density;
  });
}

/// The same graph with its vertices in random order: no solver can make use of how a rule numbers
/// them.
BitsetGraph shuffled(const BitsetGraph& graph) {
  std::vector<Index> original(static_cast<std::size_t>(graph.num_vertices()));
  std::iota(original.begin(), original.end(), Index{0});
  std::shuffle(original.begin(), original.end(), std::mt19937_64(kSeed));
  return graph_of_pairs(graph.num_vertices(), [&](Index u, Index v) {
    return graph.has_edge(original[static_cast<std::size_t>(u)],
                          original[static_cast<std::size_t>(v)]);
  });
}

void add_consistency_graphs(std::vector<GraphCase>& cases, bool quick) {
  for (const Index count : {200, 500, 1000, 2000, 5000}) {
    if (quick && count > 1000) continue;
    for (const double rate : {0.0, 0.2, 0.5, 0.9, 0.95, 0.99}) {
      for (const double sigmas : {1.0, 2.0, 4.0}) {
        if (count == 5000 && sigmas < 4) continue;
        cases.push_back(
            {"consistency",
             fmt::format("N = {}, {:g} % outliers, {:g} sigma", count, 100 * rate, sigmas),
             [=] { return consistency(count, rate, sigmas); }});
      }
    }
  }
}

}  // namespace

std::vector<GraphCase> clique_graphs(bool quick) {
  std::vector<GraphCase> cases;
  add_consistency_graphs(cases, quick);
  const std::vector<std::pair<Index, double>> random{{200, 0.5},  {200, 0.9},  {400, 0.7},
                                                     {1000, 0.1}, {1000, 0.5}, {5000, 0.01}};
  for (const auto& [n, density] : random) {
    if (quick && (n * density > 250)) continue;
    cases.push_back({"random", fmt::format("G({}, {:g})", n, density),
                     [n = n, density = density] { return random_graph(n, density); }});
  }
  const std::vector<std::pair<const char*, std::function<BitsetGraph()>>> by_rule{
      {"hamming8-4", [] { return hamming(8, 4); }},
      {"hamming10-2", [] { return hamming(10, 2); }},
      {"johnson16-2-4", [] { return johnson(16, 2, 4); }},
      {"johnson10-4-4", [] { return johnson(10, 4, 4); }},
      {"keller 4", [] { return keller(4); }}};
  for (const auto& [name, make] : by_rule) {
    cases.push_back({"DIMACS-like", name, make});
    cases.push_back({"DIMACS-like", fmt::format("{}, shuffled", name),
                     [make = make] { return shuffled(make()); }});
  }
  cases.push_back(
      {"DIMACS-like", "hidden 12 in G(200, 0.65)", [] { return hidden_clique(200, 0.65, 12); }});
  cases.push_back(
      {"DIMACS-like", "hidden 23 in G(200, 0.75)", [] { return hidden_clique(200, 0.75, 23); }});
  cases.push_back(
      {"DIMACS-like", "san-like 200, 30 parts", [] { return partite_with_clique(200, 0.75, 30); }});
  cases.push_back(
      {"DIMACS-like", "san-like 400, 50 parts", [] { return partite_with_clique(400, 0.7, 50); }});
  return cases;
}

}  // namespace gmcr::bench
