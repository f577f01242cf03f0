#include <fmt/core.h>

#include <memory>

#include "arguments/arguments.hpp"
#include "arguments/output_files.hpp"
#include "arguments/validators.hpp"
#include "commands/commands.hpp"
#include "gmcr/io.hpp"
#include "input/read_points.hpp"
#include "output/json_text.hpp"
#include "output/progress.hpp"
#include "output/report.hpp"
#include "output/stopwatch.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kLocaliseExamples =
    R"(From no initial pose. Both frames have their z axis up, the scan's to 15 degrees, or --gravity says
which axis is: of the scan, then of the map. The verdict speaks of the scan; the map need not be covered.

Examples:
  gmcr localise scan.ply map.ply
  gmcr prepare map.ply -o town.map.ply --map --voxel 0.5
  gmcr localise scan.bin town.map.ply -o T.txt --json
  the scanner lay on its side, and an inertial sensor says how:
    gmcr localise scan.ply town.map.ply --gravity 0 -1 0 0 0 -1 --max-tilt 3
  where it was is known to 20 m:
    gmcr localise scan.ply town.map.ply --initial-pose T0.txt --max-translation-error 20)";

struct LocaliseArguments {
  std::string scan;
  std::string map;
  FrontendOptions frontend;
  CloudOptions reading;
  SolverArguments solver;
  std::vector<double> up{0, 0, 1};
  std::string transform;
  std::string aligned;
  OutputArguments output;
  Verdict required = Verdict::Untrusted;
};

/// Writes the files that need a pose, and returns their paths.
std::vector<std::string> write_files(const LocaliseArguments& arguments, const InputFile& scan,
                                     const Result& registration) {
  std::vector<std::string> written;
  if (registration.status != Status::Ok) return written;
  const Similarity& pose = registration.target_from_source;
  if (!arguments.transform.empty()) {
    write_transform(arguments.transform, pose);
    written.push_back(arguments.transform);
  }
  if (!arguments.aligned.empty()) {
    write_moved_cloud(arguments.aligned, scan.path(), pose, arguments.reading);
    written.push_back(arguments.aligned);
  }
  return written;
}

ExitCode run_localise(const LocaliseArguments& arguments) {
  Options options = arguments.solver.resolved();
  arguments.frontend.validate();
  check_outputs({{arguments.transform, Content::Transform}, {arguments.aligned, Content::Cloud}},
                {arguments.scan, arguments.map, arguments.solver.priors.initial_pose});
  if (arguments.scan == "-" && arguments.map == "-") {
    throw std::invalid_argument("SCAN, MAP: only one can be stdin");
  }
  const InputFile scan_file(arguments.scan), map_file(arguments.map);
  const Points scan = read_points(scan_file, arguments.reading);
  const Eigen::Vector3d up(arguments.up[0], arguments.up[1], arguments.up[2]);
  const PreparedMap map =
      read_map(map_file, arguments.reading, arguments.frontend, up, options.num_threads);
  CloudResult result;
  ReportContext context;
  context.options = &options;
  {
    ProgressLine progress(arguments.output.quiet);
    options.progress = progress.callback();
    const Stopwatch stopwatch;
    result = localise_scan(scan, map, arguments.frontend, options);
    context.total_seconds = stopwatch.seconds();
  }
  const std::vector<std::string> written = write_files(arguments, scan_file, result.registration);
  print_answer(
      arguments.output, [&] { return to_json(result, context, kJsonIndent); },
      [&] { return report_lines(result, Detail::Full, context); }, written);
  return exit_code_of(result.registration, result.verdict, arguments.required);
}

}  // namespace

void add_localise_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<LocaliseArguments>();
  CLI::App& command = *app.add_subcommand("localise", "Where in a map a scan was taken");
  command.add_option("SCAN", arguments->scan, "Scan to place, or - for stdin")->required();
  command
      .add_option("MAP", arguments->map, "Map to place it in: a cloud, or a file of prepare --map")
      ->required();
  command.add_option("--up", arguments->up, "Which way is up in the map")
      ->expected(3)
      ->type_name("X Y Z")
      ->default_str("0 0 1");
  add_reading(command, arguments->reading);
  add_flags(command, arguments->frontend, [](const std::string& name) {
    return name == "voxel_size" || name == "source_viewpoint" || name == "noise_bound_voxels" ||
           name == "refine";
  });
  arguments->solver.priors.add_to(command);
  add_flags(command, arguments->solver.options, [](const std::string& name) {
    return name == "scale" || name == "max_translation" || name == "num_threads" ||
           name == "time_limit";
  });
  add_required_verdict(command, arguments->required);
  constexpr const char* kOutput = "Output";
  command.add_option("-o,--output", arguments->transform, "Write the 4 x 4 transform")
      ->check(not_empty())
      ->type_name("T.txt")
      ->group(kOutput);
  command.add_option("--aligned", arguments->aligned, "Write the scan after the transform")
      ->check(not_empty())
      ->type_name("CLOUD")
      ->group(kOutput);
  arguments->output.add_to(command);
  command.footer(kLocaliseExamples);
  command.callback([arguments, &work] { work = [arguments] { return run_localise(*arguments); }; });
}

}  // namespace gmcr::cli
