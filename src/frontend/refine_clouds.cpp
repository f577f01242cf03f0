#include "frontend/refine_clouds.hpp"

#include <iomanip>
#include <sstream>
#include <utility>

#include "frontend/alignment/refine_pose.hpp"
#include "frontend/alignment/surface_covariance.hpp"
#include "frontend/cloud_pair.hpp"
#include "frontend/features/stage_clock.hpp"
#include "frontend/judgement/hypotheses.hpp"
#include "frontend/judgement/judged_pose.hpp"
#include "gmcr/metrics.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace frontend {
namespace {

constexpr double kCell = 0.5;         // voxels: cells of the finer clouds
constexpr double kSettleReach = 1.5;  // cells
constexpr double kSettleStep = 1e-3;  // cells
constexpr Index kSettleSamples = 6000;

std::string note_on(const CloudResult& result, const Similarity& matched) {
  if (!result.refinement.is_applied) {
    return "ICP changed nothing: the surfaces meet best where the matches put them";
  }
  std::ostringstream note;
  note << std::setprecision(3);
  if (result.found_by_turning) {
    note << "the source was turned all around, then refined by ICP";
  } else {
    note << "ICP turned the pose by "
         << rotation_error_deg(result.registration.target_from_source.rotation, matched.rotation)
         << " deg";
  }
  note << "; the surfaces meet to " << result.refinement.noise << " m";
  return note.str();
}

void note_time(CloudResult& result, const parallel::Deadline& deadline) {
  if (!deadline.expired()) return;
  result.registration.diagnostics.limits_hit.push_back(
      {Limit::Time, "the time budget ended the refinement"});
}

}  // namespace

CloudResult settle(CloudResult result, const PointsRef& source, const PointsRef& target,
                   CentredPair& voxels, const Similarity& matched, const Options& options,
                   const parallel::Deadline& deadline) {
  result.refinement.method = "icp";
  StageClock clock(result.registration.diagnostics.stages);
  if (!begin_stage(options, "refinement")) {
    result.registration.diagnostics.limits_hit.push_back(
        {Limit::Stopped, "the caller stopped the refinement"});
  } else if (!deadline.expired()) {
    const double cell = kCell * result.voxels.target_voxel_size;
    const double source_cell = kCell * result.voxels.source_voxel_size;
    Points from, to;
    parallel::call_both(
        options.num_threads, [&] { from = voxel_grid(source, source_cell); },
        [&] { to = voxel_grid(target, cell); });
    CentredPair pair(from, to, source_cell, cell, options.num_threads);
    const RefinedPose refined =
        refine_pose(pair, result.registration.target_from_source,
                    {cell, kSettleReach, kSettleSamples, kSettleStep}, options, deadline);
    if (refined.is_applied) {
      const Candidate candidate{refined.target_from_source, true, refined.noise, 0};
      result = take(std::move(result), candidate, voxels, options);
    }
    std::optional<Covariance>& covariance = result.registration.covariance;
    covariance = surface_covariance(pair, refined, options.scale_mode == ScaleMode::Estimated,
                                    covariance, options.num_threads);
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
  if (result.registration.status != Status::Ok) {
    result.refinement.note = "no pose to refine";
    return result;
  }
  const auto voxels = frontend::centred_pair(result.voxels, options.num_threads);
  const auto& [from, to] = std::tie(result.voxels.source_viewpoint, result.voxels.target_viewpoint);
  if (from) voxels->source_view = frontend::view_from(*from, source);
  if (to) voxels->target_view = frontend::view_from(*to, target);
  frontend::Hypotheses hypotheses(voxels, result.voxels.target_voxel_size, options, deadline);
  if (result.found_by_turning) hypotheses.expect_no_matches();
  const frontend::Candidate candidate = hypotheses.approach(matched, result.rivals);
  result.rivals = hypotheses.rivals_of(candidate, [&](const frontend::Candidate& other) {
    return frontend::evidence_of(result, other, options);
  });
  result = frontend::take(std::move(result), candidate, *voxels, options);
  return frontend::settle(std::move(result), source, target, *voxels, matched, options, deadline);
}

}  // namespace gmcr
