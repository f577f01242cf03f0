#include <fmt/core.h>

#include <optional>

#include "commands/commands.hpp"
#include "gmcr/io.hpp"
#include "gmcr/metrics.hpp"
#include "gmcr/version.hpp"
#include "input/input_file.hpp"
#include "input/read_estimate.hpp"
#include "input/read_pose.hpp"
#include "output/json.hpp"
#include "output/report.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kEvalExamples =
    R"(RESULT and TRUTH are each a 4 x 4 text file (-o) or the JSON of solve or register (--json), or one of
them is - for stdin.

Examples:
  gmcr eval T.txt T_truth.txt
  gmcr solve matches.csv --noise-bound 0.01 --json | gmcr eval - T_truth.txt
  gmcr eval result.json T_truth.txt --points source.ply --json)";

struct EvalArguments {
  std::string result;
  std::string truth;
  std::string points;
  OutputArguments output;
};

Json errors_of(const Similarity& estimate, const Similarity& truth,
               const std::optional<Cloud>& cloud) {
  Json json;
  json["rotation_error_deg"] = rotation_error_deg(estimate.rotation, truth.rotation);
  json["translation_error"] = translation_error(estimate.translation, truth.translation);
  json["scale_error"] = scale_error(estimate.scale, truth.scale);
  if (cloud) json["mean_point_error"] = mean_point_error(estimate, truth, cloud->points);
  return json;
}

void print_report(Report report, const std::string& status, const Json& errors) {
  if (status != "ok") report.line("status", status, Report::Tone::Bad);
  const auto number = [&](const char* name) { return errors[name].get<double>(); };
  report.line("rotation", fmt::format("{:.6g} deg", number("rotation_error_deg")));
  report.line("translation", fmt::format("{:.6g} m", number("translation_error")));
  report.line("scale", fmt::format("{:.4g} %", 100 * number("scale_error")));
  if (errors.contains("mean_point_error")) {
    report.line("mean point", fmt::format("{:.6g} m", number("mean_point_error")));
  }
  report.print();
}

ExitCode run_eval(const EvalArguments& arguments) {
  const InputFile file(arguments.result);
  const Estimate estimate = file.read([](const auto& path) { return read_estimate(path); });
  const Similarity truth = read_pose(arguments.truth);
  std::optional<Cloud> cloud;
  if (!arguments.points.empty()) cloud = read_cloud(arguments.points);
  const Json errors = errors_of(estimate.pose, truth, cloud);
  if (arguments.output.json) {
    Json json;
    json["status"] = estimate.status;
    json.update(errors);
    json["version"] = kVersion;
    print(json);
  } else {
    print_report(Report(arguments.output), estimate.status, errors);
  }
  return estimate.status == "ok" ? kPoseFound : kNoPose;
}

}  // namespace

void add_eval_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<EvalArguments>();
  CLI::App& command = *app.add_subcommand("eval", "Errors of a result against the truth");
  command.add_option("RESULT", arguments->result, "Estimate, T.txt or result.json")->required();
  command.add_option("TRUTH", arguments->truth, "Truth, T.txt or result.json")->required();
  command
      .add_option("--points", arguments->points, "Source cloud, for the mean point error (metres)")
      ->type_name("CLOUD");
  arguments->output.add_to(command);
  command.footer(kEvalExamples);
  command.callback([arguments, &work] { work = [arguments] { return run_eval(*arguments); }; });
}

}  // namespace gmcr::cli
