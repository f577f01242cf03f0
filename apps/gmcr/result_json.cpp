#include "result_json.hpp"

#include <optional>

#include "gmcr/isa.hpp"
#include "gmcr/version.hpp"

namespace gmcr::cli {
namespace {

template <typename Vector>
Json values_of(const Vector& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(value);
  return json;
}

void set_pose(Json& json, const Similarity& pose) {
  json["scale"] = pose.scale;
  json["rotation"] = rows_of(pose.rotation);
  json["translation"] = values_of(pose.translation);
  json["target_from_source"] = rows_of(pose.matrix());
}

void set_consensus(Json& json, const std::vector<Index>& inliers, double evidence) {
  json["num_inliers"] = inliers.size();
  json["inliers"] = inliers;
  json["evidence"] = evidence;
}

Json to_json(const Certificate& certificate) {
  return {{"lower", certificate.lower},
          {"upper", certificate.upper},
          {"certified", certificate.certified},
          {"evidence",
           {{"lower", certificate.evidence.lower},
            {"upper", certificate.evidence.upper},
            {"certified", certificate.evidence.certified}}}};
}

Json to_json(const ScaleRange& range) { return Json::array({range.min, range.max}); }

Json to_json(const std::optional<Covariance>& covariance) {
  if (!covariance) return nullptr;
  return {{"matrix", rows_of(covariance->matrix)},
          {"eigenvalues", values_of(covariance->eigenvalues)}};
}

Json to_json(const Alternative& alternative) {
  Json json;
  set_pose(json, alternative.target_from_source);
  set_consensus(json, alternative.inliers, alternative.evidence);
  return json;
}

/// The noise bound in use, where there is one for all.
void set_noise(Json& json, const Result& result, const Options& options) {
  if (const auto& estimate = result.noise_estimate) {
    json["noise_bound"] = estimate->noise_bound;
    json["noise_estimate"] = {{"noise_bound", estimate->noise_bound},
                              {"stable_min", estimate->stable_min},
                              {"stable_max", estimate->stable_max},
                              {"log10_false_alarms", estimate->log10_false_alarms}};
  } else if (options.noise_mode == NoiseMode::Given && options.noise_bounds.empty()) {
    json["noise_bound"] = options.noise_bound;
  }
}

void set_alternatives(Json& json, const Result& result) {
  Json alternatives = Json::array();
  for (const Alternative& alternative : result.alternatives) {
    alternatives.push_back(to_json(alternative));
  }
  json["alternatives"] = std::move(alternatives);
  json["runner_up_ratio"] = result.runner_up_ratio();
}

Json stage_times(const Result& result, double total_seconds) {
  Json times;
  times["total"] = 1000 * total_seconds;
  for (const StageTime& stage : result.diagnostics.stages) times[stage.name] = 1000 * stage.seconds;
  return times;
}

/// What differs from instance to instance.
Json instance_fields(const Result& result) {
  Json json;
  json["status"] = to_string(result.status);
  json["status_reason"] = result.status_reason;
  set_pose(json, result.target_from_source);
  json["num_correspondences"] = result.diagnostics.num_correspondences;
  json["num_used"] = result.diagnostics.num_used;
  set_consensus(json, result.inliers, result.evidence);
  json["certificate"] = to_json(result.certificate);
  json["consistent_scales"] = to_json(result.consistent_scales);
  json["covariance"] = to_json(result.covariance);
  json["limits_hit"] = result.diagnostics.limits_hit;
  return json;
}

}  // namespace

Json to_json(const Result& result, const Options& options, double total_seconds) {
  const Diagnostics& diagnostics = result.diagnostics;
  Json json = instance_fields(result);
  set_noise(json, result, options);
  if (options.num_hypotheses > 1) set_alternatives(json, result);
  json["time_ms"] = stage_times(result, total_seconds);
  json["scale_range"] = to_json(diagnostics.scale_range);
  json["num_candidates"] = diagnostics.num_candidates;
  json["num_scale_ranges"] = diagnostics.num_scale_ranges;
  json["num_clique_nodes"] = diagnostics.num_clique_nodes;
  json["threads"] = diagnostics.num_threads;
  json["isa"] = active_isa();
  json["version"] = kVersion;
  return json;
}

Json to_json(const std::vector<Result>& instances, const Options& options, double total_seconds) {
  Json json = to_json(instances.front(), options, total_seconds);
  Json& times = json["time_ms"];
  Json entries = Json::array();
  for (const Result& instance : instances) {
    Json entry = instance_fields(instance);
    set_noise(entry, instance, options);
    if (options.num_hypotheses > 1) set_alternatives(entry, instance);
    entries.push_back(std::move(entry));
    if (&instance == &instances.front()) continue;
    for (const StageTime& stage : instance.diagnostics.stages) {
      times[stage.name] = times.value(stage.name, 0.0) + 1000 * stage.seconds;
    }
  }
  json["instances"] = std::move(entries);
  return json;
}

}  // namespace gmcr::cli
