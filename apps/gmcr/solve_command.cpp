#include "arguments.hpp"
#include "commands.hpp"
#include "gmcr/io.hpp"
#include "gmcr/registration.hpp"
#include "json.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "stopwatch.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kExamples =
    R"(MATCHES is a CSV with the columns ax,ay,az,bx,by,bz (source point, target point; also
sx,sy,sz,tx,ty,tz, by name among others) or an .npy of shape (N, 6).

Examples:
  gmcr solve matches.csv --noise-bound 0.05
  gmcr solve matches.npy --noise-bound 0.05 --estimate-scale --scale-range 0.1 10
  gmcr solve matches.csv --noise-bound 0.6 --evidence count --json > result.json
  gmcr solve matches.csv --noise-bound 0.6 -o T.txt --inliers inliers.txt)";

struct Arguments {
  std::string matches;
  SolverArguments solver;
  std::string transform_path;
  std::string inliers_path;
  bool json = false;
};

ExitCode run(const Arguments& arguments) {
  const Matches matches = read_matches(arguments.matches);
  Options options = arguments.solver.resolved();
  ProgressLine progress;
  options.progress = progress.callback();
  const Stopwatch stopwatch;
  const Result result = register_correspondences(matches.source, matches.target, options);
  const double seconds = stopwatch.seconds();
  const bool is_ok = result.status == Status::Ok;
  if (is_ok && !arguments.transform_path.empty()) {
    write_transform(arguments.transform_path, result.target_from_source);
  }
  if (!arguments.inliers_path.empty()) write_indices(arguments.inliers_path, result.inliers);
  if (arguments.json) {
    print(to_json(result, seconds));
  } else {
    Report report;
    add_result(report, result, seconds);
    if (is_ok && !arguments.transform_path.empty()) {
      report.line("written", arguments.transform_path);
    }
    report.print();
  }
  return is_ok ? kPoseFound : kNoPose;
}

}  // namespace

void add_solve_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("solve", "Pose from a file of putative matches");
  command.add_option("MATCHES", arguments->matches, "Matches, .csv or .npy")->required();
  command
      .add_option("--noise-bound", arguments->solver.options.noise_bound,
                  "Largest error of a right match, metres")
      ->required();
  arguments->solver.add_to(command);
  command.add_option("-o,--output", arguments->transform_path, "Write the 4 x 4 transform")
      ->type_name("T.txt");
  command.add_option("--inliers", arguments->inliers_path, "Write the inlier indices, from 0")
      ->type_name("FILE");
  command.add_flag("--json", arguments->json, "Print one JSON object");
  command.footer(kExamples);
  command.callback([arguments, &work] { work = [arguments] { return run(*arguments); }; });
}

}  // namespace gmcr::cli
