#include "noise/noise_estimation.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "noise/noise_bound_search.hpp"
#include "parallel/stopwatch.hpp"
#include "problem/problem.hpp"
#include "problem/selection.hpp"

namespace gmcr::noise {
namespace {

using Coordinates = std::array<double, 6>;

/// One of each of the correspondences that are equal, in an order without a pattern that depends on
/// neither theirs, nor the unit, nor the origin: parts of it are even, and what is chosen by it is
/// the same whatever came first.
std::vector<Index> distinct_correspondences(const PointsRef& source, const PointsRef& target) {
  std::vector<std::pair<Coordinates, Index>> matches;
  matches.reserve(static_cast<std::size_t>(source.cols()));
  for (Index i = 0; i < source.cols(); ++i) {
    matches.push_back(
        {{source(0, i), source(1, i), source(2, i), target(0, i), target(1, i), target(2, i)}, i});
  }
  std::sort(matches.begin(), matches.end());
  const auto end = std::unique(matches.begin(), matches.end(),
                               [](const auto& a, const auto& b) { return a.first == b.first; });
  matches.erase(end, matches.end());
  std::vector<std::pair<std::uint64_t, Index>> order;
  order.reserve(matches.size());
  for (const auto& [coordinates, index] : matches) {
    order.emplace_back(problem::mixed(order.size()), index);
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> kept;
  for (const auto& [place, index] : order) kept.push_back(index);
  return kept;
}

/// Whether each point is not as far from the middle as marks of missing points are.
std::vector<bool> are_near(const PointsRef& points) {
  constexpr double kFarthest = 1e9;  // times the median distance
  const Eigen::Vector3d middle = problem::median_point(points);
  std::vector<double> distances;
  for (const auto point : points.colwise()) distances.push_back((point - middle).stableNorm());
  const double most = kFarthest * problem::median(distances);
  std::vector<bool> near;
  for (const double distance : distances) near.push_back(distance <= most || most == 0);
  return near;
}

/// Of the correspondences those whose points are both near the others: far ones agree with anything
/// to the last digit that they have.
std::vector<Index> near_correspondences(const PointsRef& source, const PointsRef& target) {
  const std::vector<bool> from = are_near(source), to = are_near(target);
  std::vector<Index> near;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] && to[i]) near.push_back(static_cast<Index>(i));
  }
  return near;
}

}  // namespace

ChosenNoise choose_noise(const PointsRef& source, const PointsRef& target, const Options& options) {
  if (source.cols() == 0) return {};
  const std::vector<Index> near = near_correspondences(source, target);
  const Points near_source = source(Eigen::all, near), near_target = target(Eigen::all, near);
  const std::vector<Index> distinct = distinct_correspondences(near_source, near_target);
  if (distinct.size() < 3) return {};
  if (options.admit_all()) {
    // before any work; priors may leave fewer
    problem::Run(options).require_memory_for_graph(std::min(source.cols(), problem::kLeastSample));
  }
  const parallel::Stopwatch clock;
  const Points distinct_source = near_source(Eigen::all, distinct);
  const Points distinct_target = near_target(Eigen::all, distinct);
  NoiseBoundSearch search(distinct_source, distinct_target, options);
  search.run();
  return {search.estimate(), clock.elapsed(), search.num_clique_nodes(), search.late(),
          search.cancelled()};
}

}  // namespace gmcr::noise
