#include "options/json.hpp"

#include <nlohmann/json.hpp>
#include <optional>

#include "gmcr/isa.hpp"
#include "gmcr/report.hpp"
#include "gmcr/version.hpp"

namespace gmcr {
namespace report {
namespace {

/// Fields in the order in which they were set. A number that is not finite is written as null.
using Json = nlohmann::ordered_json;

template <typename Vector>
Json values_of(const Vector& values) {
  Json json = Json::array();
  for (const double value : values) json.push_back(value);
  return json;
}

template <typename Matrix>
Json rows_of(const Matrix& matrix) {
  Json rows = Json::array();
  for (Index i = 0; i < matrix.rows(); ++i) rows.push_back(values_of(matrix.row(i)));
  return rows;
}

Json pair_of(const ScaleRange& range) { return Json::array({range.min, range.max}); }

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

Json fields_of(const Certificate& certificate) {
  return {{"lower", certificate.lower},
          {"upper", certificate.upper},
          {"certified", certificate.certified},
          {"evidence",
           {{"lower", certificate.evidence.lower},
            {"upper", certificate.evidence.upper},
            {"certified", certificate.evidence.certified}}},
          {"target_from_source", rows_of(certificate.target_from_source.matrix())},
          {"inliers", certificate.inliers}};
}

Json fields_of(const std::optional<Covariance>& covariance) {
  if (!covariance) return nullptr;
  return {{"matrix", rows_of(covariance->matrix)},
          {"eigenvalues", values_of(covariance->eigenvalues)}};
}

void set_limits(Json& json, const std::vector<LimitHit>& limits_hit) {
  Json sentences = Json::array(), codes = Json::array();
  for (const LimitHit& hit : limits_hit) {
    sentences.push_back(hit.sentence);
    codes.push_back(to_string(hit.limit));
  }
  json["limits_hit"] = std::move(sentences);
  json["limit_codes"] = std::move(codes);
}

/// The noise bound in use, where there is one for all.
/// @param given  the bound, where it was not chosen from the data and is known.
void set_noise(Json& json, const Result& result, const std::optional<double>& given) {
  if (const auto& estimate = result.noise_estimate) {
    json["noise_bound"] = estimate->noise_bound;
    json["noise_estimate"] = {{"noise_bound", estimate->noise_bound},
                              {"stable_min", estimate->stable_min},
                              {"stable_max", estimate->stable_max},
                              {"log10_false_alarms", estimate->log10_false_alarms}};
  } else if (given) {
    json["noise_bound"] = *given;
  }
}

/// Where several hypotheses were asked for, or found.
void set_alternatives(Json& json, const Result& result, const Options* options) {
  if (result.alternatives.empty() && (!options || options->num_hypotheses < 2)) return;
  Json alternatives = Json::array();
  for (const Alternative& alternative : result.alternatives) {
    Json& entry = alternatives.emplace_back(Json::object());
    set_pose(entry, alternative.target_from_source);
    set_consensus(entry, alternative.inliers, alternative.evidence);
  }
  json["alternatives"] = std::move(alternatives);
  json["runner_up_ratio"] = result.runner_up_ratio();
}

/// What differs from instance to instance.
Json instance_fields(const Result& result, const Options* options,
                     const std::optional<double>& noise_bound) {
  Json json;
  json["status"] = to_string(result.status);
  json["status_reason"] = result.status_reason;
  set_pose(json, result.target_from_source);
  json["num_correspondences"] = result.diagnostics.num_correspondences;
  json["num_used"] = result.diagnostics.num_used;
  set_consensus(json, result.inliers, result.evidence);
  json["verdict"] = to_string(result.verdict);
  json["verdict_reason"] = result.verdict_reason;
  json["log10_false_alarms"] = result.log10_false_alarms;
  json["certificate"] = fields_of(result.certificate);
  json["consistent_scales"] = pair_of(result.consistent_scales);
  json["covariance"] = fields_of(result.covariance);
  set_limits(json, result.diagnostics.limits_hit);
  set_noise(json, result, noise_bound);
  set_alternatives(json, result, options);
  return json;
}

Json stage_times(const Diagnostics& diagnostics, const ReportContext& context) {
  Json times;
  times["total"] = 1000 * context.total_seconds.value_or(diagnostics.total_seconds);
  for (const StageTime& stage : diagnostics.stages) times[stage.name] = 1000 * stage.seconds;
  return times;
}

Json result_fields(const Result& result, const ReportContext& context,
                   const std::optional<double>& noise_bound) {
  const Diagnostics& diagnostics = result.diagnostics;
  Json json = instance_fields(result, context.options, noise_bound);
  json["time_ms"] = stage_times(diagnostics, context);
  json["scale_range"] = pair_of(diagnostics.scale_range);
  json["num_candidates"] = diagnostics.num_candidates;
  json["num_scale_ranges"] = diagnostics.num_scale_ranges;
  json["num_clique_nodes"] = diagnostics.num_clique_nodes;
  json["threads"] = diagnostics.num_threads;
  json["isa"] = active_isa();
  json["version"] = kVersion;
  return json;
}

/// The bound of all matches, where it was given.
std::optional<double> noise_bound_of(const Options* options) {
  const bool is_one = options && options->noise_mode == NoiseMode::Given &&
                      options->noise_bounds.empty() && options->noise_bound > 0;
  return is_one ? std::optional(options->noise_bound) : std::nullopt;
}

/// The same for clouds, where it may come from the voxel size.
std::optional<double> noise_bound_of(const CloudMatches& matches, const Options* options) {
  const bool is_given = options ? options->noise_mode == NoiseMode::Given : matches.noise_bound > 0;
  return is_given ? std::optional(matches.noise_bound) : std::nullopt;
}

/// The options, the words, and all of it as text.
std::string finish(Json json, const std::vector<ReportLine>& lines, const ReportContext& context,
                   int indent) {
  if (context.options) json["options"] = options::to_json<Json>(*context.options);
  Json words = Json::array();
  for (const ReportLine& line : lines) {
    words.push_back({{"label", line.label}, {"text", line.text}, {"tone", to_string(line.tone)}});
  }
  json["report"] = std::move(words);
  // texts of the outside world, such as the message of an error, may be no UTF-8
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json fields_of(const SurfaceFit& fit) {
  Json weak = Json::array();
  for (const WeakDirection& direction : fit.weak_directions) {
    const bool is_turn = !direction.turn.isZero(0);
    weak.push_back({{"kind", is_turn ? "turn" : "shift"},
                    {"direction", values_of(is_turn ? direction.turn : direction.shift)},
                    {"stiffness", direction.stiffness}});
  }
  return {{"source_share", fit.source_share},
          {"target_share", fit.target_share},
          {"agreement", fit.agreement},
          {"contradicted", fit.contradicted},
          {"noise", fit.noise},
          {"weak_directions", std::move(weak)}};
}

Json fields_of(const std::vector<RivalPose>& rivals) {
  Json entries = Json::array();
  for (const RivalPose& rival : rivals) {
    Json& entry = entries.emplace_back(Json::object());
    set_pose(entry, rival.target_from_source);
    entry["overlap"] = rival.overlap;
    entry["is_symmetry"] = rival.is_symmetry;
  }
  return entries;
}

}  // namespace
}  // namespace report

std::string to_json(const Result& result, const ReportContext& context, int indent) {
  return report::finish(
      report::result_fields(result, context, report::noise_bound_of(context.options)),
      report_lines(result, Detail::Full, context), context, indent);
}

std::string to_json(const std::vector<Result>& instances, const ReportContext& context,
                    int indent) {
  const std::vector<ReportLine> lines = report_lines(instances, Detail::Full, context);
  const std::optional<double> noise_bound = report::noise_bound_of(context.options);
  report::Json json = report::result_fields(instances.front(), context, noise_bound);
  report::Json& times = json["time_ms"];
  report::Json entries = report::Json::array();
  for (const Result& instance : instances) {
    entries.push_back(report::instance_fields(instance, context.options, noise_bound));
    if (&instance == &instances.front()) continue;
    for (const StageTime& stage : instance.diagnostics.stages) {
      times[stage.name] = times.value(stage.name, 0.0) + 1000 * stage.seconds;
    }
  }
  json["instances"] = std::move(entries);
  return report::finish(std::move(json), lines, context, indent);
}

namespace report {
namespace {

/// All of a result of two clouds but the options and the words.
Json cloud_fields(const CloudResult& result, const ReportContext& context) {
  const CloudMatches& matches = result.matches;
  Json json = result_fields(result.registration, context, noise_bound_of(matches, context.options));
  json["num_source_points"] = result.num_source_points;
  json["num_target_points"] = result.num_target_points;
  json["num_source_voxels"] = matches.source_voxels.cols();
  json["num_target_voxels"] = matches.target_voxels.cols();
  json["fitness"] = result.fitness;
  json["target_fitness"] = result.target_fitness;
  json["overlap_rmse"] = result.overlap_rmse;
  json["verdict"] = to_string(result.verdict);
  json["verdict_reason"] = result.verdict_reason;
  json["voxel_size"] = matches.target_voxel_size;
  json["source_voxel_size"] = matches.source_voxel_size;
  json["num_attempts"] = result.num_attempts;
  json["refinement"] = {{"method", result.refinement.method},
                        {"applied", result.refinement.is_applied},
                        {"note", result.refinement.note},
                        {"noise", result.refinement.noise}};
  json["surfaces"] = fields_of(result.surfaces);
  json["ambiguous"] = !result.rivals.empty();
  json["rivals"] = fields_of(result.rivals);
  json["notes"] = result.notes;
  return json;
}

Json instance_fields(const CloudResult& instance, const Options* options) {
  Json json =
      instance_fields(instance.registration, options, noise_bound_of(instance.matches, options));
  json["verdict"] = to_string(instance.verdict);
  json["verdict_reason"] = instance.verdict_reason;
  return json;
}

/// Adds the times of a further instance.
void add_times(Json& times, const std::vector<StageTime>& stages) {
  for (const StageTime& stage : stages) {
    times[stage.name] = times.value(stage.name, 0.0) + 1000 * stage.seconds;
  }
}

}  // namespace
}  // namespace report

std::string to_json(const CloudResult& result, const ReportContext& context, int indent) {
  return report::finish(report::cloud_fields(result, context),
                        report_lines(result, Detail::Full, context), context, indent);
}

std::string to_json(const std::vector<CloudResult>& instances, const ReportContext& context,
                    int indent) {
  const std::vector<ReportLine> lines = report_lines(instances, Detail::Full, context);
  report::Json json = report::cloud_fields(instances.front(), context);
  report::Json entries = report::Json::array();
  for (const CloudResult& instance : instances) {
    entries.push_back(report::instance_fields(instance, context.options));
    if (&instance == &instances.front()) continue;
    report::add_times(json["time_ms"], instance.registration.diagnostics.stages);
  }
  json["instances"] = std::move(entries);
  return report::finish(std::move(json), lines, context, indent);
}

}  // namespace gmcr
