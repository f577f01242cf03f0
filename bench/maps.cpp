// A scan in a map, from no initial pose: a synthetic town, and real scans merged into one map.

#include <fmt/core.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <exception>
#include <functional>
#include <numbers>
#include <optional>

#include "gmcr/localisation.hpp"
#include "gmcr/metrics.hpp"
#include "gmcr/prepared_cloud.hpp"
#include "maps/cases.hpp"
#include "support/data_sets.hpp"
#include "support/records.hpp"
#include "support/solve.hpp"

namespace {

using namespace gmcr;
using namespace gmcr::bench;

constexpr double kRightDegrees = 2;
constexpr double kRightMetres = 0.5;

struct Settings {
  std::string out = "out/bench/maps.jsonl";
  TownSettings town;
  bool is_merged = false;
  int num_headings = 4;
  double max_tilt_deg = -1;
  double initial_metres = -1;
  bool by_features = false;
};

/// A way to place a scan in a map.
using Localise = std::function<CloudResult(const Points& scan, const Options& options)>;

/// Seconds of all threads of this process, which is asked for one.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

Options options_of(const Settings& settings, const MapQuery& query) {
  constexpr double kDegree = std::numbers::pi / 180;
  Options options;
  options.num_threads = 1;
  if (settings.max_tilt_deg >= 0) {
    options.gravity = GravityPrior{query.map_from_scan.rotation.transpose().col(2),
                                   Eigen::Vector3d::UnitZ(), kDegree * settings.max_tilt_deg};
  }
  if (settings.initial_metres >= 0) {
    options.initial_pose = InitialPose{query.map_from_scan, 20 * kDegree, settings.initial_metres};
    options.initial_pose->target_from_source.translation.x() += settings.initial_metres / 2;
  }
  return options;
}

Json run_query(const Localise& localise, const MapQuery& query, const Options& options) {
  const double start = cpu_seconds();
  const CloudResult result = localise(query.scan, options);
  const double seconds = cpu_seconds() - start;
  Json record = describe(result.registration);
  record["group"] = query.group;
  record["is_elsewhere"] = query.is_elsewhere;
  record["cpu_ms"] = 1000 * seconds;
  record["num_source_points"] = query.scan.cols();
  record["source_share"] = result.surfaces.source_share;
  record["num_rivals"] = result.rivals.size();
  record["verdict"] = to_string(result.verdict);
  record["verdict_reason"] = result.verdict_reason;
  record["success"] = false;
  if (result.registration.status != Status::Ok) return record;
  const Similarity& pose = result.registration.target_from_source;
  const double metres = (pose.translation - query.map_from_scan.translation).norm();
  const double degrees = rotation_error_deg(pose.rotation, query.map_from_scan.rotation);
  record["errors"] = {{"rotation_deg", degrees}, {"translation", metres}};
  record["success"] = !query.is_elsewhere && metres <= kRightMetres && degrees <= kRightDegrees;
  return record;
}

void run(const Settings& settings) {
  const MapCase maps = settings.is_merged
                           ? merged_case(data_root(), settings.num_headings, settings.town.seed)
                           : town_case(settings.town);
  FrontendOptions frontend;
  frontend.voxel_size = maps.voxel_size;
  const double start = cpu_seconds();
  const PreparedMap map(maps.map, frontend, Eigen::Vector3d::UnitZ(), 1);
  std::optional<PreparedCloud> cloud;
  if (settings.by_features) {
    frontend.voxel_size = map.voxel_size();
    cloud.emplace(maps.map, frontend, 1);
    frontend.max_attempts = 1;
  }
  const double prepare_seconds = cpu_seconds() - start;
  const Localise localise = [&](const Points& scan, const Options& options) {
    if (!cloud) return localise_scan(scan, map, {}, options);
    return register_clouds(cloud->beside(scan, Eigen::Vector3d::Zero()), *cloud, frontend, options);
  };
  Records records(settings.out, "maps", maps.queries.size());
  for (const MapQuery& query : maps.queries) {
    Json record = {{"scenario", maps.name},
                   {"method", cloud ? "register_clouds" : "localise_scan"},
                   {"seed", settings.town.seed},
                   {"num_map_points", maps.map.cols()},
                   {"voxel_size", map.voxel_size()},
                   {"prepare_cpu_ms", 1000 * prepare_seconds},
                   {"gravity", settings.max_tilt_deg >= 0},
                   {"initial_pose", settings.initial_metres >= 0}};
    record.update(run_query(localise, query, options_of(settings, query)));
    record["peak_mib"] = peak_mebibytes();
    records.write(std::vector<Json>(1, record),
                  fmt::format("{}: {}, {}, {:.0f} ms, {}", query.group,
                              record["success"].get<bool>() ? "right" : "not right",
                              record["verdict"].get<std::string>(), record["cpu_ms"].get<double>(),
                              record["verdict_reason"].get<std::string>()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Scans in a map, from no initial pose."};
  Settings settings;
  TownSettings& town = settings.town;
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_flag("--merged", settings.is_merged, "real scans in one map instead of a town");
  app.add_option("--headings", settings.num_headings, "of each real scan")->capture_default_str();
  app.add_option("--extent", town.extent, "side of the town, metres")->capture_default_str();
  app.add_option("--drive-step", town.drive_step, "metres between scans")->capture_default_str();
  app.add_option("--map-voxel", town.map_voxel, "of the map's points")->capture_default_str();
  app.add_option("--scans", town.num_scans, "for each number of rings")->capture_default_str();
  app.add_option("--rings", town.rings, "16, 32, 64")->delimiter(',');
  app.add_option("--seed", town.seed, "of the town")->capture_default_str();
  app.add_option("--gravity-tilt", settings.max_tilt_deg, "gravity is known to so many degrees");
  app.add_option("--initial-metres", settings.initial_metres,
                 "an initial pose is known to so many metres and 20 degrees");
  app.add_flag("--features", settings.by_features,
               "match features to those of the whole map instead: register_clouds, one attempt");
  CLI11_PARSE(app, argc, argv);
  try {
    run(settings);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_maps: {}\n", error.what());
    return 1;
  }
}
