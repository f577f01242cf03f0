#include "frontend/unknown_scale.hpp"

#include <algorithm>
#include <vector>

#include "frontend/judgement/judged_pose.hpp"
#include "gmcr/registration.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kNear = 1.1;  // guesses of real pairs were up to 6 % off

}  // namespace

bool narrows_scale(const Options& options) {
  return options.scale_mode == ScaleMode::Estimated && options.method == Method::Gmcr &&
         !options.certify && options.num_hypotheses == 1;
}

ScaleRange scales_about(double scale, const Options& options) {
  ScaleRange range{scale / kNear, scale * kNear};
  if (options.scale_range) {
    range.min = std::max(range.min, options.scale_range->min);
    range.max = std::min(range.max, options.scale_range->max);
  }
  return range;
}

FrontendOptions at_scale(FrontendOptions frontend, double scale, CloudScales& source,
                         CloudScales& target) {
  if (frontend.voxel_size == 0) {
    frontend.voxel_size = frontend.source_voxel_size > 0
                              ? frontend.source_voxel_size * scale
                              : std::min(source.voxel_size() * scale, target.voxel_size());
  }
  if (frontend.source_voxel_size == 0) frontend.source_voxel_size = frontend.voxel_size / scale;
  return frontend;
}

void add_poses_at_scale(CloudResult& result, const Options& options, int num_poses) {
  Result& registration = result.registration;
  if (registration.status != Status::Ok) return;
  Options known = options_with_bound(options, result.matches);
  known.scale_mode = ScaleMode::Known;
  known.scale = registration.target_from_source.scale;
  known.scale_range.reset();
  known.num_hypotheses = num_poses;
  const Result more = register_correspondences(result.matches.source, result.matches.target, known);
  for (const StageTime& stage : more.diagnostics.stages) {
    add_stage(registration.diagnostics.stages, stage.name, stage.seconds);
  }
  if (more.status != Status::Ok) return;
  std::vector<Alternative>& alternatives = registration.alternatives;
  alternatives.push_back({more.target_from_source, more.inliers, more.evidence});
  alternatives.insert(alternatives.end(), more.alternatives.begin(), more.alternatives.end());
}

}  // namespace gmcr::frontend
