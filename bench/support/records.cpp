#include "support/records.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include "gmcr/isa.hpp"
#include "gmcr/version.hpp"

namespace gmcr::bench {
namespace {

std::string cpu_model() {
  std::ifstream cpu_info("/proc/cpuinfo");
  for (std::string line; std::getline(cpu_info, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::uint64_t fnv1a(std::uint64_t hash, const PointsRef& points) {
  for (Index c = 0; c < points.cols(); ++c) {
    for (Index r = 0; r < 3; ++r) {
      std::uint64_t bits = 0;
      const double value = points(r, c);
      std::memcpy(&bits, &value, sizeof bits);
      hash = (hash ^ bits) * 1099511628211ull;
    }
  }
  return hash;
}

}  // namespace

Json environment() {
  return {{"version", kVersion},
          {"cpu", cpu_model()},
          {"isa", active_isa()},
          {"cores", std::thread::hardware_concurrency()}};
}

std::string input_hash(const PointsRef& source, const PointsRef& target) {
  return fmt::format("{:016x}", fnv1a(fnv1a(14695981039346656037ull, source), target));
}

Json describe(const Result& result) {
  Json limits = Json::array();
  for (const LimitHit& hit : result.diagnostics.limits_hit) limits.push_back(hit.sentence);
  Json stages = Json::object();
  for (const StageTime& stage : result.diagnostics.stages) {
    stages[stage.name] = 1e3 * stage.seconds;
  }
  Json record = {{"status", to_string(result.status)},
                 {"status_reason", result.status_reason},
                 {"num_inliers", result.inliers.size()},
                 {"evidence", result.evidence},
                 {"certificate",
                  {{"lower", result.certificate.lower},
                   {"upper", result.certificate.upper},
                   {"certified", result.certificate.certified},
                   {"evidence",
                    {{"lower", result.certificate.evidence.lower},
                     {"upper", result.certificate.evidence.upper},
                     {"certified", result.certificate.evidence.certified}}}}},
                 {"num_candidates", result.diagnostics.num_candidates},
                 {"num_scale_ranges", result.diagnostics.num_scale_ranges},
                 {"num_clique_nodes", result.diagnostics.num_clique_nodes},
                 {"limits_hit", limits},
                 {"threads", result.diagnostics.num_threads},
                 {"stages_ms", stages}};
  if (result.noise_estimate) {
    record["noise_estimate"] = {{"noise_bound", result.noise_estimate->noise_bound},
                                {"stable_min", result.noise_estimate->stable_min},
                                {"stable_max", result.noise_estimate->stable_max},
                                {"log10_false_alarms", result.noise_estimate->log10_false_alarms}};
  }
  return record;
}

Records::Records(const std::filesystem::path& path, std::string program, std::size_t num_groups)
    : program_(std::move(program)), environment_(environment()), num_groups_(num_groups) {
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
  file_.open(path);
  if (!file_) throw std::runtime_error(path.string() + ": cannot be written");
}

void Records::write(const std::vector<Json>& group, const std::string& note) {
  for (const Json& record : group) {
    Json line = {{"program", program_}};
    line.update(record);
    line.update(environment_);
    file_ << line.dump() << '\n';
  }
  file_.flush();
  if (!file_) throw std::runtime_error("records: write failed");
  fmt::print(stderr, "[{}/{}] {}\n", ++num_written_, num_groups_, note);
}

}  // namespace gmcr::bench
