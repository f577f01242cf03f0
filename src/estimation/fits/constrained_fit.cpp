#include "estimation/fits/constrained_fit.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/closed_forms/similarity_fit.hpp"
#include "estimation/fits/prior_projection.hpp"
#include "geometry/elementary.hpp"

namespace gmcr::estimation {
namespace {

/// A prior on the translation: the origin of the caller's source frame maps into a ball.
struct Ball {
  Eigen::Vector3d source, target;  ///< that origin and the ball's centre, in the centred frames
  double radius = 0;

  double excess(const Similarity& pose) const { return (pose * source - target).norm() - radius; }
};

std::vector<Ball> balls(const PoseConstraints& constraints) {
  std::vector<Ball> result;
  const auto add = [&](const Eigen::Vector3d& centre, double radius) {
    if (!std::isfinite(radius)) return;
    result.push_back({-constraints.source_origin, centre - constraints.target_origin, radius});
  };
  add(Eigen::Vector3d::Zero(), constraints.priors.max_translation);
  if (const auto& initial = constraints.priors.initial_pose) {
    add(initial->target_from_source.translation, initial->max_translation);
  }
  return result;
}

std::optional<Similarity> fit_rotation_first(const Moments& moments,
                                             const PoseConstraints& constraints) {
  const auto rotation = admitted_rotation(moments.covariance, constraints.priors);
  if (!rotation) return std::nullopt;
  return fit_with_rotation(moments, *rotation, constraints.scales);
}

/// The moments with the origin as a correspondence, so that the fit takes it just into the ball.
///
/// The origin may be far from the points, where a small turn moves it a lot: it joins the fit with
/// the least weight that suffices (the Lagrange multiplier of the prior), or a large one where none
/// does.
Moments pull_into(const Ball& ball, const Moments& moments, const PoseConstraints& constraints) {
  constexpr int kSteps = 40;
  const auto with_weight = [&](double log_share) {
    Moments with_origin = moments;
    with_origin +=
        point_moments(ball.source, ball.target, moments.weight * elementary::exp(log_share));
    return with_origin;
  };
  double low = elementary::log(1e-16),
         high = elementary::log(1e9);  // of the weight over that of all others
  for (int step = 0; step < kSteps; ++step) {
    const double middle = (low + high) / 2;
    const auto fit = fit_rotation_first(with_weight(middle), constraints);
    (fit && ball.excess(*fit) <= 0 ? high : low) = middle;
  }
  return with_weight(high);
}

/// Moves the translation to the nearest that the priors admit.
std::optional<Similarity> clamp_translation(const Similarity& centred,
                                            const PoseConstraints& constraints) {
  // the translation between the caller's frames, and back
  const Eigen::Vector3d shift =
      constraints.target_origin - centred.scale * (centred.rotation * constraints.source_origin);
  const auto admitted = admitted_translation(centred.translation + shift, constraints.priors);
  if (!admitted) return std::nullopt;
  Similarity clamped = centred;
  clamped.translation = *admitted - shift;
  return clamped;
}

}  // namespace

std::optional<Similarity> fit_pose(const PointsRef& source, const PointsRef& target,
                                   const Eigen::ArrayXd& bounds, const std::vector<Index>& indices,
                                   const PoseConstraints& constraints) {
  if (static_cast<Index>(indices.size()) < min_correspondences(constraints)) return std::nullopt;
  return fit_pose(measure_moments(source, target, bounds, indices), constraints);
}

std::optional<Similarity> fit_pose(const Moments& given, const PoseConstraints& constraints) {
  if (constraints.priors.admit_all()) return fit_similarity(given, constraints.scales);
  Moments moments = given;
  std::optional<Similarity> fit = fit_rotation_first(moments, constraints);
  const std::vector<Ball> all = balls(constraints);
  if (!fit || all.empty()) return fit;
  // one ball may push the origin out of the other
  constexpr int kRounds = 4;
  for (int round = 0; round < kRounds; ++round) {
    const Ball& worst = *std::max_element(
        all.begin(), all.end(),
        [&](const Ball& a, const Ball& b) { return a.excess(*fit) < b.excess(*fit); });
    if (worst.excess(*fit) <= 0) return fit;
    moments = pull_into(worst, moments, constraints);
    const auto pulled = fit_rotation_first(moments, constraints);
    if (!pulled) break;
    fit = pulled;
  }
  return clamp_translation(*fit, constraints);
}

}  // namespace gmcr::estimation
