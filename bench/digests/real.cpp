// Real correspondences and clouds, where the data is there.

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "digests/case.hpp"
#include "digests/settings.hpp"
#include "gmcr/io.hpp"
#include "support/data_sets.hpp"

namespace gmcr::bench {
namespace {

constexpr double kKittiBound = 0.6;
constexpr Index kAll = 100000;

/// Matches of a pair, all or the first of them.
struct RealMatches {
  std::string set;
  std::filesystem::path folder;
  double noise_bound = 0;
  Index max_size = kAll;
};

Problem load(const RealMatches& item) {
  const Matches matches = read_matches(item.folder / "correspondences.csv");
  const Index size = std::min(item.max_size, matches.source.cols());
  return {matches.source.leftCols(size), matches.target.leftCols(size),
          read_transform(item.folder / "T_target_source.txt"), item.noise_bound};
}

void add_case(Cases& cases, const RealMatches& item, Scale scale, const Variant& variant) {
  const std::string size = item.max_size == kAll ? "all" : fmt::format("{}", item.max_size);
  const std::string name = fmt::format("{}/{}/{}/{}/{}", item.set, name_of(scale), variant.name,
                                       item.folder.filename().string(), size);
  cases.push_back(
      {item.set, name, [=](Digest& digest, int num_threads) {
         const Problem problem = load(item);
         add(digest, register_correspondences(problem.source, problem.target,
                                              options_for(problem, scale, variant, num_threads)));
       }});
}

void add_parts(Cases& cases, const RealMatches& item) {
  const RealMatches part{item.set + "-part", item.folder, item.noise_bound, 300};
  for (const Variant& variant : all_variants()) add_case(cases, part, Scale::Known, variant);
  const RealMatches small{item.set + "-part", item.folder, item.noise_bound, 60};
  for (const Variant& variant : variants_named({"gmcr", "count", "paper", "gravity"})) {
    add_case(cases, small, Scale::Free, variant);
  }
}

void add_kitti(Cases& cases, const std::filesystem::path& root) {
  for (const auto& folder : pairs_of_set(root, "kitti_fpfh")) {
    const RealMatches item{"kitti", folder, kKittiBound};
    for (const Variant& variant : variants_named({"gmcr", "count", "gravity"})) {
      add_case(cases, item, Scale::Known, variant);
    }
    add_parts(cases, item);
  }
}

void add_gore(Cases& cases, const std::filesystem::path& root) {
  for (const auto& folder : pairs_of_set(root, "gore")) {
    const auto resolution = listed_resolution(root, "gore", folder.filename().string());
    if (!resolution) continue;
    const RealMatches item{"gore", folder, 2 * *resolution};
    for (const Variant& variant : variants_named({"gmcr", "count", "gravity"})) {
      add_case(cases, item, Scale::Known, variant);
    }
    add_parts(cases, item);
  }
}

void add_cloud_pairs(Cases& cases, const std::filesystem::path& root, const std::string& set,
                     std::size_t max_pairs) {
  auto folders = pairs_of_set(root, set);
  folders.resize(std::min(folders.size(), max_pairs));
  for (const auto& folder : folders) {
    const std::string name = fmt::format("real-clouds/{}/{}", set, folder.filename().string());
    cases.push_back({"real-clouds", name, [=](Digest& digest, int num_threads) {
                       add(digest, register_clouds(read_cloud(folder / "source.ply").points,
                                                   read_cloud(folder / "target.ply").points, {},
                                                   cloud_options(Scale::Known, 1, num_threads)));
                     }});
  }
}

}  // namespace

void add_real(Cases& cases) {
  const auto root = data_root();
  add_kitti(cases, root);
  add_gore(cases, root);
  add_cloud_pairs(cases, root, "gore", 6);
  add_cloud_pairs(cases, root, "mian_views", 1);
}

}  // namespace gmcr::bench
