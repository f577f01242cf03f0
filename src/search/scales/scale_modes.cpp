#include "search/scales/scale_modes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "search/candidate_cliques.hpp"

namespace gmcr::search {
namespace {

constexpr Index kMaxModes = 40;
constexpr Index kMaxStarts = 64;

/// Bins of most evidence, none of them beside a better one.
std::vector<Index> top_modes(const std::vector<double>& evidence) {
  constexpr Index kNeighbours = 2;
  const auto count = static_cast<Index>(evidence.size());
  std::vector<Index> order(evidence.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return evidence[static_cast<std::size_t>(a)] > evidence[static_cast<std::size_t>(b)];
  });
  std::vector<bool> taken(evidence.size(), false);
  std::vector<Index> modes;
  for (const Index bin : order) {
    if (static_cast<Index>(modes.size()) == kMaxModes) break;
    if (taken[static_cast<std::size_t>(bin)]) continue;
    modes.push_back(bin);
    for (Index near = std::max<Index>(0, bin - kNeighbours);
         near <= std::min(count - 1, bin + kNeighbours); ++near) {
      taken[static_cast<std::size_t>(near)] = true;
    }
  }
  return modes;
}

}  // namespace

void explore_modes(PoseSearch& search, VotedBins& voted) {
  bool has_explored = false;
  for (const Index bin : top_modes(voted.votes().evidence)) {
    if (!exceeds(voted.bounds(bin).evidence, search.to_beat(Measure::Evidence))) continue;
    if (std::exchange(has_explored, true) && search.run().stopped()) return;
    grow_cliques(search, voted.graph(search, bin, voted.bins()[bin]), kMaxStarts);
  }
}

}  // namespace gmcr::search
