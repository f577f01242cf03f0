// Time, memory and success over the number of correspondences and the share of outliers: random
// outliers in the bounding ball.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "gmcr/synthetic.hpp"
#include "support/solve.hpp"

namespace {

using namespace gmcr;
using namespace gmcr::bench;

constexpr double kUnknownScale = 2.5;
constexpr double kMaxRotationErrorDeg = 5;
constexpr double kMaxTranslationError = 0.1;  // metres, a tenth of the cube
constexpr double kMaxScaleError = 0.05;
constexpr int kHardSeeds = 20;

struct Case {
  bool scale_known;
  Index num_correspondences;
  double outlier_rate;
  int num_seeds;
};

struct Settings {
  std::string out = "out/bench/scaling.jsonl";
  std::vector<std::string> methods{"gmcr", "gmcr-count", "paper"};
  int num_seeds = 10;
  int threads = 0;
  TimeLimits limits{20, 20};
  bool quick = false;
};

/// Few inliers for the number of correspondences: where a search over scales can fail.
bool is_hard(Index count, double rate) {
  return count == 1000 ? rate == 0.98 : (count == 200 || count == 500) && rate == 0.95;
}

std::vector<Case> list_cases(const Settings& settings) {
  std::vector<Case> cases;
  const int few = std::min(settings.num_seeds, settings.quick ? 3 : 5);
  const auto add = [&](bool scale_known, Index count, std::vector<double> rates, int num_seeds) {
    for (const double rate : rates) {
      const bool hard = !scale_known && is_hard(count, rate) && !settings.quick;
      cases.push_back(
          {scale_known, count, rate, hard ? std::max(num_seeds, kHardSeeds) : num_seeds});
    }
  };
  const int seeds = settings.quick ? few : settings.num_seeds;
  for (const Index count : {1, 3, 10, 30, 100, 300}) add(true, count, {0.9}, seeds);
  add(true, 1000, {0, 0.5, 0.9, 0.95, 0.99}, seeds);
  add(true, 3000, {0.9, 0.99}, seeds);
  add(true, 5000, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99}, seeds);
  if (!settings.quick) {
    add(true, 10000, {0, 0.5, 0.9, 0.95, 0.99}, seeds);
    add(true, 30000, {0.9, 0.99}, few);
    add(true, 50000, {0.99}, few);
    add(true, 100000, {0.99}, few);
  }
  for (const Index count : {1, 3, 10, 30}) add(false, count, {0.9}, seeds);
  for (const Index count : {80, 200, 500}) add(false, count, {0.5, 0.8, 0.9, 0.95}, seeds);
  add(false, 1000, {0.5, 0.8, 0.9, 0.95, 0.98}, seeds);
  if (!settings.quick) {
    add(false, 2000, {0.5, 0.8, 0.9, 0.95}, seeds);
    add(false, 5000, {0.9}, few);
    add(false, 10000, {0.9}, few);
  }
  return cases;
}

bool succeeded(const Json& record) {
  if (!record.contains("errors")) return false;
  const Json& errors = record["errors"];
  return errors["rotation_deg"] <= kMaxRotationErrorDeg &&
         errors["translation"] <= kMaxTranslationError && errors["scale"] <= kMaxScaleError;
}

Json run_one(const Settings& settings, const Case& item, std::uint64_t seed,
             const NamedMethod& method) {
  SyntheticOptions draw;
  draw.num_correspondences = item.num_correspondences;
  draw.outlier_rate = item.outlier_rate;
  draw.seed = seed;
  if (!item.scale_known) draw.scale_range = {kUnknownScale, kUnknownScale};
  const SyntheticProblem drawn = make_synthetic(draw);

  Options options;
  options.scale_mode = item.scale_known ? ScaleMode::Known : ScaleMode::Estimated;
  options.num_threads = settings.threads;
  Json record = {{"scenario", item.scale_known ? "known scale" : "unknown scale"},
                 {"outlier_rate", item.outlier_rate},
                 {"seed", seed}};
  record.update(solve({drawn.source, drawn.target, drawn.target_from_source, drawn.noise_bound},
                      options, method, settings.limits, 1));
  frontend::judge(record, succeeded(record));
  return record;
}

/// Runs the seeds of a case; gives up the rest once two solves have used up their time.
std::vector<Json> run_case(const Settings& settings, const Case& item, const NamedMethod& method) {
  std::vector<Json> group;
  int num_slow = 0;
  for (int seed = 0; seed < item.num_seeds && num_slow < 2; ++seed) {
    group.push_back(run_one(settings, item, static_cast<std::uint64_t>(seed), method));
    num_slow += group.back().value("wall_ms", 0.0) > 500 * settings.limits.solve;
  }
  return group;
}

void run(const Settings& settings) {
  const auto methods = methods_named(settings.methods);
  const auto cases = list_cases(settings);
  Records records(settings.out, "scaling", cases.size() * methods.size());
  for (const Case& item : cases) {
    for (const NamedMethod& method : methods) {
      const std::vector<Json> group = run_case(settings, item, method);
      int num_successes = 0;
      std::vector<double> times;
      for (const Json& record : group) {
        num_successes += record["success"].get<bool>();
        times.push_back(record.value("wall_ms", 0.0));
      }
      records.write(group,
                    fmt::format("{} scale N = {} {:.0f} % outliers {}: {} of {} right, "
                                "{:.2f} ms",
                                item.scale_known ? "known" : "unknown", item.num_correspondences,
                                100 * item.outlier_rate, method.name, num_successes, group.size(),
                                quantile(times, 0.5)));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Times the solver over the number of correspondences."};
  Settings settings;
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_option("--methods", settings.methods, method_names())->delimiter(',');
  app.add_option("--seeds", settings.num_seeds, "problems a case; 20 for the hard ones")
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "0: all cores")->capture_default_str();
  app.add_option("--time-limit", settings.limits.solve, "seconds a solve")->capture_default_str();
  app.add_option("--certify-time-limit", settings.limits.certify, "seconds a solve that certifies")
      ->capture_default_str();
  app.add_flag("--quick", settings.quick, "fewer problems, none of the largest");
  CLI11_PARSE(app, argc, argv);
  try {
    run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_scaling: {}\n", error.what());
    return 1;
  }
}
