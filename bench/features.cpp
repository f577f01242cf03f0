// Matching of the features of large clouds: all with all, and by an index, on real pairs at fine
// voxels.

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "frontend/features/cloud_scales.hpp"
#include "frontend/matching/feature_matching.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/io.hpp"
#include "parallel/stopwatch.hpp"
#include "support/data_sets.hpp"
#include "support/records.hpp"

namespace {

using namespace gmcr;
using namespace gmcr::bench;

constexpr double kRightWithin = 1.5;  // voxels

struct Settings {
  std::string out = "out/bench/features.jsonl";
  std::vector<std::string> sets{"lidar", "mining_lidar", "3dmatch", "rgbd_frames", "objects_rgbd"};
  std::vector<double> finer{2, 3, 4, 6};
  double least_pairs = frontend::MatchingOptions().most_pairs;
};

struct Described {
  Points voxels;
  frontend::Features features;
};

Described describe(const Points& points, double voxel_size) {
  Points voxels = voxel_grid(points, voxel_size);
  frontend::Features features = fpfh(voxels, {}, voxel_size, 0);
  return {std::move(voxels), std::move(features)};
}

Json matched(const Described& source, const Described& target, const Similarity& truth,
             double radius, double most_pairs) {
  frontend::MatchingOptions options;
  options.most_pairs = most_pairs;
  const parallel::Stopwatch stopwatch;
  const auto matches = frontend::match_features(source.features, target.features, options);
  const double seconds = stopwatch.elapsed();
  Index num_right = 0;
  for (const auto& [i, j] : matches.pairs) {
    num_right += (truth * source.voxels.col(i) - target.voxels.col(j)).norm() <= radius;
  }
  return {{"num_matches", matches.pairs.size()}, {"num_right", num_right}, {"ms", 1e3 * seconds}};
}

/// One line for each voxel size at which the pair is large.
std::vector<Json> measure(const std::filesystem::path& folder, const Settings& settings) {
  const Points source = read_cloud(folder / "source.ply").points;
  const Points target = read_cloud(folder / "target.ply").points;
  const Similarity truth = read_transform(folder / "T_target_source.txt");
  const double coarse = std::min(frontend::CloudScales(source).voxel_size(),
                                 frontend::CloudScales(target).voxel_size());
  std::vector<Json> records;
  double num_before = 0;
  for (const double finer : settings.finer) {
    const double voxel_size = coarse / finer;
    const Described from = describe(source, voxel_size), to = describe(target, voxel_size);
    const double num_pairs =
        static_cast<double>(from.voxels.cols()) * static_cast<double>(to.voxels.cols());
    if (num_pairs <= settings.least_pairs) continue;
    if (num_pairs < 1.2 * num_before) break;  // a voxel a point
    num_before = num_pairs;
    const double radius = kRightWithin * voxel_size;
    records.push_back({{"scenario", folder.parent_path().filename() / folder.filename()},
                       {"voxel_size", voxel_size},
                       {"num_sources", from.voxels.cols()},
                       {"num_targets", to.voxels.cols()},
                       {"all", matched(from, to, truth, radius, 1e300)},
                       {"index", matched(from, to, truth, radius, 0)}});
  }
  return records;
}

}  // namespace

int main(int argc, char** argv) {
  Settings settings;
  CLI::App app{"Matches the features of real pairs at fine voxels, all with all and by an index."};
  app.add_option("--out", settings.out, "file for the records")->capture_default_str();
  app.add_option("--sets", settings.sets, "sets of pairs");
  app.add_option("--finer", settings.finer, "the default voxel size over each that is used");
  app.add_option("--least-pairs", settings.least_pairs, "of features, that are measured");
  CLI11_PARSE(app, argc, argv);
  try {
    std::vector<std::filesystem::path> folders;
    for (const std::string& set : settings.sets) {
      const auto pairs = pairs_of_set(data_root(), set);
      if (pairs.empty()) fmt::print(stderr, "skipped: {} is absent\n", set);
      folders.insert(folders.end(), pairs.begin(), pairs.end());
    }
    Records records(settings.out, "features", folders.size());
    for (const auto& folder : folders) records.write(measure(folder, settings), folder.string());
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_features: {}\n", error.what());
    return 1;
  }
  return 0;
}
