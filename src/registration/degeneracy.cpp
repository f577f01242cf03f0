#include "registration/degeneracy.hpp"

#include <algorithm>
#include <numbers>

#include "estimation/spread.hpp"

namespace gmcr::registration {

std::string degeneracy_reason(const Points& source, const Similarity& pose,
                              const std::vector<Index>& inliers, double bound,
                              const Priors& priors) {
  constexpr double kKnownAxis = std::numbers::pi / 180;
  const estimation::Spread spread = estimation::measure_spread(source, inliers);
  const double tolerance = std::max(bound / 2, 1e-9 * pose.scale * spread.from_centroid);
  if (pose.scale * spread.from_centroid <= tolerance) {
    return "the inliers coincide within the noise bound: rotation and scale are not determined";
  }
  if (priors.gravity && priors.gravity->max_tilt <= kKnownAxis) {
    // only the rotation about gravity is left, which points off the line along it determine
    const double reach = estimation::reach_from_line(source, inliers, priors.gravity->source);
    if (pose.scale * reach > tolerance) return {};
    return "the inliers are on a line along gravity within the noise bound: the rotation about it "
           "is not determined";
  }
  if (pose.scale * spread.from_line <= tolerance) {
    return "the inliers are collinear within the noise bound: the rotation about their line is not "
           "determined";
  }
  return {};
}

}  // namespace gmcr::registration
