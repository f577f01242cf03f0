#include <stdexcept>
#include <tuple>

#include "frontend/cloud_pair.hpp"
#include "frontend/overlap.hpp"
#include "frontend/stage_clock.hpp"
#include "frontend/verdict.hpp"
#include "gmcr/registration.hpp"

namespace gmcr {
namespace {

/// One attempt from raw clouds to a judged pose.
CloudResult attempt(const PointsRef& source, const PointsRef& target,
                    const FrontendOptions& frontend, const Options& options,
                    const FrontendSetting& setting) {
  CloudResult result;
  result.num_source_points = source.cols();
  result.num_target_points = target.cols();
  result.matches = match_with(source, target, frontend, options, setting);
  Options solver = options;
  solver.noise_bound = result.matches.noise_bound;
  result.registration =
      register_correspondences(result.matches.source, result.matches.target, solver);
  if (result.registration.status == Status::Ok) {
    const Overlap overlap =
        measure_overlap(result.matches.source_voxels, result.matches.target_voxels,
                        result.registration.target_from_source, result.matches.target_voxel_size,
                        options.num_threads);
    result.fitness = overlap.fitness;
    result.overlap_rmse = overlap.rmse;
  }
  judge(result);
  return result;
}

bool better(const CloudResult& a, const CloudResult& b) {
  const auto key = [](const CloudResult& r) {
    return std::tuple(-static_cast<int>(r.verdict), r.registration.inliers.size(), r.fitness);
  };
  return key(a) > key(b);
}

void add_stages(std::vector<StageTime>& sum, const std::vector<StageTime>& stages) {
  for (const StageTime& stage : stages) add_stage(sum, stage.name, stage.seconds);
}

}  // namespace

CloudResult register_clouds(const PointsRef& source, const PointsRef& target,
                            const FrontendOptions& frontend, const Options& options) {
  validate_pair(source, target, frontend, options);
  if (!options.noise_bounds.empty()) {
    throw std::invalid_argument("noise_bounds: " + std::to_string(options.noise_bounds.size()) +
                                " values for matches that are not known yet");
  }
  const Deadline watch(std::numeric_limits<double>::infinity());
  CloudResult best;
  std::vector<StageTime> stages;
  int num_attempts = 0;
  for (const FrontendSetting& setting : list_settings(frontend)) {
    CloudResult result = attempt(source, target, frontend, options, setting);
    add_stages(stages, result.matches.stages);
    add_stages(stages, result.registration.diagnostics.stages);
    ++num_attempts;
    if (num_attempts == 1 || better(result, best)) best = std::move(result);
    if (best.verdict == Verdict::Trusted) break;
  }
  best.num_attempts = num_attempts;
  best.registration.diagnostics.stages = std::move(stages);
  best.registration.diagnostics.total_seconds = watch.elapsed();
  return best;
}

}  // namespace gmcr
