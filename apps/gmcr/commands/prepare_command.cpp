#include <fmt/core.h>

#include <memory>

#include "arguments/arguments.hpp"
#include "arguments/option_flags.hpp"
#include "arguments/output_files.hpp"
#include "arguments/validators.hpp"
#include "commands/commands.hpp"
#include "gmcr/io.hpp"
#include "gmcr/localisation.hpp"
#include "gmcr/prepared_cloud.hpp"
#include "gmcr/version.hpp"
#include "input/read_points.hpp"
#include "output/json.hpp"
#include "output/report.hpp"
#include "output/stopwatch.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kPrepareExamples =
    R"(Voxels, normals and features of a cloud, for `register` and `match`, which then need not make them.
The file is a PLY with more in it: whatever reads a cloud takes it. Pairs are matched at one voxel
size, the smaller one of the two clouds unless given: prepare the clouds of many pairs with the same.

With --map the cloud is one that `localise` looks for scans in: it is thinned to what that needs.

Examples:
  gmcr prepare map.ply -o map.prepared.ply --voxel 0.3
  gmcr prepare town.ply -o town.map.ply --map
  gmcr register scan.bin map.prepared.ply --voxel 0.3)";

struct PrepareArguments {
  std::string cloud;
  std::string path;
  bool is_map = false;
  FrontendOptions frontend;
  CloudOptions reading;
  Options solver;
  OutputArguments output;
};

/// What was made, and how long that took.
struct Prepared {
  Index num_points = 0;
  double voxel_size = 0;
  double seconds = 0;
};

/// Makes a cloud or a map of the points, and writes it.
template <class Kind, class... Given>
Prepared prepare(const PrepareArguments& arguments, const Points& points, const Given&... given) {
  const Stopwatch stopwatch;
  const Kind prepared(points, arguments.frontend, given..., arguments.solver.num_threads);
  write_text(arguments.path, prepared.to_bytes());
  return {prepared.points().cols(), prepared.voxel_size(), stopwatch.seconds()};
}

ExitCode run_prepare(const PrepareArguments& arguments) {
  check_outputs({{arguments.path, Content::Text}}, {arguments.cloud});
  const InputFile file(arguments.cloud);
  const Points points = read_points(file, arguments.reading);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  // the file does not say
  const Prepared prepared = arguments.is_map ? prepare<PreparedMap>(arguments, points, up)
                                             : prepare<PreparedCloud>(arguments, points);
  if (arguments.output.json) {
    Json json;
    json["status"] = "ok";
    json["num_points"] = prepared.num_points;
    json["voxel_size"] = prepared.voxel_size;
    json["time_ms"]["total"] = 1000 * prepared.seconds;
    json["version"] = kVersion;
    print(json);
    return kPoseFound;
  }
  Report report(arguments.output);
  report.line("prepared",
              fmt::format("{} points, voxels of {:.4g}", prepared.num_points, prepared.voxel_size));
  report.line("time", duration(prepared.seconds));
  report.line("written", arguments.path);
  report.print();
  return kPoseFound;
}

}  // namespace

void add_prepare_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<PrepareArguments>();
  CLI::App& command = *app.add_subcommand("prepare", "A cloud with its features, for many pairs");
  command.add_option("CLOUD", arguments->cloud, "Cloud to prepare, or - for stdin")->required();
  command.add_option("-o,--output", arguments->path, "File to write, .ply")
      ->required()
      ->check(not_empty())
      ->type_name("PREPARED.ply");
  command.add_flag(
      "--map", arguments->is_map,
      "For `localise`: the cloud is a map; of the front end --voxel-size alone counts");
  add_reading(command, arguments->reading);
  add_flags(command, arguments->frontend, [](const std::string& name) {
    return name == "voxel_size" || name == "normal_radius" || name == "feature_radius" ||
           name == "orientation" || name == "source_viewpoint";
  });
  add_flags(command, arguments->solver,
            [](const std::string& name) { return name == "num_threads"; });
  arguments->output.add_to(command);
  command.footer(kPrepareExamples);
  command.callback([arguments, &work] { work = [arguments] { return run_prepare(*arguments); }; });
}

}  // namespace gmcr::cli
