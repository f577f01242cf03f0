#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gmcr/bitset_graph.hpp"

namespace gmcr::bench {

/// What a solver says of a graph.
struct CliqueAnswer {
  Index size = 0;
  bool proven = false;
};

/// A maximum clique solver under test.
struct CliqueContestant {
  std::string name;
  /// Converts the graph and returns the solver's run on it, so that only the latter is timed.
  std::function<std::function<CliqueAnswer()>(const BitsetGraph&)> prepare;
};

/// gmcr            max_clique on all cores, without limits
/// gmcr-1          the same on one thread
/// igraph          igraph_clique_number
/// igraph-largest  igraph_largest_cliques
/// cliquer         clique_unweighted_max_weight
std::vector<CliqueContestant> clique_contestants();

}  // namespace gmcr::bench
