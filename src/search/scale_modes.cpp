#include "search/scale_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "search/scale_branch_and_bound.hpp"

namespace gmcr::search {
namespace {

constexpr double kSizeFactor = 20;
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

/// L7: candidate cliques at the scales of most evidence, at one of them whatever the time.
void explore_modes(PoseSearch& search, VotedBins& voted) {
  bool has_explored = false;
  for (const Index bin : top_modes(voted.votes().evidence)) {
    if (!exceeds(voted.bounds(bin).evidence, search.to_beat(Measure::Evidence))) continue;
    if (std::exchange(has_explored, true) && search.context().stopped()) return;
    grow_cliques(search, voted.graph(search, bin, voted.bins()[bin]), kMaxStarts);
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median distance of the points from their median point.
double median_reach(const Points& points) {
  if (points.cols() == 0) return 0;
  Eigen::Vector3d centre;
  for (Index axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd row = points.row(axis);
    centre[axis] = median({row.begin(), row.end()});
  }
  const Eigen::RowVectorXd distances = (points.colwise() - centre).colwise().norm();
  return median({distances.begin(), distances.end()});
}

double ratio_of(double source, double target) {
  return source > 0 && target > 0 ? target / source : 1;
}

}  // namespace

double typical_scale(const problem::Correspondences& correspondences) {
  return ratio_of(median_reach(correspondences.source), median_reach(correspondences.target));
}

problem::Octaves octaves_of(const Options& options, const problem::Correspondences& input) {
  const double middle =
      options.scale_mode == ScaleMode::Known ? options.scale : typical_scale(input);
  return problem::Octaves(std::isnormal(middle) ? middle : 1);
}

ScaleRange default_scale_range(const problem::Correspondences& correspondences) {
  // the median withstands a few points far out; the mean square sees a far minority of both clouds
  const double by_norm = ratio_of(correspondences.source.norm(), correspondences.target.norm());
  const double by_median = typical_scale(correspondences);
  return {std::min(by_norm, by_median) / kSizeFactor, std::max(by_norm, by_median) * kSizeFactor};
}

UpperBounds search_scales(PoseSearch& search) {
  VotedBins voted(search);
  explore_modes(search, voted);
  ScaleRanges ranges(search, voted);
  UpperBounds bounds;
  const auto lower = [&](bool jointly) {
    if (search.counts_evidence()) bounds.evidence = ranges.lower(Measure::Evidence, jointly);
    bounds.inliers = ranges.lower(Measure::Inliers, jointly);
    if (!search.counts_evidence()) bounds.evidence = bounds.inliers;
  };
  // joint searches may take all of the time, so what cliques prove comes first
  lower(false);
  if (search.certifies()) lower(true);
  return bounds;
}

}  // namespace gmcr::search
