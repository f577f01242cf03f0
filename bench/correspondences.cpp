// Real putative correspondences with known scale: the KITTI FPFH and GORE sets.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>

#include "gmcr/io.hpp"
#include "gmcr/synthetic.hpp"
#include "support/data_sets.hpp"
#include "support/solve.hpp"

namespace {

using namespace gmcr;
using namespace gmcr::bench;

struct Case {
  std::string set;
  std::filesystem::path folder;
  double noise_bound;
  double max_translation_error;  // metres; infinity where the set judges by rotation alone
  bool is_upright;               // the z axes of both frames point up
};

struct Settings {
  std::string out = "out/bench/correspondences.jsonl";
  std::vector<std::string> methods{"gmcr",         "gmcr-count",   "paper",
                                   "gmcr-certify", "gmcr-gravity", "gmcr-auto-noise"};
  int threads = 0;
  int repetitions = 5;
  TimeLimits limits{20, 30};
};

constexpr double kRadians = std::numbers::pi / 180;  // a degree
constexpr double kMaxRotationErrorDeg = 5;
constexpr double kMaxTiltDeg = 3;

std::vector<Case> find_cases(const std::filesystem::path& root) {
  std::vector<Case> cases;
  for (const auto& folder : pairs_of_set(root, "kitti_fpfh")) {
    cases.push_back({"kitti_fpfh", folder, 0.6, 0.6, true});
  }
  for (const auto& folder : pairs_of_set(root, "gore")) {
    const auto resolution = listed_resolution(root, "gore", folder.filename().string());
    if (!resolution) continue;
    cases.push_back(
        {"gore", folder, 2 * *resolution, std::numeric_limits<double>::infinity(), false});
  }
  return cases;
}

/// The matches of a case after a random rotation of the source, since some pairs are moved by a
/// pure shift or hardly at all.
Problem load(const Case& item, std::uint64_t seed) {
  const Matches matches = read_matches(item.folder / "correspondences.csv");
  SyntheticOptions draw;
  draw.num_correspondences = 0;
  draw.max_translation = 0;
  draw.seed = seed;
  const Similarity motion = make_synthetic(draw).target_from_source;
  const Similarity truth = read_transform(item.folder / "T_target_source.txt");
  Problem problem{motion.apply(matches.source), matches.target, truth * motion.inverse(),
                  item.noise_bound};
  if (item.is_upright) {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    problem.gravity = GravityPrior{motion.rotation * up, up, kMaxTiltDeg * kRadians};
  }
  return problem;
}

/// Whether the set has what the method needs.
bool suits(const NamedMethod& method, const Problem& problem) {
  return method.name != "gmcr-gravity" || problem.gravity;
}

/// Angle between what the truth makes of the source's gravity and the target's.
double true_tilt_deg(const Problem& problem) {
  const Eigen::Vector3d turned = problem.truth.rotation * problem.gravity->source;
  return std::atan2(turned.cross(problem.gravity->target).norm(),
                    turned.dot(problem.gravity->target)) /
         kRadians;
}

bool succeeded(const Json& record, const Case& item) {
  return record.contains("errors") && record["errors"]["rotation_deg"] <= kMaxRotationErrorDeg &&
         record["errors"]["translation"] <= item.max_translation_error;
}

Json run_one(const Settings& settings, const Case& item, const Problem& problem, std::uint64_t seed,
             const NamedMethod& method) {
  Options options;
  options.num_threads = settings.threads;
  Json record = {{"scenario", item.set + "/" + item.folder.filename().string()},
                 {"set", item.set},
                 {"seed", seed}};
  record.update(solve(problem, options, method, settings.limits, settings.repetitions));
  if (problem.gravity) record["true_tilt_deg"] = true_tilt_deg(problem);
  frontend::judge(record, succeeded(record, item));
  return record;
}

void run(const Settings& settings) {
  const auto cases = find_cases(data_root());
  const auto methods = methods_named(settings.methods);
  Records records(settings.out, "correspondences", cases.size());
  if (cases.empty()) fmt::print(stderr, "skipped: no data in {}\n", data_root().string());

  std::uint64_t seed = 0;
  for (const Case& item : cases) {
    const Problem problem = load(item, ++seed);
    std::vector<Json> group;
    std::string note = item.set + "/" + item.folder.filename().string();
    for (const NamedMethod& method : methods) {
      if (!suits(method, problem)) continue;
      group.push_back(run_one(settings, item, problem, seed, method));
      const Json& record = group.back();
      note +=
          fmt::format("; {} {} {} {:.1f} ms", method.name, record["success"] ? "right" : "WRONG",
                      record["status"].get<std::string>(), record.value("wall_ms", 0.0));
    }
    records.write(group, note);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Registers the real correspondences of the KITTI FPFH and GORE sets."};
  Settings settings;
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_option("--methods", settings.methods, method_names())->delimiter(',');
  app.add_option("--threads", settings.threads, "0: all cores")->capture_default_str();
  app.add_option("--repetitions", settings.repetitions, "solves a record")->capture_default_str();
  app.add_option("--time-limit", settings.limits.solve, "seconds a solve")->capture_default_str();
  app.add_option("--certify-time-limit", settings.limits.certify, "seconds a solve that certifies")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_correspondences: {}\n", error.what());
    return 1;
  }
}
