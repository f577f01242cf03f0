#include "support/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <fstream>
#include <optional>
#include <string>

#include "gmcr/metrics.hpp"
#include "gmcr/registration.hpp"

namespace gmcr::bench {
namespace {

constexpr double kRounding = 1e-9;

Index count_true_inliers(const Problem& problem) {
  const Eigen::ArrayXd residuals =
      (problem.target - problem.truth.apply(problem.source)).colwise().norm();
  return (residuals <= problem.noise_bound).count();
}

/// Starts the peak of the resident memory of this process anew, where the system can.
void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << "5"; }

/// Bytes at the peak; nullopt where the system does not tell.
std::optional<std::size_t> peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
  }
  return std::nullopt;
}

/// The result of the last solve; writes the wall times and the peak of memory into the record.
Result time_solves(const Problem& problem, const Options& options, int repetitions, Json& record) {
  Result result;
  std::vector<double> wall_ms;
  reset_peak_memory();
  for (int i = 0; i < repetitions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    result = register_correspondences(problem.source, problem.target, options);
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    wall_ms.push_back(elapsed.count());
    // A solve that took half of its time limit or more is slow enough to be seen in one run.
    if (elapsed.count() > 500 * options.time_limit) break;
  }
  record["wall_ms"] = quantile(wall_ms, 0.5);
  record["wall_ms_quartiles"] = {quantile(wall_ms, 0.25), quantile(wall_ms, 0.75)};
  record["repetitions"] = wall_ms.size();
  if (const auto bytes = peak_memory()) record["peak_memory_bytes"] = *bytes;
  return result;
}

/// By the bound that the result was judged by.
Consensus consensus_of_truth(const Problem& problem, Options options, const Result& result) {
  if (options.noise_mode == NoiseMode::Estimated) {
    options.noise_mode = NoiseMode::Given;
    options.noise_bound =
        result.noise_estimate ? result.noise_estimate->noise_bound : problem.noise_bound;
  }
  return evaluate_consensus(problem.truth, problem.source, problem.target, options);
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double position = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (position - std::floor(position)) * (values[above] - values[below]);
}

Json errors_of(const Similarity& estimate, const Similarity& truth, const PointsRef& points) {
  return {{"rotation_deg", rotation_error_deg(estimate.rotation, truth.rotation)},
          {"translation", translation_error(estimate.translation, truth.translation)},
          {"scale", scale_error(estimate.scale, truth.scale)},
          {"mean_point", mean_point_error(estimate, truth, points)}};
}

Json solve(const Problem& problem, Options options, const NamedMethod& method, TimeLimits limits,
           int repetitions) {
  Json record = {{"method", method.name},
                 {"input_hash", input_hash(problem.source, problem.target)},
                 {"num_correspondences", problem.source.cols()},
                 {"num_true_inliers", count_true_inliers(problem)},
                 {"noise_bound", problem.noise_bound}};
  try {
    options.noise_bound = problem.noise_bound;
    method.adapt(options, problem);
    options.time_limit = options.certify ? limits.certify : limits.solve;
    record["time_limit"] = options.time_limit;
    const Result result = time_solves(problem, options, options.certify ? 1 : repetitions, record);
    record.update(frontend::describe(result));
    const Consensus truth = consensus_of_truth(problem, options, result);
    record["truth_inliers"] = truth.inliers.size();
    record["truth_evidence"] = truth.evidence;
    if (result.status == Status::Ok || result.status == Status::Degenerate) {
      record["errors"] = errors_of(result.target_from_source, problem.truth, problem.source);
    }
  } catch (const std::exception& error) {
    record["status"] = "error";
    record["status_reason"] = error.what();
  }
  return record;
}

void judge(Json& record, bool success) {
  record["success"] = success;
  if (!record.contains("truth_evidence")) return;
  const double truth = record["truth_evidence"];
  const double found = record["evidence"];
  record["missed"] = truth > found + kRounding * truth;
  record["truth_is_beaten"] = !success && !record["missed"].get<bool>();
}

}  // namespace gmcr::bench
