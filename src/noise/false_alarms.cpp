#include "noise/false_alarms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/elementary.hpp"
#include "gmcr/options.hpp"
#include "problem/selection.hpp"

namespace gmcr::noise {
namespace {

constexpr Index kFewPairs = 10'000;
constexpr Index kMinSample = 3;  // correspondences that determine a pose

/// log10 of k! for k = 0..n.
std::vector<double> log_factorials(Index n) {
  std::vector<double> logs(static_cast<std::size_t>(n) + 1, 0.0);
  for (std::size_t k = 1; k < logs.size(); ++k) {
    logs[k] = logs[k - 1] + elementary::log10(static_cast<double>(k));
  }
  return logs;
}

double log_choose(const std::vector<double>& log_factorial, Index n, Index k) {
  const auto at = [&](Index m) { return log_factorial[static_cast<std::size_t>(m)]; };
  return at(n) - at(k) - at(n - k);
}

}  // namespace

PairDistances::PairDistances(const PointsRef& points, const PointsRef& others, Index max_pairs) {
  // Pairs at a few distances along the (cyclic) order, spread evenly.
  const Index n = points.cols(), num_shifts = n / 2;
  constexpr Index kMinShifts = 4;
  const Index used = std::min(std::max(max_pairs / std::max<Index>(n, 1), kMinShifts), num_shifts);
  for (Index k = 1; k <= used; ++k) {
    const Index shift = k * num_shifts / used;
    for (Index i = 0; i < n; ++i) {
      const double distance = (others.col((i + shift) % n) - points.col(i)).norm();
      if (distance > 0) sorted_.push_back(distance);
    }
  }
  if (sorted_.empty()) return;
  std::sort(sorted_.begin(), sorted_.end());

  // the power law between the lowest distances, few enough to be local and many enough to tell
  const std::size_t last = sorted_.size() - 1;
  const std::size_t low = std::min<std::size_t>(10, last / 20);
  const std::size_t high = std::min(10 * low + 9, last);
  tail_ = Tail::through(sorted_[low], low, sorted_[high], high, sorted_.size());
}

double PairDistances::median() const { return empty() ? 0 : sorted_[sorted_.size() / 2]; }

double PairDistances::share_within(double radius) const {
  if (empty()) return 1;
  if (radius < tail_.radius) return tail_.share_within(radius);
  const auto end = std::upper_bound(sorted_.begin(), sorted_.end(), radius);
  return static_cast<double>(end - sorted_.begin()) / static_cast<double>(sorted_.size());
}

FalseAlarms count_false_alarms(const Eigen::ArrayXd& residuals, double scale,
                               const PairDistances& source, const PairDistances& target,
                               const PairDistances& between, double rounding) {
  FalseAlarms alarms;
  const Index n = residuals.size();
  if (n <= kMinSample) return alarms;
  std::vector<double> sorted(residuals.begin(), residuals.end());
  std::sort(sorted.begin(), sorted.end());
  const std::vector<double> log_factorial = log_factorials(n);
  for (Index k = kMinSample + 1; k <= n; ++k) {
    const double residual = std::max(sorted[static_cast<std::size_t>(k - 1)], rounding);
    const double alpha =
        std::min(std::max(target.share_within(residual), source.share_within(residual / scale)),
                 between.share_within(residual));
    alarms.residuals.push_back(residual);
    alarms.log10.push_back(elementary::log10(static_cast<double>(n - kMinSample)) +
                           log_choose(log_factorial, n, k) +
                           log_choose(log_factorial, k, kMinSample) +
                           static_cast<double>(k - kMinSample) * elementary::log10(alpha));
  }
  return alarms;
}

PoseAlarms::PoseAlarms(const PointsRef& source, const PointsRef& target)
    : source_(source),
      target_(target),
      source_distances_(source_, kFewPairs),
      target_distances_(target_, kFewPairs) {
  // what a residual of typical coordinates is off by
  constexpr double kDigits = 64 * std::numeric_limits<double>::epsilon();
  rounding_ = std::max(kDigits * problem::middle_of(target_.cwiseAbs()).norm(), kLeastMagnitude);
}

double PoseAlarms::least_log10(const Similarity& pose) const {
  const Points images = pose.apply(source_);
  const Eigen::ArrayXd residuals = (target_ - images).colwise().norm();
  const FalseAlarms alarms =
      count_false_alarms(residuals, pose.scale, source_distances_, target_distances_,
                         PairDistances(images, target_, kFewPairs), rounding_);
  return alarms.empty() ? 0 : *std::min_element(alarms.log10.begin(), alarms.log10.end());
}

}  // namespace gmcr::noise
