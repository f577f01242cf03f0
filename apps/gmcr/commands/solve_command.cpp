#include <optional>

#include "arguments/arguments.hpp"
#include "arguments/choice.hpp"
#include "arguments/output_files.hpp"
#include "arguments/validators.hpp"
#include "commands/commands.hpp"
#include "gmcr/io.hpp"
#include "gmcr/registration.hpp"
#include "input/read_points.hpp"
#include "output/html_report.hpp"
#include "output/json_text.hpp"
#include "output/progress.hpp"
#include "output/report.hpp"
#include "output/stopwatch.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kSolveExamples =
    R"(MATCHES is a CSV with the columns ax,ay,az,bx,by,bz (source point, target point; also
sx,sy,sz,tx,ty,tz or x1..z2, by name among others) or an .npy of shape (N, 6), or - for either from stdin. A 7th column
(noise_bound) holds a noise bound for each match, instead of --noise-bound; without a name it is
refused where it may as well be a score.

Examples:
  gmcr solve matches.csv --noise-bound 0.05
  gmcr solve matches.npy --noise-bound 0.05 --estimate-scale --scale-range 0.1 10
  gmcr solve matches.csv --noise-bound 0.6 --evidence count --json > result.json
  gmcr solve matches.csv --noise-bound 0.6 -o T.txt --inliers inliers.txt
  gmcr solve matches.csv --noise-bound 0.05 --report report.html

  from another program:
    my_matcher a.ply b.ply | gmcr solve - --noise-bound 0.05
  the noise bound is not known:
    gmcr solve matches.csv --noise-bound auto
  the matches bring their own, in a column noise_bound:
    gmcr solve weighted.csv
  both scans are level to within 2 degrees, and at most 20 m apart:
    gmcr solve matches.csv --noise-bound 0.6 --gravity 0 0 -1 --max-tilt 2 --max-translation 20
  odometry says where to look:
    gmcr solve matches.csv --noise-bound 0.6 --initial-pose odometry.txt --max-rotation-error 15
  exit with 1 unless the matches prove the pose:
    gmcr solve matches.csv --noise-bound 0.05 --require trusted -o T.txt
  prove the consensus a maximum one, for up to 10 s:
    gmcr solve matches.csv --noise-bound 0.05 --certify --time-limit 10
  the object may be symmetric: the 3 best poses
    gmcr solve matches.csv --noise-bound 0.05 --hypotheses 3
  several of the object in the scene: up to 5 of at least 10 matches each
    gmcr solve matches.csv --noise-bound 0.05 --instances 5 --min-instance-inliers 10)";

struct SolveArguments {
  std::string matches;
  SolverArguments solver;
  bool wants_instances = false;
  InstanceArguments instances;
  std::string transform_path;
  std::string inliers_path;
  std::string report_path;
  OutputArguments output;
  Verdict required = Verdict::Untrusted;
};

/// One result, or one for each instance where these were asked for.
std::vector<Result> solve(const SolveArguments& arguments, const Matches& matches,
                          const Options& options) {
  if (arguments.wants_instances) {
    return register_instances(matches.source, matches.target, options, arguments.instances.limits);
  }
  return {register_correspondences(matches.source, matches.target, options)};
}

std::string json_of(const SolveArguments& arguments, const std::vector<Result>& results,
                    const ReportContext& context) {
  return arguments.wants_instances ? to_json(results, context, kJsonIndent)
                                   : to_json(results.front(), context, kJsonIndent);
}

ExitCode run_solve(const SolveArguments& arguments) {
  if (!arguments.report_path.empty()) require_html_reports();
  Options options = arguments.solver.resolved();
  arguments.instances.limits.validate();
  check_outputs({{arguments.transform_path, Content::Transform},
                 {arguments.inliers_path, Content::Text},
                 {arguments.report_path, Content::Text}},
                {arguments.matches, arguments.solver.priors.initial_pose});
  const InputFile file(arguments.matches);
  const Matches matches = file.read([](const auto& path) { return read_matches(path); });
  say_notes(file, matches.notes);
  arguments.solver.noise.check_against(matches, options);
  ProgressLine progress(arguments.output.quiet);
  options.progress = progress.callback();
  const Stopwatch stopwatch;
  const std::vector<Result> results = solve(arguments, matches, options);
  const double seconds = stopwatch.seconds();
  const Result& best = results.front();
  std::vector<std::string> written;
  if (best.status == Status::Ok && !arguments.transform_path.empty()) {
    write_transform(arguments.transform_path, best.target_from_source);
    written.push_back(arguments.transform_path);
  }
  if (!arguments.inliers_path.empty()) write_indices(arguments.inliers_path, best.inliers);
  ReportContext context;
  context.options = &options;
  context.total_seconds = seconds;
  if (!arguments.report_path.empty()) {
    write_html_report(arguments.report_path, json_of(arguments, results, context),
                      {file.name(), matches, {}, {}});
    written.push_back(arguments.report_path);
  }
  print_answer(
      arguments.output, [&] { return json_of(arguments, results, context); },
      [&] {
        return arguments.wants_instances ? report_lines(results, Detail::Full, context)
                                         : report_lines(best, Detail::Full, context);
      },
      written);
  return exit_code_of(best, best.verdict, arguments.required);
}

}  // namespace

void add_solve_command(CLI::App& app, Work& work) {
  const auto arguments = std::make_shared<SolveArguments>();
  CLI::App& command = *app.add_subcommand("solve", "Pose from a file of putative matches");
  command.add_option("MATCHES", arguments->matches, "Matches, .csv, .txt or .npy, or - for stdin")
      ->required();
  arguments->solver.noise.add_to(command,
                                 "Largest error of a right match, metres; auto: chosen from the "
                                 "matches. Required unless MATCHES has a 7th column");
  arguments->solver.add_to(command);
  arguments->instances.add_to(command);
  add_required_verdict(command, arguments->required);
  constexpr const char* kOutput = "Output";
  command
      .add_option("-o,--output", arguments->transform_path,
                  "Write the 4 x 4 transform, of the first instance")
      ->check(not_empty())
      ->type_name("T.txt")
      ->group(kOutput);
  command
      .add_option("--inliers", arguments->inliers_path,
                  "Write its inlier indices, from 0, one a line")
      ->check(not_empty())
      ->type_name("FILE")
      ->group(kOutput);
  command
      .add_option("--report", arguments->report_path,
                  "Write a page with pictures (needs the Python package)")
      ->check(not_empty())
      ->type_name("FILE.html")
      ->group(kOutput);
  arguments->output.add_to(command);
  command.footer(kSolveExamples);
  command.callback([arguments, &command, &work] {
    arguments->wants_instances = InstanceArguments::are_wanted(command);
    work = [arguments] { return run_solve(*arguments); };
  });
}

}  // namespace gmcr::cli
