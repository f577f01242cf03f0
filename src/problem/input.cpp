#include "problem/input.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace gmcr::problem {
namespace {

Eigen::ArrayXd inlier_bounds(const Options& options, Index count) {
  if (options.noise_bounds.empty()) {
    return Eigen::ArrayXd::Constant(count, options.noise_bound);
  }
  return Eigen::Map<const Eigen::ArrayXd>(options.noise_bounds.data(), count);
}

}  // namespace

void validate_input(const PointsRef& source, const PointsRef& target, const Options& options) {
  options.validate();
  if (source.cols() != target.cols()) {
    throw std::invalid_argument("target: " + std::to_string(target.cols()) +
                                " points, but source has " + std::to_string(source.cols()));
  }
  const auto num_bounds = static_cast<Index>(options.noise_bounds.size());
  if (num_bounds != 0 && num_bounds != source.cols()) {
    throw InvalidOption("noise_bounds", std::to_string(num_bounds) + " values for " +
                                            std::to_string(source.cols()) + " correspondences");
  }
  for (const auto& [name, points] : {std::pair<const char*, const PointsRef&>{"source", source},
                                     std::pair<const char*, const PointsRef&>{"target", target}}) {
    for (Index i = 0; i < points.cols(); ++i) {
      if (points.col(i).allFinite()) continue;
      throw std::invalid_argument(std::string(name) + ": point " + std::to_string(i) +
                                  " is not finite");
    }
  }
}

Correspondences correspondences_of(const PointsRef& source, const PointsRef& target,
                                   const Options& options) {
  Correspondences input;
  input.source = source;
  input.target = target;
  input.bounds = inlier_bounds(options, source.cols());
  return input;
}

}  // namespace gmcr::problem
