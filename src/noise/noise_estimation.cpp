#include "noise/noise_estimation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <vector>

#include "gmcr/registration.hpp"
#include "noise/noise_bound_search.hpp"
#include "parallel/deadline.hpp"
#include "parallel/parallel_for.hpp"
#include "problem/run.hpp"
#include "proof/certificate.hpp"

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

Options with_bound(const Options& options, double noise_bound) {
  Options given = options;
  given.noise_mode = NoiseMode::Given;
  given.noise_bound = noise_bound;
  return given;
}

/// The options of the solve after the search: what is left of the time, and the word of a caller
/// who stopped the search holds.
Options remaining_options(const Options& options, const BoundSearch& search,
                          const parallel::Deadline& deadline) {
  Options remaining = with_bound(options, search.estimate().noise_bound);
  remaining.time_limit = std::max(deadline.remaining(), parallel::kLeastSeconds);
  if (search.cancelled()) remaining.progress = [](const Progress&) { return false; };
  return remaining;
}

constexpr const char* kChance = "no noise bound makes the consensus better than chance";

/// The answer where no consensus stands out.
Result no_consensus(const Options& options, Index count, const std::string& reason) {
  Result result;
  result.status = Status::NoConsensus;
  result.status_reason = reason;
  result.certificate = proof::certify(0, count, 0, static_cast<double>(count));
  result.diagnostics.num_correspondences = count;
  result.diagnostics.num_used = count;
  result.diagnostics.num_threads = parallel::resolve_num_threads(options.num_threads);
  return result;
}

}  // namespace

Result register_with_estimated_noise(const PointsRef& source, const PointsRef& target,
                                     const Options& options) {
  if (source.cols() < 3) return register_correspondences(source, target, with_bound(options, 1));
  const std::vector<Index> distinct = distinct_correspondences(source, target);
  if (distinct.size() < 3) return no_consensus(options, source.cols(), kChance);
  if (options.admit_all()) {
    // before any work; priors may leave fewer
    Diagnostics unused;
    problem::SolveContext(options, unused).require_memory_for_graph(source.cols());
  }
  const parallel::Deadline deadline(options.time_limit, options.stop);
  const Points distinct_source = source(Eigen::all, distinct);
  const Points distinct_target = target(Eigen::all, distinct);
  BoundSearch search(distinct_source, distinct_target, options);
  search.run();
  const double search_seconds = deadline.elapsed();

  const NoiseEstimate estimate = search.estimate();
  const bool ended_early = search.late() || search.cancelled();
  Result result =
      estimate.log10_false_alarms < 0
          ? register_correspondences(source, target, remaining_options(options, search, deadline))
          : no_consensus(
                options, source.cols(),
                ended_early ? "no noise bound was found before a limit ended the search" : kChance);
  result.noise_estimate = estimate;
  Diagnostics& diagnostics = result.diagnostics;
  diagnostics.stages.insert(diagnostics.stages.begin(), {"noise_bound", search_seconds});
  diagnostics.total_seconds += search_seconds;
  diagnostics.num_clique_nodes += search.num_clique_nodes();
  if (search.late()) {
    diagnostics.limits_hit.push_back(
        {Limit::Time, "the time budget ended the search for a noise bound"});
  }
  if (search.cancelled()) {
    diagnostics.limits_hit.push_back(
        {Limit::Stopped, "the caller stopped the search for a noise bound"});
  }
  return result;
}

}  // namespace gmcr::noise
