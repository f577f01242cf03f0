#include "proof/improve.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "proof/consensus_search.hpp"

namespace gmcr::proof {
namespace {

using problem::exceeds;
using problem::Measure;
using search::PoseSearch;
using search::RangeGraph;

/// Matches above which cliques alone decide: the search meets few sets by so much work.
constexpr Index kMostMatches = 256;
constexpr std::uint64_t kWorkAtOneScale = 10'000, kWorkOverScales = 250'000;

/// Searches one graph after the other until the work is done.
class Improvement {
 public:
  Improvement(PoseSearch& poses, std::uint64_t work) : poses_(poses), work_left_(work) {}

  /// @return bound on the evidence of poses in the range; nullopt where no work is left.
  std::optional<double> operator()(const RangeGraph& range, double upper_bound) {
    const double to_beat = poses_.to_beat(Measure::Evidence);
    if (!exceeds(upper_bound, to_beat)) return upper_bound;
    if (work_left_ == 0 || poses_.run().stopped()) return std::nullopt;
    const problem::StageTimer timer(poses_.run(), "consensus_sets");
    const std::vector<double> weights =
        search::weights_of(poses_.problem(), Measure::Evidence, range.scales);
    const auto try_pose = [&](const problem::CentredPose& pose) {
      poses_.try_pose(pose);
      return poses_.to_beat(Measure::Evidence);
    };
    ConsensusSearch sets(poses_.problem().arrays(), range.graph, weights, range.scales, try_pose,
                         {poses_.run().deadline(), work_left_});
    upper_bound = std::min(upper_bound, sets.run(to_beat));
    work_left_ = sets.work_left();
    return std::max(upper_bound, poses_.to_beat(Measure::Evidence));
  }

 private:
  PoseSearch& poses_;
  std::uint64_t work_left_;
};

}  // namespace

void improve(search::BestPoseSearch& search) {
  PoseSearch& poses = search.poses();
  double& bound = search.bounds().evidence;
  if (search.has_no_graphs() || poses.problem().size() > kMostMatches) return;
  if (!exceeds(bound, poses.to_beat(Measure::Evidence))) return;
  Improvement improved(poses, search.graph() ? kWorkAtOneScale : kWorkOverScales);
  if (search.graph()) {
    bound = improved(*search.graph(), bound).value_or(bound);
  } else {
    const auto tighten = [&](const RangeGraph& range, Measure, double upper_bound) {
      return improved(range, upper_bound);
    };
    bound = std::min(bound, search.scales().lower_upper_bound(Measure::Evidence, tighten));
  }
  if (!poses.problem().objective().is_weighted()) search.bounds().inliers = bound;
}

}  // namespace gmcr::proof
