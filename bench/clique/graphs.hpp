#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gmcr/bitset_graph.hpp"

namespace gmcr::bench {

/// A graph of the clique benchmark, made when it is needed.
struct GraphCase {
  std::string family;
  std::string name;
  std::function<BitsetGraph()> make;
};

/// Consistency graphs of synthetic registration problems, random graphs, and families of the DIMACS
/// challenge.
/// @param quick  leaves out what takes long.
std::vector<GraphCase> clique_graphs(bool quick);

}  // namespace gmcr::bench
