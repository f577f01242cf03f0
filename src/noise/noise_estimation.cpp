#include "noise/noise_estimation.hpp"

#include <array>
#include <map>
#include <vector>

#include "noise/noise_bound_search.hpp"
#include "parallel/stopwatch.hpp"
#include "problem/run.hpp"

namespace gmcr::noise {
namespace {

/// The correspondences that equal no earlier one, ascending.
std::vector<Index> distinct_correspondences(const PointsRef& source, const PointsRef& target) {
  std::map<std::array<double, 6>, Index> first;
  std::vector<Index> kept;
  for (Index i = 0; i < source.cols(); ++i) {
    const std::array<double, 6> key{source(0, i), source(1, i), source(2, i),
                                    target(0, i), target(1, i), target(2, i)};
    if (first.emplace(key, i).second) kept.push_back(i);
  }
  return kept;
}

}  // namespace

ChosenNoise choose_noise(const PointsRef& source, const PointsRef& target, const Options& options) {
  const std::vector<Index> distinct = distinct_correspondences(source, target);
  if (distinct.size() < 3) return {};
  if (options.admit_all()) {
    // before any work; priors may leave fewer
    problem::Run(options).require_memory_for_graph(source.cols());
  }
  const parallel::Stopwatch clock;
  const Points distinct_source = source(Eigen::all, distinct);
  const Points distinct_target = target(Eigen::all, distinct);
  NoiseBoundSearch search(distinct_source, distinct_target, options);
  search.run();
  return {search.estimate(), clock.elapsed(), search.num_clique_nodes(), search.late(),
          search.cancelled()};
}

}  // namespace gmcr::noise
