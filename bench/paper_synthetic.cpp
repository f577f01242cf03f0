// The paper's two synthetic benchmarks, unknown scale: random and structured outliers.

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

constexpr double kMaxMeanPointError = 0.3;  // metres, as in the paper

struct Settings {
  std::string out = "out/bench/paper_synthetic.jsonl";
  std::vector<std::string> methods{"gmcr", "gmcr-count", "paper"};
  std::vector<std::string> models{"bunny", "armadillo", "dragon"};
  std::vector<std::string> kinds{"random", "structured"};
  std::vector<double> rates{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.95};
  int num_seeds = 40;
  int threads = 0;
  TimeLimits limits{10, 2};
  bool quick = false;
};

void use_quick(Settings& settings) {
  settings.models = {"bunny"};
  settings.rates = {0, 0.5, 0.8, 0.9, 0.95};
  settings.num_seeds = std::min(settings.num_seeds, 10);
}

Json run_one(const Settings& settings, const std::string& kind, const std::string& model_name,
             const Points& model, double rate, std::uint64_t seed, const NamedMethod& method) {
  SyntheticOptions draw = kind == "random" ? paper_random_options() : paper_structured_options();
  draw.outlier_rate = rate;
  draw.seed = seed;
  const SyntheticProblem drawn = make_synthetic(draw, model);
  const Problem problem{drawn.source, drawn.target, drawn.target_from_source, drawn.noise_bound};

  Options options;
  options.scale_mode = ScaleMode::Estimated;
  options.num_threads = settings.threads;
  Json record = {{"scenario", kind},
                 {"model", model_name},
                 {"outlier_rate", rate},
                 {"seed", seed},
                 {"true_scale", drawn.target_from_source.scale}};
  record.update(solve(problem, options, method, settings.limits, 1));
  judge(record, record.contains("errors") && record["errors"]["mean_point"] < kMaxMeanPointError);
  return record;
}

void run(const Settings& settings) {
  const auto methods = methods_named(settings.methods);
  Records records(
      settings.out, "paper_synthetic",
      settings.kinds.size() * settings.models.size() * settings.rates.size() * methods.size());
  for (const std::string& name : settings.models) {
    const auto path = data_root() / "models" / (name + ".ply");
    if (!std::filesystem::exists(path)) {
      fmt::print(stderr, "skipped: {} is absent\n", path.string());
      continue;
    }
    const Points model = read_cloud(path).points;
    for (const std::string& kind : settings.kinds) {
      for (const double rate : settings.rates) {
        for (const NamedMethod& method : methods) {
          int num_successes = 0;
          std::vector<double> times;
          std::vector<Json> group;
          for (int seed = 0; seed < settings.num_seeds; ++seed) {
            group.push_back(run_one(settings, kind, name, model, rate,
                                    static_cast<std::uint64_t>(seed), method));
            num_successes += group.back()["success"].get<bool>();
            times.push_back(group.back().value("wall_ms", 0.0));
          }
          records.write(group, fmt::format("{} {} {:.0f} % outliers {}: {} of {} right, {:.2f} ms",
                                           kind, name, 100 * rate, method.name, num_successes,
                                           settings.num_seeds, quantile(times, 0.5)));
        }
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs the paper's synthetic benchmarks with random and structured outliers."};
  Settings settings;
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_option("--methods", settings.methods, method_names())->delimiter(',');
  app.add_option("--models", settings.models, "names in the set models")->delimiter(',');
  app.add_option("--kinds", settings.kinds, "random, structured")
      ->delimiter(',')
      ->check(CLI::IsMember({"random", "structured"}));
  app.add_option("--rates", settings.rates, "outlier rates")->delimiter(',');
  app.add_option("--seeds", settings.num_seeds, "problems a rate")->capture_default_str();
  app.add_option("--threads", settings.threads, "0: all cores")->capture_default_str();
  app.add_option("--time-limit", settings.limits.solve, "seconds a solve")->capture_default_str();
  app.add_option("--certify-time-limit", settings.limits.certify, "seconds a solve that certifies")
      ->capture_default_str();
  app.add_flag("--quick", settings.quick, "fewer models, rates and seeds");
  CLI11_PARSE(app, argc, argv);
  if (settings.quick) use_quick(settings);
  try {
    run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_paper_synthetic: {}\n", error.what());
    return 1;
  }
}
