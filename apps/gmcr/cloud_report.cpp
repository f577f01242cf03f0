#include "cloud_report.hpp"

#include <spdlog/spdlog.h>

#include "gmcr/io.hpp"
#include "result_report.hpp"

namespace gmcr::cli {
namespace {

Report::Tone tone_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Trusted:
      return Report::Tone::Good;
    case Verdict::Doubtful:
      return Report::Tone::Fair;
    default:
      return Report::Tone::Bad;
  }
}

/// The options of the solver, where the noise bound may come from the voxel size.
Options with_noise_bound(Options options, const CloudMatches& matches) {
  if (options.noise_mode == NoiseMode::Given) options.noise_bound = matches.noise_bound;
  return options;
}

}  // namespace

Points read_points(const std::filesystem::path& path) {
  Cloud cloud = read_cloud(path);
  if (cloud.num_dropped > 0) {
    spdlog::warn("{}: dropped {} points that are not finite", path.string(), cloud.num_dropped);
  }
  return std::move(cloud.points);
}

Json to_json(const CloudResult& result, const Options& options, const Refinement& refinement,
             double total_seconds) {
  Json json =
      to_json(result.registration, with_noise_bound(options, result.matches), total_seconds);
  json["num_source_points"] = result.num_source_points;
  json["num_target_points"] = result.num_target_points;
  json["num_source_voxels"] = result.matches.source_voxels.cols();
  json["num_target_voxels"] = result.matches.target_voxels.cols();
  json["fitness"] = result.fitness;
  json["target_fitness"] = result.target_fitness;
  json["overlap_rmse"] = result.overlap_rmse;
  json["verdict"] = to_string(result.verdict);
  json["verdict_reason"] = result.verdict_reason;
  json["voxel_size"] = result.matches.target_voxel_size;
  json["source_voxel_size"] = result.matches.source_voxel_size;
  json["num_attempts"] = result.num_attempts;
  json["refinement"] = {
      {"method", refinement.method}, {"applied", refinement.is_applied}, {"note", refinement.note}};
  return json;
}

void add_cloud_result(Report& report, const CloudResult& result, const Options& options,
                      const Refinement& refinement, double total_seconds) {
  const CloudMatches& matches = result.matches;
  report.line("source", fmt::format("{} points, {} voxels of {:.4g}", result.num_source_points,
                                    matches.source_voxels.cols(), matches.source_voxel_size));
  report.line("target", fmt::format("{} points, {} voxels of {:.4g}", result.num_target_points,
                                    matches.target_voxels.cols(), matches.target_voxel_size));
  report.line("matches", options.noise_mode == NoiseMode::Given
                             ? fmt::format("{}, noise bound {:.4g}", matches.source.cols(),
                                           matches.noise_bound)
                             : fmt::format("{}", matches.source.cols()));
  add_result(report, result.registration, options, total_seconds);
  report.line("refinement", refinement.note);
  report.line("fitness", fmt::format("{:.1f} % of the source lies within a voxel of the target",
                                     100 * result.fitness));
  report.line("overlap RMSE", fmt::format("{:.4g}", result.overlap_rmse));
  report.line("verdict", fmt::format("{}: {}", to_string(result.verdict), result.verdict_reason),
              tone_of(result.verdict));
}

}  // namespace gmcr::cli
