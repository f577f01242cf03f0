#include "proof/tighten.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "proof/consensus_search.hpp"

namespace gmcr::proof {
namespace {

using problem::exceeds;
using problem::Measure;
using search::PoseSearch;
using search::RangeGraph;

const LimitHit kEndedEarly{Limit::ConsensusSearch,
                           "the time budget ended the search for consensus sets before its proof"};

/// The value, or the whole number of inliers that it is to rounding or leaves below.
double in_units(Measure measure, double value) {
  return measure == Measure::Inliers ? std::floor(value + 1e-6) : value;
}

/// Time that the bounds on a measure may take.
parallel::Deadline deadline_of(const problem::Run& run, Measure measure) {
  // further hypotheses need some time too
  const double share = run.options().num_hypotheses > 1 ? 0.8 : 1;
  const double remaining = share * run.deadline().remaining();
  return run.deadline().within(measure == Measure::Evidence ? remaining / 2 : remaining);
}

/// Lowers an upper bound on the measure of poses in a range.
double tighten(PoseSearch& poses, const RangeGraph& range, Measure measure, double upper_bound,
               const parallel::Deadline& deadline) {
  problem::Run& run = poses.run();
  if (deadline.expired()) {
    poses.note_early_end(measure, kEndedEarly);
    return upper_bound;
  }
  // the search works on copies of the graph
  constexpr std::size_t kCopies = 4;
  if (kCopies * BitsetGraph::bytes_required(poses.problem().size()) > run.options().memory_limit) {
    run.limit({Limit::Memory, "the memory budget leaves no room to tighten the bounds"});
    return upper_bound;
  }
  const problem::StageTimer timer(run, "certify");
  // most problems are settled at once; of the others a part of the gap is, the larger the longer it
  // takes: to show that nothing exceeds a high target is easier than a low one
  constexpr double kParts[] = {0, 0.85, 0.7, 0.55, 0.4, 0.3, 0.2, 0.1, 0};
  constexpr double kFirstShare = 0.25;  // of the time
  const std::vector<double> weights = search::weights_of(poses.problem(), measure, range.scales);
  const auto try_pose = [&](const problem::CentredPose& pose) {
    poses.try_pose(pose);
    return poses.to_beat(measure);
  };
  const double lowest = poses.to_beat(measure), gap = upper_bound - lowest;
  const parallel::Deadline first_deadline = deadline.within(kFirstShare * deadline.remaining());
  bool first = true;
  for (const double part : kParts) {
    const double target = std::max(poses.to_beat(measure), in_units(measure, lowest + part * gap));
    if (!exceeds(upper_bound, target)) continue;
    if (deadline.expired() || run.stopped()) break;
    run.report("certify", 1 - part);
    ConsensusSearch sets(poses.problem().arrays(), range.graph, weights, range.scales, try_pose,
                         {first ? first_deadline : deadline});
    upper_bound = std::min(upper_bound, sets.run(target));
    first = false;
  }
  upper_bound = std::max(upper_bound, poses.to_beat(measure));
  if (exceeds(upper_bound, poses.to_beat(measure)) && deadline.expired()) {
    poses.note_early_end(measure, kEndedEarly);
  }
  return upper_bound;
}

/// Lowers the bound on a measure over all scales.
double tighten(search::BestPoseSearch& search, Measure measure) {
  PoseSearch& poses = search.poses();
  const parallel::Deadline deadline = deadline_of(poses.run(), measure);
  if (search.graph()) {
    return tighten(poses, *search.graph(), measure, search.bounds().of(measure), deadline);
  }
  return search.scales().lower_upper_bound(
      measure, [&](const RangeGraph& range, Measure of, double upper_bound) {
        return tighten(poses, range, of, upper_bound, deadline);
      });
}

}  // namespace

void tighten(search::BestPoseSearch& search) {
  problem::PerMeasure& bounds = search.bounds();
  const bool is_weighted = search.poses().problem().objective().is_weighted();
  if (is_weighted) bounds.evidence = tighten(search, Measure::Evidence);
  bounds.inliers = tighten(search, Measure::Inliers);
  if (!is_weighted) bounds.evidence = bounds.inliers;
}

}  // namespace gmcr::proof
