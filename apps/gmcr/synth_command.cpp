#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "arguments.hpp"
#include "commands.hpp"
#include "gmcr/io.hpp"
#include "gmcr/synthetic.hpp"
#include "gmcr/version.hpp"
#include "json.hpp"
#include "report.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kExamples =
    R"(Kind random is the random benchmark of the paper, structured the one with clusters of outliers.

Examples:
  gmcr synth -o matches.csv --truth T.txt --num 1000 --outliers 0.95 --seed 7
  gmcr synth -o matches.npy --truth T.txt --kind structured --outliers 0.8 --model bunny.ply
  gmcr solve matches.csv --noise-bound 0.01 -o estimate.txt && gmcr eval estimate.txt T.txt)";

/// What the command line gave; the rest comes from the kind's own defaults.
struct Arguments {
  std::string matches;
  std::string truth;
  std::string inliers;
  std::string model;
  SyntheticKind kind = SyntheticKind::Ball;
  std::optional<Index> num_correspondences;
  std::optional<double> outlier_rate, noise_extent, noise_bound, max_translation;
  std::vector<double> scale_range;
  std::uint64_t seed = SyntheticOptions{}.seed;
  bool json = false;
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

SyntheticOptions resolve(const Arguments& arguments) {
  SyntheticOptions options = preset(arguments.kind);
  options.seed = arguments.seed;
  options.num_correspondences = arguments.num_correspondences.value_or(options.num_correspondences);
  options.outlier_rate = arguments.outlier_rate.value_or(options.outlier_rate);
  options.noise_extent = arguments.noise_extent.value_or(options.noise_extent);
  // a bound that follows the noise keeps "--noise 0.05" alone meaningful
  if (arguments.noise_extent) {
    options.noise_bound = std::max(options.noise_bound, *arguments.noise_extent);
  }
  options.noise_bound = arguments.noise_bound.value_or(options.noise_bound);
  options.max_translation = arguments.max_translation.value_or(options.max_translation);
  options.num_cloud_points = std::max(options.num_cloud_points, options.num_correspondences);
  if (!arguments.scale_range.empty()) {
    options.scale_range = {arguments.scale_range[0], arguments.scale_range[1]};
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

ExitCode run(const Arguments& arguments) {
  const SyntheticOptions options = resolve(arguments);
  const SyntheticProblem problem =
      arguments.model.empty() ? make_synthetic(options)
                              : make_synthetic(options, read_cloud(arguments.model).points);
  const std::vector<Index> inliers = inliers_of(problem);
  write_matches(arguments.matches, problem.source, problem.target);
  if (!arguments.truth.empty()) write_transform(arguments.truth, problem.target_from_source);
  if (!arguments.inliers.empty()) write_indices(arguments.inliers, inliers);
  if (arguments.json) {
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
  Report report;
  report.line("written", arguments.matches);
  report.line("inliers", share(static_cast<Index>(inliers.size()), problem.source.cols()));
  report.line("noise bound", fmt::format("{:.6g}", problem.noise_bound));
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
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("synth", "Reproducible problem with its truth");
  command.add_option("-o,--output", arguments->matches, "Matches to write, .csv or .npy")
      ->required()
      ->type_name("MATCHES");
  command.add_option("--truth", arguments->truth, "True transform to write")->type_name("T.txt");
  command.add_option("--inliers", arguments->inliers, "True inlier indices to write")
      ->type_name("FILE");
  command.add_option("--model", arguments->model, "Cloud to take points from")->type_name("CLOUD");
  add_choice<SyntheticKind>(command, "--kind", arguments->kind,
                            {{"ball", SyntheticKind::Ball},
                             {"random", SyntheticKind::Random},
                             {"structured", SyntheticKind::Structured}},
                            "Protocol");
  command.add_option("--num", arguments->num_correspondences, "Matches");
  command.add_option("--outliers", arguments->outlier_rate, "Share of wrong matches, 0 to 1");
  command.add_option("--noise", arguments->noise_extent, "Extent of the noise, metres");
  command.add_option("--noise-bound", arguments->noise_bound, "Bound of an inlier's error, metres");
  command.add_option("--max-translation", arguments->max_translation, "Largest shift an axis");
  command.add_option("--scale-range", arguments->scale_range, "Range of the true scale")
      ->expected(2)
      ->type_name("MIN MAX");
  command.add_option("--seed", arguments->seed, "Same seed, same problem")->capture_default_str();
  command.add_flag("--json", arguments->json, "Print one JSON object");
  command.footer(kExamples);
  command.callback([arguments, &work] { work = [arguments] { return run(*arguments); }; });
}

}  // namespace gmcr::cli
