#include <algorithm>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"
#include "problem/input.hpp"
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

/// Ascending indices that are in one of the two.
std::vector<Index> united(const std::vector<Index>& a, const std::vector<Index>& b) {
  std::vector<Index> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
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
    Result instance = registration::with_noise_bound(
        source(Eigen::all, left), target(Eigen::all, left),
        options_of(options, left, deadline.remaining()), registration::solve);
    const Certificate& most = instance.certificate;
    const bool is_instance =
        instance.status == Status::Ok && most.lower >= instances.min_instance_inliers &&
        (found.empty() || most.evidence.lower >= instances.min_instance_share *
                                                     found.front().certificate.evidence.lower);
    if (!found.empty() && !is_instance) break;
    renumber(instance.inliers, left);
    renumber(instance.certificate.inliers, left);
    for (Alternative& alternative : instance.alternatives) renumber(alternative.inliers, left);
    // what the returned pose leaves out would be found again as one more instance
    const std::vector<Index> held = united(instance.inliers, instance.certificate.inliers);
    std::vector<Index> rest;
    std::set_difference(left.begin(), left.end(), held.begin(), held.end(),
                        std::back_inserter(rest));
    left = std::move(rest);
    found.push_back(std::move(instance));
    if (!is_instance) break;
  }
  return found;
}

}  // namespace gmcr
