#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"
#include "problem/input.hpp"
#include "problem/problem.hpp"
#include "refine/least_squares.hpp"
#include "registration/answer.hpp"
#include "registration/estimated_noise.hpp"
#include "registration/solve.hpp"

namespace gmcr {
namespace {

/// The options for some of the correspondences.
Options options_of(const Options& options, const std::vector<Index>& left, double seconds) {
  Options some = options;
  some.time_limit = std::max(seconds, parallel::kLeastSeconds);
  if (!options.noise_bounds.empty()) {
    some.noise_bounds.clear();
    for (const Index i : left) {
      some.noise_bounds.push_back(options.noise_bounds[static_cast<std::size_t>(i)]);
    }
  }
  return some;
}

/// Indices into the caller's input from indices into what was left of it.
void renumber(std::vector<Index>& indices, const std::vector<Index>& left) {
  for (Index& i : indices) i = left[static_cast<std::size_t>(i)];
}

/// An answer, and the one before its least-squares fit: what the fit leaves out would be found
/// again as one more instance.
struct Instance {
  Result held, result;
};

Instance find_instance(const PointsRef& source, const PointsRef& target, const Options& options) {
  std::optional<Result> fitted;
  const auto solve = [&](const PointsRef& from, const PointsRef& to, const Options& given) {
    problem::Run run(given);
    const problem::Problem problem(from, to, given, run);
    const problem::Found found = registration::find(problem, run);
    Result held = registration::answer(problem, found, run);
    if (given.least_squares && !found.poses.empty()) {
      fitted = registration::answer(problem, refine::fit_to_consensus(problem, found), run);
    }
    return held;
  };
  Result held = registration::with_noise_bound(source, target, options, solve);
  if (!fitted) return {held, held};
  fitted->noise_estimate = held.noise_estimate;
  fitted->diagnostics = held.diagnostics;
  return {std::move(held), std::move(*fitted)};
}

}  // namespace

std::vector<Result> register_instances(const PointsRef& source, const PointsRef& target,
                                       const Options& options, const InstanceOptions& instances) {
  problem::validate_input(source, target, options);
  instances.validate();
  const parallel::Deadline deadline(options.time_limit, options.stop);
  std::vector<Index> left(static_cast<std::size_t>(source.cols()));
  std::iota(left.begin(), left.end(), Index{0});
  std::vector<Result> found;
  while (static_cast<int>(found.size()) < instances.max_instances) {
    if (!found.empty() && deadline.expired()) {
      found.front().diagnostics.limits_hit.push_back(
          {Limit::Time, "the time budget ended the search for further instances"});
      break;
    }
    if (!found.empty() && static_cast<Index>(left.size()) < instances.min_instance_inliers) break;
    Instance instance = find_instance(source(Eigen::all, left), target(Eigen::all, left),
                                      options_of(options, left, deadline.remaining()));
    const bool is_instance =
        instance.held.status == Status::Ok &&
        static_cast<Index>(instance.held.inliers.size()) >= instances.min_instance_inliers &&
        (found.empty() ||
         instance.held.evidence >= instances.min_instance_share * found.front().evidence);
    if (!found.empty() && !is_instance) break;
    renumber(instance.held.inliers, left);
    renumber(instance.result.inliers, left);
    for (Alternative& alternative : instance.result.alternatives) {
      renumber(alternative.inliers, left);
    }
    std::vector<Index> rest;
    std::set_difference(left.begin(), left.end(), instance.held.inliers.begin(),
                        instance.held.inliers.end(), std::back_inserter(rest));
    left = std::move(rest);
    found.push_back(std::move(instance.result));
    if (!is_instance) break;
  }
  return found;
}

}  // namespace gmcr
