#include <fmt/core.h>

#include "arguments/arguments.hpp"
#include "arguments/output_files.hpp"
#include "arguments/validators.hpp"
#include "commands/commands.hpp"
#include "gmcr/io.hpp"
#include "input/read_points.hpp"
#include "output/html_report.hpp"
#include "output/json_text.hpp"
#include "output/progress.hpp"
#include "output/report.hpp"
#include "output/stopwatch.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kRegisterExamples =
    R"(Clouds: .ply .pcd .xyz .txt .asc .pts .csv .npy, KITTI .bin, nuScenes .pcd.bin; meshes, on whose
surface points are spread: .ply with faces, .obj .off .stl. Points that are not finite, and (0, 0, 0)
for no return, are dropped. --aligned keeps the other fields of .ply and .pcd. Voxel size and noise bound come
from the clouds unless given. One of the clouds may be - for stdin. Files of
`prepare` bring their features.

Examples:
  gmcr register scan2.ply scan1.ply
  gmcr register 000010.bin 000000.bin --voxel 0.3 -o T.txt --aligned aligned.ply
  gmcr register model.ply scene.pcd --estimate-scale --scale-range 0.1 10
  gmcr register a.ply b.ply --refine none --json > result.json
  gmcr register a.ply b.ply --report report.html

  the noise bound from the matches, not from the voxel size:
    gmcr register a.ply b.ply --noise-bound auto
  both scans are level to within 2 degrees, and at most 20 m apart:
    gmcr register b.bin a.bin --gravity 0 0 -1 --max-tilt 2 --max-translation 20
  odometry says where to look:
    gmcr register b.bin a.bin --initial-pose T0.txt --max-rotation-error 15 --max-translation-error 2
  prove the consensus a maximum one, for up to 10 s:
    gmcr register a.ply b.ply --certify --time-limit 10
  the object may be symmetric: the 3 best poses
    gmcr register model.ply scene.ply --hypotheses 3
  several of the object in the scene, each judged by itself
    gmcr register part.stl bin.ply --instances 5)";

struct RegisterArguments {
  CloudArguments clouds;
  SolverArguments solver;
  bool wants_instances = false;
  InstanceArguments instances;
  std::string transform;
  std::string aligned;
  std::string matches;
  std::string json_file;
  std::string report;
  OutputArguments output;
  Verdict required = Verdict::Untrusted;
};

void check_files(const RegisterArguments& arguments) {
  check_outputs(
      {{arguments.transform, Content::Transform},
       {arguments.json_file, Content::Text},
       {arguments.report, Content::Text},
       {arguments.aligned, Content::Cloud},
       {arguments.matches, Content::Matches}},
      {arguments.clouds.source, arguments.clouds.target, arguments.solver.priors.initial_pose});
}

/// Writes the files that need a pose, and returns the paths of all that were written.
std::vector<std::string> write_files(const RegisterArguments& arguments, const CloudFiles& files,
                                     const CloudResult& result, const Points& source,
                                     const Points& target, const std::string& json) {
  std::vector<std::string> written;
  const auto note = [&](const std::string& path) { written.push_back(path); };
  if (result.registration.status == Status::Ok) {
    const Similarity& pose = result.registration.target_from_source;
    if (!arguments.transform.empty()) {
      write_transform(arguments.transform, pose);
      note(arguments.transform);
    }
    if (!arguments.aligned.empty()) {
      write_moved_cloud(arguments.aligned, files.source.path(), pose, arguments.clouds.reading);
      note(arguments.aligned);
    }
  }
  if (!arguments.matches.empty()) {
    write_matches(arguments.matches, result.matches.source, result.matches.target);
    note(arguments.matches);
  }
  if (!arguments.json_file.empty()) {
    write_json(arguments.json_file, json);
    note(arguments.json_file);
  }
  if (!arguments.report.empty()) {
    write_html_report(arguments.report, json,
                      {files.source.name() + " \u2192 " + files.target.name(),
                       {result.matches.source, result.matches.target, {}},
                       source,
                       target});
    note(arguments.report);
  }
  return written;
}

/// One result, or one for each instance where these were asked for.
std::vector<CloudResult> registered(const RegisterArguments& arguments, const ReadPair& pair,
                                    const Options& options) {
  const FrontendOptions& frontend = arguments.clouds.frontend;
  if (arguments.wants_instances) {
    return register_cloud_instances(pair.source(), pair.target(), frontend, options,
                                    arguments.instances.limits);
  }
  return {pair.apply(frontend, [&](const auto& source, const auto& target) {
    return register_clouds(source, target, frontend, options);
  })};
}

ExitCode run_register(const RegisterArguments& arguments) {
  if (!arguments.report.empty()) require_html_reports();
  Options options = arguments.solver.resolved();
  arguments.clouds.frontend.validate();
  arguments.instances.limits.validate();
  check_files(arguments);
  const CloudFiles files(arguments.clouds);
  const ReadPair pair(files.source, files.target, arguments.clouds.reading);
  std::vector<CloudResult> results;
  ReportContext context;
  context.options = &options;
  {
    ProgressLine progress(arguments.output.quiet);
    options.progress = progress.callback();
    const Stopwatch stopwatch;
    results = registered(arguments, pair, options);
    context.total_seconds = stopwatch.seconds();
  }
  const CloudResult& result = results.front();
  const std::string json = arguments.wants_instances ? to_json(results, context, kJsonIndent)
                                                     : to_json(result, context, kJsonIndent);
  const std::vector<std::string> written =
      write_files(arguments, files, result, pair.source(), pair.target(), json);
  print_answer(
      arguments.output, [&] { return json; },
      [&] {
        return arguments.wants_instances ? report_lines(results, Detail::Full, context)
                                         : report_lines(result, Detail::Full, context);
      },
      written);
  return exit_code_of(result.registration, result.verdict, arguments.required);
}

}  // namespace

void add_register_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<RegisterArguments>();
  CLI::App& command = *app.add_subcommand("register", "Pose that aligns two clouds");
  arguments->clouds.add_to(command);
  arguments->solver.noise
      .add_to(command, fmt::format("Largest error of a right match, metres; 0: {} voxels; auto: "
                                   "chosen from the matches",
                                   FrontendOptions{}.noise_bound_voxels))
      ->default_str("0");
  arguments->solver.add_to(command);
  arguments->instances.add_to(command);
  add_required_verdict(command, arguments->required);
  constexpr const char* kOutput = "Output";
  const auto add_path = [&](const char* name, std::string& path, const char* help,
                            const char* type) {
    command.add_option(name, path, help)->check(not_empty())->type_name(type)->group(kOutput);
  };
  add_path("-o,--output", arguments->transform, "Write the 4 x 4 transform, of the first instance",
           "T.txt");
  add_path("--aligned", arguments->aligned, "Write the source after the transform", "CLOUD");
  add_path("--matches", arguments->matches, "Write the matches that inliers index", "MATCHES");
  add_path("--json-file", arguments->json_file, "Write the JSON object to a file too", "FILE");
  add_path("--report", arguments->report, "Write a page with pictures (needs the Python package)",
           "FILE.html");
  arguments->output.add_to(command);
  command.footer(kRegisterExamples);
  command.callback([arguments, &command, &work] {
    arguments->wants_instances = InstanceArguments::are_wanted(command);
    work = [arguments] { return run_register(*arguments); };
  });
}

}  // namespace gmcr::cli
