#include "json.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "gmcr/io.hpp"
#include "gmcr/isa.hpp"
#include "gmcr/version.hpp"

namespace gmcr::cli {
namespace {

constexpr int kIndent = 2;

Json stage_times(const Result& result, double total_seconds) {
  Json times;
  times["total"] = 1000 * total_seconds;
  for (const StageTime& stage : result.diagnostics.stages) times[stage.name] = 1000 * stage.seconds;
  return times;
}

}  // namespace

Json rows_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json to_json(const Result& result, double total_seconds) {
  const Similarity& pose = result.target_from_source;
  const Diagnostics& diagnostics = result.diagnostics;
  Json json;
  json["status"] = to_string(result.status);
  json["status_reason"] = result.status_reason;
  json["scale"] = pose.scale;
  json["rotation"] = rows_of(pose.rotation);
  json["translation"] =
      Json::array({pose.translation.x(), pose.translation.y(), pose.translation.z()});
  json["target_from_source"] = rows_of(pose.matrix());
  json["num_correspondences"] = diagnostics.num_correspondences;
  json["num_used"] = diagnostics.num_used;
  json["num_inliers"] = result.inliers.size();
  json["inliers"] = result.inliers;
  json["evidence"] = result.evidence;
  json["certificate"] = {{"lower", result.certificate.lower},
                         {"upper", result.certificate.upper},
                         {"certified", result.certificate.certified}};
  json["time_ms"] = stage_times(result, total_seconds);
  json["scale_range"] = Json::array({diagnostics.scale_range.min, diagnostics.scale_range.max});
  json["num_candidates"] = diagnostics.num_candidates;
  json["num_scale_ranges"] = diagnostics.num_scale_ranges;
  json["num_clique_nodes"] = diagnostics.num_clique_nodes;
  json["limits_hit"] = diagnostics.limits_hit;
  json["threads"] = diagnostics.num_threads;
  json["isa"] = active_isa();
  json["version"] = kVersion;
  return json;
}

void print(const Json& json) {
  fmt::print("{}\n", json.dump(kIndent));
  if (std::fflush(stdout) != 0) throw IoError("standard output", 0, std::strerror(errno));
}

void write(const std::filesystem::path& path, const Json& json) {
  std::ofstream file(path, std::ios::binary);
  file << json.dump(kIndent) << '\n';
  file.close();
  if (!file) throw IoError(path, 0, std::strerror(errno));
}

}  // namespace gmcr::cli
