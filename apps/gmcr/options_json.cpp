#include "options_json.hpp"

namespace gmcr::cli {
namespace {

Json vector_of(const Eigen::Vector3d& values) {
  return Json::array({values.x(), values.y(), values.z()});
}

void set_priors(Json& json, const Priors& priors) {
  if (const auto& gravity = priors.gravity) {
    json["gravity.source"] = vector_of(gravity->source);
    json["gravity.target"] = vector_of(gravity->target);
    json["gravity.max_tilt"] = gravity->max_tilt;
  }
  if (const auto& pose = priors.initial_pose) {
    const Similarity& transform = pose->target_from_source;
    json["initial_pose.rotation"] = rows_of(transform.rotation);
    json["initial_pose.translation"] = vector_of(transform.translation);
    json["initial_pose.max_rotation"] = pose->max_rotation;
    json["initial_pose.max_translation"] = pose->max_translation;
  }
  json["max_translation"] = priors.max_translation;
}

}  // namespace

Json to_json(const Options& options) {
  Json json;
  json["noise_mode"] = options.noise_mode == NoiseMode::Given ? "given" : "estimated";
  if (!options.noise_bounds.empty()) {
    json["noise_bounds"] = options.noise_bounds;
  } else if (options.noise_mode == NoiseMode::Given) {
    json["noise_bound"] = options.noise_bound;
  }
  json["threshold"] = options.threshold;
  json["scale_mode"] = options.scale_mode == ScaleMode::Known ? "known" : "estimated";
  if (options.scale_mode == ScaleMode::Known) {
    json["scale"] = options.scale;
  } else if (options.scale_range) {
    json["scale_range"] = Json::array({options.scale_range->min, options.scale_range->max});
  }
  json["method"] = options.method == Method::Gmcr ? "gmcr" : "paper";
  json["evidence"] = options.evidence == Evidence::Distinct ? "distinct" : "count";
  set_priors(json, options.priors);
  json["one_to_one"] = options.one_to_one;
  json["least_squares"] = options.least_squares;
  json["num_hypotheses"] = options.num_hypotheses;
  json["certify"] = options.certify;
  json["num_threads"] = options.num_threads;
  json["time_limit"] = options.budget.time;
  json["memory_limit"] = options.budget.memory;
  return json;
}

}  // namespace gmcr::cli
