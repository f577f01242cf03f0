#pragma once

#include <functional>
#include <vector>

#include "gmcr/bitset_graph.hpp"
#include "search/pose_search.hpp"

namespace gmcr::search {

/// The consistency graph of a range of scales, less the pairs that the filter does not admit.
struct RangeGraph {
  ScaleRange scales;
  BitsetGraph graph;
};

/// What each correspondence adds to the measure, at most, at scales in the range.
std::vector<double> weights_of(const problem::Problem& problem, Measure measure,
                               const ScaleRange& scales);

/// @param build  returns the graph; its time is that of the stage "graph".
RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales,
                             const std::function<BitsetGraph()>& build);

/// The same from all pairs.
RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales);

/// L7: tries greedy maximal cliques grown from the vertices of largest degree that neither an
/// earlier one covers nor the best pose explains, where a clique could beat the best evidence.
void grow_cliques(PoseSearch& search, const RangeGraph& range, Index max_starts);

/// L5: searches the range's graph for a clique that measures more than what is to be beaten. Where
/// the solver is ours several threads may search at once, each on up to `num_threads`.
problem::Run::Clique find_clique(const PoseSearch& search, const RangeGraph& range, Measure measure,
                                 std::uint64_t max_nodes, int num_threads);

/// Tries the clique that a search found, if any, and tells the diagnostics of the search.
/// @return proven upper bound on the measure of poses in the range, or what is to be beaten where
///   none has more.
double take_clique(PoseSearch& search, Measure measure, const problem::Run::Clique& found);

/// Both of one range.
double search_clique(PoseSearch& search, const RangeGraph& range, Measure measure,
                     std::uint64_t max_nodes);

}  // namespace gmcr::search
