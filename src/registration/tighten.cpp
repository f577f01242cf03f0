#include "registration/tighten.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "registration/joint_search.hpp"

namespace gmcr {
namespace {

/// Looks for more than the given part of the gap above what was achieved; 0: for anything better.
double try_part(PoseSearch& search, const RangeGraph& range, Measure measure,
                const std::vector<double>& weights, double target, const Deadline& deadline) {
  const auto offer = [&](const Similarity& pose) {
    search.offer(pose);
    return search.to_beat(measure);
  };
  return JointSearch(search.arrays(), range.graph, weights, range.scales, offer, deadline)
      .run(target);
}

}  // namespace

double tighten(PoseSearch& search, const RangeGraph& range, Measure measure, double upper_bound) {
  if (!search.context().options().certify) return upper_bound;
  const StageTimer timer(search.context(), "certify");
  // most problems are settled at once; of the others part of the gap is, the more the longer it
  // took
  constexpr double kParts[] = {0, 0.85, 0.7, 0.55, 0.4, 0.3, 0.2, 0.1, 0};
  constexpr double kFirstShare = 0.25;  // of the time left
  const std::vector<double> weights = search.weights(measure, range.scales);
  const double gap = upper_bound - search.to_beat(measure);
  bool first = true;
  for (const double part : kParts) {
    const double to_beat = search.to_beat(measure);
    if (upper_bound <= to_beat * (1 + 1e-12) || search.context().stopped()) break;
    const double target = std::max(to_beat, std::floor(upper_bound - (1 - part) * gap));
    const double seconds = search.context().deadline().remaining() * (first ? kFirstShare : 1);
    const Deadline deadline(seconds);
    upper_bound = std::min(upper_bound,
                           std::max(search.to_beat(measure),
                                    try_part(search, range, measure, weights, target, deadline)));
    if (deadline.expired() && !first) break;
    first = false;
  }
  return upper_bound;
}

UpperBounds tighten(PoseSearch& search, const RangeGraph& range, UpperBounds bounds) {
  bounds.inliers = tighten(search, range, Measure::Inliers, bounds.inliers);
  bounds.evidence =
      std::min(bounds.evidence, std::max(bounds.inliers, search.to_beat(Measure::Evidence)));
  bounds.evidence = search.counts_evidence()
                        ? tighten(search, range, Measure::Evidence, bounds.evidence)
                        : bounds.inliers;
  return bounds;
}

}  // namespace gmcr
