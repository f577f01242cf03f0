// Real putative correspondences with known scale: the KITTI FPFH and GORE sets.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>

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
};

constexpr double kMaxRotationErrorDeg = 5;

std::vector<Case> find_cases(const std::filesystem::path& root) {
  std::vector<Case> cases;
  for (const auto& folder : pairs_of_set(root, "kitti_fpfh")) {
    cases.push_back({"kitti_fpfh", folder, 0.6, 0.6});
  }
  for (const auto& folder : pairs_of_set(root, "gore")) {
    const auto resolution = listed_resolution(root, "gore", folder.filename().string());
    if (!resolution) continue;
    cases.push_back({"gore", folder, 2 * *resolution, std::numeric_limits<double>::infinity()});
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
  return {motion.apply(matches.source), matches.target, truth * motion.inverse(), item.noise_bound};
}

bool succeeded(const Json& record, const Case& item) {
  return record.contains("errors") && record["errors"]["rotation_deg"] <= kMaxRotationErrorDeg &&
         record["errors"]["translation"] <= item.max_translation_error;
}

void run(const std::string& out, const std::vector<std::string>& method_names, int threads,
         int repetitions, double time_limit) {
  const auto cases = find_cases(data_root());
  const auto methods = methods_named(method_names);
  Records records(out, "correspondences", cases.size() * methods.size());
  if (cases.empty()) fmt::print(stderr, "skipped: no data in {}\n", data_root().string());

  std::uint64_t seed = 0;
  for (const Case& item : cases) {
    const Problem problem = load(item, ++seed);
    for (const NamedMethod& method : methods) {
      Options options;
      options.num_threads = threads;
      options.budget.time = time_limit;
      Json record = {{"scenario", item.set + "/" + item.folder.filename().string()},
                     {"set", item.set},
                     {"seed", seed}};
      record.update(solve(problem, options, method, repetitions));
      record["success"] = succeeded(record, item);
      const std::string note =
          fmt::format("{} {} {} {} {:.1f} ms", record["scenario"].get<std::string>(), method.name,
                      record["success"] ? "right" : "WRONG", record["status"].get<std::string>(),
                      record.value("wall_ms", 0.0));
      records.write(std::vector<Json>(1, record), note);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Registers the real correspondences of the KITTI FPFH and GORE sets."};
  std::string out = "out/bench/correspondences.jsonl";
  std::vector<std::string> methods{"gmcr", "gmcr-count", "paper"};
  int threads = 0;
  int repetitions = 5;
  double time_limit = 20;
  app.add_option("--out", out, "file for the records")->capture_default_str();
  app.add_option("--methods", methods, "gmcr, gmcr-count, paper")->delimiter(',');
  app.add_option("--threads", threads, "0: all cores")->capture_default_str();
  app.add_option("--repetitions", repetitions, "solves a record")->capture_default_str();
  app.add_option("--time-limit", time_limit, "seconds a solve")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    run(out, methods, threads, repetitions, time_limit);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_correspondences: {}\n", error.what());
    return 1;
  }
}
