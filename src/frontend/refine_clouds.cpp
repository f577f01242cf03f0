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

// The pose of the matches is off by up to their noise bound; that of the voxels by far less.
constexpr double kApproachReach = 3;  // voxels
constexpr Index kApproachSamples = 2500;
constexpr double kCell = 0.5;         // voxels: cells of the finer clouds
constexpr double kSettleReach = 1.5;  // cells
constexpr Index kSettleSamples = 6000;

/// The pose in place of that of the result, where the surfaces meet more closely there.
CloudResult take(CloudResult result, const RefinedPose& refined, const Options& options) {
  if (!refined.is_applied) return result;
  result.refinement.is_applied = true;
  result.refinement.noise = refined.noise;
  return with_pose(std::move(result), refined.target_from_source, options);
}

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

CloudResult approach(CloudResult result, const Options& options,
                     const parallel::Deadline& deadline) {
  if (result.registration.status != Status::Ok) return result;
  StageClock clock(result.registration.diagnostics.stages);
  const CloudMatches& matches = result.matches;
  const RefinedPose refined = refine_pose(
      matches.source_voxels, matches.target_voxels, result.registration.target_from_source,
      {matches.target_voxel_size, kApproachReach, kApproachSamples}, options, deadline);
  result = take(std::move(result), refined, options);
  clock.lap("refinement");
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
    const RefinedPose refined =
        refine_pose(voxel_grid(source, kCell * matches.source_voxel_size), voxel_grid(target, cell),
                    result.registration.target_from_source, {cell, kSettleReach, kSettleSamples},
                    options, deadline);
    result = take(std::move(result), refined, options);
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
  result = frontend::approach(std::move(result), options, deadline);
  return frontend::settle(std::move(result), source, target, matched, options, deadline);
}

}  // namespace gmcr
