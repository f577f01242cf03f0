// Time and success over the number of correspondences, random outliers in the bounding ball.

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
  bool large = false;
  bool quick = false;
};

/// Few inliers for the number of correspondences: where a search over scales can fail.
bool is_hard(Index count, double rate) {
  return count == 1000 ? rate == 0.98 : (count == 200 || count == 500) && rate == 0.95;
}

std::vector<Case> list_cases(const Settings& settings) {
  std::vector<Case> cases;
  std::vector<Index> known{1000, 5000, 10000};
  std::vector<Index> unknown{80, 200, 500, 1000, 2000};
  if (settings.quick) {
    known = {1000, 5000};
    unknown = {80, 200, 500, 1000};
  }
  const int num_seeds = settings.quick ? std::min(settings.num_seeds, 5) : settings.num_seeds;
  for (const Index count : known) {
    for (const double rate : {0.0, 0.5, 0.9, 0.95, 0.99}) {
      cases.push_back({true, count, rate, num_seeds});
    }
  }
  for (const Index count : unknown) {
    for (const double rate : {0.5, 0.8, 0.9, 0.95, 0.98}) {
      if (rate == 0.98 && count != 1000) continue;
      const bool more = is_hard(count, rate) && !settings.quick;
      cases.push_back({false, count, rate, more ? std::max(num_seeds, kHardSeeds) : num_seeds});
    }
  }
  if (settings.large) {
    cases.push_back({true, 50000, 0.99, 1});
    cases.push_back({true, 100000, 0.99, 1});
    cases.push_back({false, 5000, 0.9, num_seeds});
    cases.push_back({false, 10000, 0.9, num_seeds});
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
  judge(record, succeeded(record));
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
  app.add_flag("--large", settings.large, "also N = 50,000 and 100,000");
  app.add_flag("--quick", settings.quick, "no N = 10,000 and 2,000");
  CLI11_PARSE(app, argc, argv);
  try {
    run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_scaling: {}\n", error.what());
    return 1;
  }
}
