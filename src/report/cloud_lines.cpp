#include <fmt/format.h>

#include "report/lines.hpp"

namespace gmcr {
namespace report {
namespace {

std::string cloud_text(Index num_points, const Points& voxels, double voxel_size) {
  return fmt::format("{} points, {} voxels of {:.4g} m", num_points, voxels.cols(), voxel_size);
}

void add_clouds(Lines& lines, const CloudResult& result, Detail detail, const Options* options) {
  const CloudMatches& matches = result.matches;
  if (detail == Detail::Full) {
    lines.add("source", cloud_text(result.num_source_points, matches.source_voxels,
                                   matches.source_voxel_size));
    lines.add("target", cloud_text(result.num_target_points, matches.target_voxels,
                                   matches.target_voxel_size));
  }
  const bool is_noise_given = options ? options->noise_mode == NoiseMode::Given
                                      : !result.registration.noise_estimate.has_value();
  lines.add("matches", is_noise_given ? fmt::format("{}, noise bound {:.4g} m",
                                                    matches.source.cols(), matches.noise_bound)
                                      : fmt::format("{}", matches.source.cols()));
}

}  // namespace
}  // namespace report

std::vector<ReportLine> report_lines(const CloudResult& result, Detail detail,
                                     const ReportContext& context) {
  report::Lines lines;
  report::add_clouds(lines, result, detail, context.options);
  report::add_result(lines, result.registration, detail, context);
  if (detail == Detail::Full) lines.add("refinement", result.refinement.note);
  lines.add("fitness", fmt::format("{:.1f} % of the source lies within a voxel of the target",
                                   100 * result.fitness));
  if (detail == Detail::Full)
    lines.add("overlap RMSE", fmt::format("{:.4g} m", result.overlap_rmse));
  for (const std::string& note : result.notes) lines.add("note", note, Tone::Fair);
  report::add_verdict(lines, result.verdict, result.verdict_reason);
  return std::move(lines).take();
}

}  // namespace gmcr
