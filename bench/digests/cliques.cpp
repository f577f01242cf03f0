// Maximum cliques, plain and weighted, of random graphs and of graphs with a hidden clique.

#include <fmt/core.h>

#include "digests/case.hpp"
#include "digests/random.hpp"

namespace gmcr::bench {
namespace {

struct GraphDraw {
  Index size = 0;
  double density = 0;
  Index hidden = 0;  ///< vertices of the clique that is hidden in it
};

/// A named choice of limits.
struct Limits {
  std::string name;
  std::function<void(CliqueOptions&)> apply;
  std::function<void(WeightedCliqueOptions&)> apply_weighted;
};

BitsetGraph draw_graph(const GraphDraw& draw, Random& random) {
  BitsetGraph graph(draw.size);
  for (Index u = 0; u < draw.size; ++u) {
    for (Index v = u + 1; v < draw.size; ++v) {
      const bool is_hidden = u % 3 == 0 && v % 3 == 0 && v / 3 < draw.hidden;
      if (random.uniform(0, 1) < draw.density || is_hidden) graph.add_edge(u, v);
    }
  }
  return graph;
}

std::vector<double> draw_weights(const std::string& kind, Index size, Random& random) {
  std::vector<double> weights;
  for (Index v = 0; v < size; ++v) {
    if (kind == "equal") {
      weights.push_back(1);
    } else if (kind == "halves") {
      weights.push_back(0.5 * static_cast<double>(random.index(8)));
    } else {
      weights.push_back(random.uniform(0, 1));
    }
  }
  return weights;
}

std::vector<GraphDraw> all_draws() {
  std::vector<GraphDraw> draws;
  for (const Index size : {0, 1, 2, 5, 20, 63, 64, 65, 127, 128}) {
    for (const double density : {0.0, 0.3, 0.7, 0.95}) draws.push_back({size, density});
  }
  for (const Index size : {200, 511, 512, 513}) {
    for (const double density : {0.1, 0.4}) draws.push_back({size, density, 24});
  }
  draws.push_back({100, 0.98});
  draws.push_back({300, 0.995});
  draws.push_back({2000, 0.05, 40});
  return draws;
}

const std::vector<Limits>& all_limits() {
  static const std::vector<Limits> limits{
      {"none", [](CliqueOptions&) {}, [](WeightedCliqueOptions&) {}},
      {"nodes", [](CliqueOptions& o) { o.max_nodes = 20; },
       [](WeightedCliqueOptions& o) { o.max_nodes = 20; }},
      {"exceed", [](CliqueOptions& o) { o.must_exceed = 10; },
       [](WeightedCliqueOptions& o) { o.must_exceed = 7; }},
      {"memory", [](CliqueOptions& o) { o.max_memory = 1 << 12; },
       [](WeightedCliqueOptions& o) { o.max_work = 1 << 20; }},
  };
  return limits;
}

void add_plain(Cases& cases, const GraphDraw& draw, const Limits& limits) {
  const std::string name =
      fmt::format("cliques/plain/{}/{}-{}-{}", limits.name, draw.size, draw.density, draw.hidden);
  cases.push_back({"cliques", name, [=](Digest& digest, int num_threads) {
                     Random random(seed_of(name));
                     CliqueOptions options;
                     options.num_threads = num_threads;
                     limits.apply(options);
                     add(digest, max_clique(draw_graph(draw, random), options));
                   }});
}

void add_weighted(Cases& cases, const GraphDraw& draw, const Limits& limits,
                  const std::string& weights) {
  const std::string name = fmt::format("cliques/{}/{}/{}-{}-{}", weights, limits.name, draw.size,
                                       draw.density, draw.hidden);
  cases.push_back(
      {"cliques", name, [=](Digest& digest, int num_threads) {
         Random random(seed_of(name));
         WeightedCliqueOptions options;
         options.num_threads = num_threads;
         limits.apply_weighted(options);
         const BitsetGraph graph = draw_graph(draw, random);
         add(digest, max_weight_clique(graph, draw_weights(weights, draw.size, random), options));
       }});
}

}  // namespace

void add_cliques(Cases& cases) {
  for (const GraphDraw& draw : all_draws()) {
    for (const Limits& limits : all_limits()) {
      add_plain(cases, draw, limits);
      add_weighted(cases, draw, limits, "real");
    }
    for (const char* weights : {"equal", "halves"}) {
      add_weighted(cases, draw, all_limits().front(), weights);
    }
  }
}

}  // namespace gmcr::bench
