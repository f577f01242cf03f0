#include "problem/input.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace gmcr::problem {
namespace {

/// Whether a coordinate is 0 or of a magnitude that a solve takes; no NaN is.
bool is_coordinate(double value) {
  const double magnitude = std::abs(value);
  return value == 0 || (magnitude >= kLeastMagnitude && magnitude <= kLargestMagnitude);
}

/// @throws std::invalid_argument naming the first point with a coordinate that is none.
void require_magnitudes(const char* name, const PointsRef& points) {
  for (Index i = 0; i < points.cols(); ++i) {
    const auto point = points.col(i);
    if (is_coordinate(point[0]) & is_coordinate(point[1]) & is_coordinate(point[2])) continue;
    std::ostringstream problem;
    problem << name << ": point " << i;
    if (point.allFinite()) {
      problem << " is (" << point.transpose().format(Eigen::IOFormat(6, 0, ", ", ", "))
              << "); a coordinate is 0 or has a magnitude from " << kLeastMagnitude << " to "
              << kLargestMagnitude;
    } else {
      problem << " is not finite";
    }
    throw std::invalid_argument(problem.str());
  }
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
  require_magnitudes("source", source);
  require_magnitudes("target", target);
}

Eigen::ArrayXd inlier_bounds(const Options& options, Index count) {
  if (options.noise_bounds.empty()) {
    return Eigen::ArrayXd::Constant(count, options.noise_bound);
  }
  return Eigen::Map<const Eigen::ArrayXd>(options.noise_bounds.data(), count);
}

}  // namespace gmcr::problem
