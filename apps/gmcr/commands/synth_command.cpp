#include <fmt/core.h>

#include <algorithm>

#include "arguments/option_flags.hpp"
#include "arguments/output_files.hpp"
#include "arguments/validators.hpp"
#include "commands/commands.hpp"
#include "gmcr/io.hpp"
#include "gmcr/synthetic.hpp"
#include "gmcr/version.hpp"
#include "input/read_points.hpp"
#include "options/table.hpp"
#include "output/json.hpp"
#include "output/report.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kSynthExamples =
    R"(Kind random is the random benchmark of the paper, structured the one with clusters of outliers.

Examples:
  gmcr synth -o matches.csv --truth T.txt --num 1000 --outliers 0.95 --seed 7
  gmcr synth -o matches.npy --truth T.txt --kind structured --outliers 0.8 --model bunny.ply
  gmcr solve matches.csv --noise-bound 0.01 -o estimate.txt && gmcr eval estimate.txt T.txt)";

struct SynthArguments {
  std::string matches;
  std::string truth;
  std::string inliers;
  std::string model;
  SyntheticOptions options;
  OutputArguments output;
};

SyntheticOptions preset(SyntheticKind kind) {
  switch (kind) {
    case SyntheticKind::Random:
      return paper_random_options();
    case SyntheticKind::Structured:
      return paper_structured_options();
    default:
      return {};
  }
}

/// What the command line gave; the rest is as the kind has it.
SyntheticOptions resolve(const CLI::App& command, const SyntheticOptions& given) {
  SyntheticOptions options = preset(given.kind);
  options::for_each_option<SyntheticOptions>([&](const auto& option) {
    if (command.count(flag_of(option.about.name)) == 0) return;
    std::invoke(option.place, options) = std::invoke(option.place, given);
  });
  // a bound that follows the noise keeps "--noise 0.05" alone meaningful
  if (command.count("--noise-extent") > 0 && command.count("--noise-bound") == 0) {
    options.noise_bound = std::max(options.noise_bound, options.noise_extent);
  }
  if (command.count("--num-cloud-points") == 0) {
    options.num_cloud_points = std::max(options.num_cloud_points, options.num_correspondences);
  }
  return options;
}

std::vector<Index> inliers_of(const SyntheticProblem& problem) {
  std::vector<Index> inliers;
  for (std::size_t i = 0; i < problem.is_inlier.size(); ++i) {
    if (problem.is_inlier[i]) inliers.push_back(static_cast<Index>(i));
  }
  return inliers;
}

ExitCode run_synth(const SynthArguments& arguments) {
  const SyntheticOptions& options = arguments.options;
  check_outputs({{arguments.matches, Content::Matches},
                 {arguments.truth, Content::Transform},
                 {arguments.inliers, Content::Text}},
                {arguments.model});
  const SyntheticProblem problem =
      arguments.model.empty()
          ? make_synthetic(options)
          : make_synthetic(options, read_points(InputFile(arguments.model), {.mesh_points = 0}));
  const std::vector<Index> inliers = inliers_of(problem);
  write_matches(arguments.matches, problem.source, problem.target);
  if (!arguments.truth.empty()) write_transform(arguments.truth, problem.target_from_source);
  if (!arguments.inliers.empty()) write_indices(arguments.inliers, inliers);
  if (arguments.output.json) {
    Json json;
    json["status"] = "ok";
    json["num_correspondences"] = problem.source.cols();
    json["num_inliers"] = inliers.size();
    json["inliers"] = inliers;
    json["noise_bound"] = problem.noise_bound;
    json["seed"] = options.seed;
    json["target_from_source"] = rows_of(problem.target_from_source.matrix());
    json["version"] = kVersion;
    print(json);
    return kPoseFound;
  }
  Report report(arguments.output);
  report.line("written", arguments.matches);
  const double percent = 100.0 * static_cast<double>(inliers.size()) /
                         static_cast<double>(std::max<Index>(1, problem.source.cols()));
  report.line("inliers",
              fmt::format("{} of {} ({:.1f} %)", inliers.size(), problem.source.cols(), percent));
  report.line("noise bound", fmt::format("{:.6g} m", problem.noise_bound));
  report.line(
      "solve it",
      fmt::format(
          "gmcr solve {} --noise-bound {:.6g}{}", arguments.matches, problem.noise_bound,
          options.scale_range.min == 1 && options.scale_range.max == 1 ? "" : " --estimate-scale"));
  report.print();
  return kPoseFound;
}

}  // namespace

void add_synth_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<SynthArguments>();
  CLI::App& command = *app.add_subcommand("synth", "Reproducible problem with its truth");
  command.add_option("-o,--output", arguments->matches, "Matches to write, .csv or .npy")
      ->required()
      ->check(not_empty())
      ->type_name("MATCHES");
  command.add_option("--truth", arguments->truth, "True transform to write")
      ->check(not_empty())
      ->type_name("T.txt");
  command.add_option("--inliers", arguments->inliers, "True inlier indices to write")
      ->check(not_empty())
      ->type_name("FILE");
  command.add_option("--model", arguments->model, "Cloud to take points from, or - for stdin")
      ->type_name("CLOUD");
  add_flags(command, arguments->options);
  for (CLI::Option* option : command.get_options()) {
    if (option->get_name() != "--kind") option->default_str("");  // each kind has its own
  }
  arguments->output.add_to(command);
  command.footer(kSynthExamples);
  command.callback([arguments, &command, &work] {
    arguments->options = resolve(command, arguments->options);
    work = [arguments] { return run_synth(*arguments); };
  });
}

}  // namespace gmcr::cli
