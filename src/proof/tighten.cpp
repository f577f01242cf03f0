#include "proof/tighten.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "proof/consensus_search.hpp"

namespace gmcr::proof {
namespace {

constexpr const char* kEndedEarly = "the time budget ended the joint search before its proof";

/// The value, or the whole number of inliers that it is to rounding or leaves below.
double in_units(search::Measure measure, double value) {
  return measure == search::Measure::Inliers ? std::floor(value + 1e-6) : value;
}

}  // namespace

parallel::Deadline certify_deadline(search::PoseSearch& search, search::Measure measure) {
  if (!search.certifies()) return parallel::Deadline(0);
  // further hypotheses need some time too
  const double share = search.context().options().num_hypotheses > 1 ? 0.8 : 1;
  const parallel::Deadline& deadline = search.context().deadline();
  const double remaining = share * deadline.remaining();
  return deadline.within(measure == search::Measure::Evidence ? remaining / 2 : remaining);
}

double tighten(search::PoseSearch& search, const search::RangeGraph& range, search::Measure measure,
               double upper_bound, const parallel::Deadline& deadline) {
  if (deadline.expired()) {
    if (search.certifies()) search.note_early_end(measure, {Limit::ConsensusSearch, kEndedEarly});
    return upper_bound;
  }
  // the search works on copies of the graph
  constexpr std::size_t kCopies = 4;
  if (kCopies * BitsetGraph::bytes_required(search.arrays().size()) >
      search.context().options().memory_limit) {
    search.context().limit(
        {Limit::Memory, "the memory budget leaves no room to tighten the bounds"});
    return upper_bound;
  }
  const StageTimer timer(search.context(), "certify");
  // most problems are settled at once; of the others a part of the gap is, the larger the longer it
  // takes: to show that nothing search::exceeds a high target is easier than a low one
  constexpr double kParts[] = {0, 0.85, 0.7, 0.55, 0.4, 0.3, 0.2, 0.1, 0};
  constexpr double kFirstShare = 0.25;  // of the time
  const std::vector<double> weights = search.weights(measure, range.scales);
  const auto offer = [&](const Similarity& pose) {
    search.offer(pose);
    return search.to_beat(measure);
  };
  const double lowest = search.to_beat(measure), gap = upper_bound - lowest;
  const parallel::Deadline first_deadline = deadline.within(kFirstShare * deadline.remaining());
  bool first = true;
  for (const double part : kParts) {
    const double target = std::max(search.to_beat(measure), in_units(measure, lowest + part * gap));
    if (!search::exceeds(upper_bound, target)) continue;
    if (deadline.expired() || search.context().stopped()) break;
    search.context().report("certify", 1 - part);
    JointSearch joint(search.arrays(), range.graph, weights, range.scales, offer,
                      first ? first_deadline : deadline);
    upper_bound = std::min(upper_bound, joint.run(target));
    first = false;
  }
  upper_bound = std::max(upper_bound, search.to_beat(measure));
  if (search::exceeds(upper_bound, search.to_beat(measure)) && deadline.expired()) {
    search.note_early_end(measure, {Limit::ConsensusSearch, kEndedEarly});
  }
  return upper_bound;
}

}  // namespace gmcr::proof
