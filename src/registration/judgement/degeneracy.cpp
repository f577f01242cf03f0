#include "registration/judgement/degeneracy.hpp"

#include "estimation/fits/pose_constraints.hpp"
#include "estimation/uncertainty/spread.hpp"
#include "problem/selection.hpp"

namespace gmcr::registration {
namespace {

std::string reason_of(const PointsRef& source, const Similarity& pose,
                      const std::vector<Index>& inliers, const Eigen::ArrayXd& bounds,
                      const Options& options) {
  const estimation::KnownRotation known = estimation::known_rotation(options);
  const bool scale_is_known = options.scale_mode == ScaleMode::Known;
  if (known == estimation::KnownRotation::All && scale_is_known) return {};
  const estimation::Spread spread = estimation::measure_spread(source, inliers, bounds);
  // what is within rounding of nothing is nothing
  const Eigen::ArrayXd tolerances =
      (bounds / 2).max(1e-9 * pose.scale * spread.from_centroid.max(spread.radius));
  const auto says_nothing = [&](const Eigen::ArrayXd& distances) {
    return (pose.scale * distances <= tolerances).all();
  };
  if (says_nothing(spread.from_centroid)) {
    return scale_is_known ? "the inliers coincide within the noise bound: the rotation is not "
                            "determined"
           : known == estimation::KnownRotation::All
               ? "the inliers coincide within the noise bound: the scale is not determined"
               : "the inliers coincide within the noise bound: rotation and scale are not "
                 "determined";
  }
  if (known == estimation::KnownRotation::All) return {};
  if (known == estimation::KnownRotation::ButAboutAxis) {
    // points off a line along the axis determine the rotation about it
    if (!says_nothing(
            estimation::distances_from_line(source, inliers, bounds, options.gravity->source))) {
      return {};
    }
    return "the inliers are on a line along gravity within the noise bound: the rotation about it "
           "is not determined";
  }
  if (says_nothing(spread.from_line)) {
    return "the inliers are collinear within the noise bound: the rotation about their line is not "
           "determined";
  }
  return {};
}

}  // namespace

std::string degeneracy_reason(const PointsRef& source, const Similarity& pose,
                              const std::vector<Index>& inliers, const Eigen::ArrayXd& bounds,
                              const Options& options) {
  constexpr Index kMany = 4096, kSome = 1024;
  const auto count = static_cast<Index>(inliers.size());
  if (count > kMany) {
    // what some of them determine, all do
    const std::vector<Index> places = problem::stratified_selection(count, kSome);
    std::vector<Index> some;
    for (const Index k : places) some.push_back(inliers[static_cast<std::size_t>(k)]);
    if (reason_of(source, pose, some, bounds(places), options).empty()) return {};
  }
  return reason_of(source, pose, inliers, bounds, options);
}

}  // namespace gmcr::registration
