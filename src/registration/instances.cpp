#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"
#include "problem/correspondences.hpp"
#include "problem/input.hpp"

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
    const auto solve = [&](bool least_squares) {
      Options some = options_of(options, left, deadline.remaining());
      some.least_squares = least_squares;
      return register_correspondences(source(Eigen::all, left), target(Eigen::all, left), some);
    };
    // what a least-squares fit leaves out would be found again as one more instance
    Result result = solve(false);
    const bool is_instance =
        result.status == Status::Ok &&
        static_cast<Index>(result.inliers.size()) >= instances.min_instance_inliers &&
        (found.empty() || result.evidence >= instances.min_instance_share * found.front().evidence);
    if (!found.empty() && !is_instance) break;
    std::vector<Index> taken = result.inliers;
    renumber(taken, left);
    if (options.least_squares) result = solve(true);
    renumber(result.inliers, left);
    for (Alternative& alternative : result.alternatives) renumber(alternative.inliers, left);
    std::vector<Index> rest;
    std::set_difference(left.begin(), left.end(), taken.begin(), taken.end(),
                        std::back_inserter(rest));
    left = std::move(rest);
    found.push_back(std::move(result));
    if (!is_instance) break;
  }
  return found;
}

}  // namespace gmcr
