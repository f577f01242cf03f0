#include "frontend/refine_clouds.hpp"

#include <iomanip>
#include <sstream>
#include <utility>

#include "frontend/alignment/refine_pose.hpp"
#include "frontend/cloud_pair.hpp"
#include "frontend/stage_clock.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr {
namespace frontend {
namespace {

constexpr double kCell = 0.5;         // voxels: cells of the finer clouds
constexpr double kSettleReach = 1.5;  // cells
constexpr Index kSettleSamples = 6000;

std::string note_on(const CloudResult& result, const Similarity& matched) {
  if (!result.refinement.is_applied) {
    return "ICP changed nothing: the surfaces meet best where the matches put them";
  }
  std::ostringstream note;
  note << std::setprecision(3) << "ICP turned the pose by "
       << rotation_error_deg(result.registration.target_from_source.rotation, matched.rotation)
       << " deg; the surfaces meet to " << result.refinement.noise;
  return note.str();
}

void note_time(CloudResult& result, const parallel::Deadline& deadline) {
  if (!deadline.expired()) return;
  result.registration.diagnostics.limits_hit.push_back(
      {Limit::Time, "the time budget ended the refinement"});
}

}  // namespace

CloudResult take(CloudResult result, const Candidate& candidate, const Options& options) {
  result = with_pose(std::move(result), candidate.target_from_source, options);
  result.refinement.is_applied = result.refinement.is_applied || candidate.is_refined;
  if (candidate.is_refined) result.refinement.noise = candidate.noise;
  return result;
}

CloudResult settle(CloudResult result, const PointsRef& source, const PointsRef& target,
                   const Similarity& matched, const Options& options,
                   const parallel::Deadline& deadline) {
  result.refinement.method = "icp";
  result.refinement.note = "no pose to refine";
  if (result.registration.status != Status::Ok) return result;
  StageClock clock(result.registration.diagnostics.stages);
  if (!deadline.expired()) {
    const CloudMatches& matches = result.matches;
    const double cell = kCell * matches.target_voxel_size;
    CentredPair pair(voxel_grid(source, kCell * matches.source_voxel_size),
                     voxel_grid(target, cell));
    const RefinedPose refined =
        refine_pose(pair, result.registration.target_from_source,
                    {cell, kSettleReach, kSettleSamples}, options, deadline);
    if (refined.is_applied) {
      const Candidate candidate{refined.target_from_source, true, refined.noise, 0};
      result = take(std::move(result), candidate, options);
    }
  }
  note_time(result, deadline);
  result.refinement.note = note_on(result, matched);
  clock.lap("refinement");
  return result;
}

}  // namespace frontend

CloudResult refine_clouds(CloudResult result, const PointsRef& source, const PointsRef& target,
                          const Options& options) {
  frontend::validate_pair(source, target, {}, options);
  const parallel::Deadline deadline(options.time_limit, options.stop);
  const Similarity matched = result.registration.target_from_source;
  if (result.registration.status == Status::Ok) {
    frontend::SurfaceJudge judge(result.matches, options);
    result = frontend::take(std::move(result), judge.approach(matched, deadline), options);
  }
  return frontend::settle(std::move(result), source, target, matched, options, deadline);
}

}  // namespace gmcr
