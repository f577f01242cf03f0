#include <fmt/core.h>

#include "arguments/arguments.hpp"
#include "arguments/output_files.hpp"
#include "arguments/validators.hpp"
#include "commands/commands.hpp"
#include "gmcr/io.hpp"
#include "gmcr/version.hpp"
#include "input/read_points.hpp"
#include "output/json.hpp"
#include "output/report.hpp"
#include "output/stopwatch.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kMatchExamples =
    R"(Voxel grid, normals, FPFH and mutual nearest neighbours, without the solver.

Examples:
  gmcr match scan2.ply scan1.ply --voxel 0.05 -o matches.csv
  gmcr match a.bin b.bin --voxel 0.5 --max-ratio 0.9 -o matches.npy --json)";

struct MatchArguments {
  CloudArguments clouds;
  Options options;
  std::string matches;
  OutputArguments output;
};

ExitCode run_match(const MatchArguments& arguments) {
  check_outputs({{arguments.matches, Content::Matches}},
                {arguments.clouds.source, arguments.clouds.target});
  const CloudFiles files(arguments.clouds);
  const ReadPair pair(files.source, files.target, arguments.clouds.reading);
  const Stopwatch stopwatch;
  const CloudMatches matches =
      pair.apply(arguments.clouds.frontend, [&](const auto& source, const auto& target) {
        return match_clouds(source, target, arguments.clouds.frontend, arguments.options);
      });
  const double seconds = stopwatch.seconds();
  write_matches(arguments.matches, matches.source, matches.target);
  if (arguments.output.json) {
    Json json;
    json["status"] = "ok";
    json["num_correspondences"] = matches.source.cols();
    json["num_source_points"] = pair.source().cols();
    json["num_target_points"] = pair.target().cols();
    json["num_source_voxels"] = matches.source_voxels.cols();
    json["num_target_voxels"] = matches.target_voxels.cols();
    json["voxel_size"] = matches.target_voxel_size;
    json["source_voxel_size"] = matches.source_voxel_size;
    json["noise_bound"] = matches.noise_bound;
    json["time_ms"]["total"] = 1000 * seconds;
    for (const StageTime& stage : matches.stages)
      json["time_ms"][stage.name] = 1000 * stage.seconds;
    json["version"] = kVersion;
    print(json);
    return kPoseFound;
  }
  Report report(arguments.output);
  report.line("matches", fmt::format("{} between {} and {} voxels of {:.4g} m",
                                     matches.source.cols(), matches.source_voxels.cols(),
                                     matches.target_voxels.cols(), matches.target_voxel_size));
  report.line("time", duration(seconds));
  report.line("written", arguments.matches);
  const Options& options = arguments.options;
  const std::string scale = options.scale_mode == ScaleMode::Estimated ? " --estimate-scale"
                            : options.scale != 1 ? fmt::format(" --scale {:.6g}", options.scale)
                                                 : "";
  report.line("solve it", fmt::format("gmcr solve {} --noise-bound {:.4g}{}", arguments.matches,
                                      matches.noise_bound, scale));
  report.print();
  return kPoseFound;
}

}  // namespace

void add_match_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<MatchArguments>();
  CLI::App& command = *app.add_subcommand("match", "Putative matches between two clouds");
  arguments->clouds.add_to(
      command, [](const std::string& name) { return name != "max_attempts" && name != "refine"; });
  command.add_option("-o,--output", arguments->matches, "Matches to write, .csv or .npy")
      ->required()
      ->check(not_empty())
      ->type_name("MATCHES");
  add_scale(command, arguments->options);
  add_flags(command, arguments->options,
            [](const std::string& name) { return name == "one_to_one" || name == "num_threads"; });
  command.get_option("--one-to-one")
      ->description("Of the matches that share a target, keep the closest (with --no-mutual)")
      ->group("Matching");
  arguments->output.add_to(command);
  command.footer(kMatchExamples);
  command.callback([arguments, &work] { work = [arguments] { return run_match(*arguments); }; });
}

}  // namespace gmcr::cli
