#include <fmt/core.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/isa.hpp"
#include "gmcr/options.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/version.hpp"
#include "json.hpp"
#include "report.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kExamples = R"(Examples:
  gmcr info
  gmcr info --json)";

Json defaults() {
  const Options options;
  const FrontendOptions frontend;
  Json json;
  json["threshold"] = options.threshold;
  json["scale"] = options.scale;
  json["method"] = options.method == Method::Gmcr ? "gmcr" : "paper";
  json["evidence"] = options.evidence == Evidence::Distinct ? "distinct" : "count";
  json["hypotheses"] = options.num_hypotheses;
  json["time_limit"] = options.budget.time;
  json["memory_limit"] = options.budget.memory;
  json["normal_radius"] = frontend.normal_radius;
  json["feature_radius"] = frontend.feature_radius;
  json["noise_bound_voxels"] = frontend.noise_bound_voxels;
  json["max_ratio"] = frontend.max_ratio;
  json["attempts"] = frontend.max_attempts;
  const InstanceOptions instances;
  json["min_instance_inliers"] = instances.min_inliers;
  json["min_instance_share"] = instances.min_share;
  return json;
}

/// Threads that the solver uses where it may use all; it says so of no matches at all too.
int num_threads() {
  Options options;
  options.noise_bound = 1;
  const Points none(3, 0);
  return register_correspondences(none, none, options).diagnostics.num_threads;
}

ExitCode run(bool as_json) {
  Json json;
  json["version"] = kVersion;
  json["isa"] = active_isa();
  json["supported_isas"] = supported_isas();
  json["threads"] = num_threads();
  json["build_type"] = GMCR_BUILD_TYPE;
  json["compiler"] = __VERSION__;
  json["defaults"] = defaults();
  if (as_json) {
    print(json);
    return kPoseFound;
  }
  Report report;
  report.line("gmcr", kVersion);
  report.line("isa", fmt::format("{}, of {}", active_isa(), fmt::join(supported_isas(), " ")));
  report.line("threads", json["threads"].dump());
  report.line("build", fmt::format("{}, {}", GMCR_BUILD_TYPE, __VERSION__));
  for (const auto& [name, value] : json["defaults"].items()) {
    report.line(name == "threshold" ? "defaults" : "",
                fmt::format("{:<20} {}", name,
                            value.is_string() ? value.get<std::string>() : value.dump()));
  }
  report.print();
  return kPoseFound;
}

}  // namespace

void add_info_command(CLI::App& app, Work& work) {
  const auto as_json = std::make_shared<bool>(false);
  CLI::App& command = *app.add_subcommand("info", "Version, instruction set, threads, defaults");
  command.add_flag("--json", *as_json, "Print one JSON object");
  command.footer(kExamples);
  command.callback([as_json, &work] { work = [as_json] { return run(*as_json); }; });
}

}  // namespace gmcr::cli
