#include <algorithm>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "frontend/cloud_pair.hpp"
#include "frontend/matching/feature_matching.hpp"
#include "parallel/deadline.hpp"

namespace gmcr {
namespace {

/// Share of the time that is left that may go to the search for nearest features: the rest is for
/// the pose.
constexpr double kMatchingShare = 0.6;

struct VoxelSizes {
  double source;
  double target;
};

/// A grid that leaves more than this share of the points apart is finer than their spacing.
constexpr double kSparseShare = 0.7;

/// Smallest of `voxel_size` times 1, sqrt(2), 2 and so on that merges points of a sparse cloud.
double coarsen_to_spacing(const PointsRef& points, double voxel_size) {
  constexpr int kMostSteps = 6;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto num_voxels = static_cast<double>(voxel_grid(points, voxel_size).cols());
    if (num_voxels <= kSparseShare * static_cast<double>(points.cols())) break;
    voxel_size *= std::numbers::sqrt2;
  }
  return voxel_size;
}

/// Sizes as given, and from the clouds where not.
/// @param coarsen  no chosen size is below the spacing of the points.
VoxelSizes choose_voxel_sizes(frontend::CloudScales& source, frontend::CloudScales& target,
                              const FrontendOptions& frontend, const Options& options,
                              bool coarsen) {
  const auto fit_spacing = [&](const frontend::CloudScales& cloud, double size) {
    return coarsen ? coarsen_to_spacing(cloud.points(), size) : size;
  };
  VoxelSizes sizes{frontend.source_voxel_size, frontend.voxel_size};
  if (options.scale_mode == ScaleMode::Estimated) {
    if (sizes.source == 0) sizes.source = fit_spacing(source, source.voxel_size());
    if (sizes.target == 0) sizes.target = fit_spacing(target, target.voxel_size());
    return sizes;
  }
  if (sizes.target == 0 && sizes.source > 0) sizes.target = sizes.source * options.scale;
  if (sizes.target == 0) {
    const double size = std::min(source.voxel_size() * options.scale, target.voxel_size());
    sizes.target = std::max(fit_spacing(source, size / options.scale) * options.scale,
                            fit_spacing(target, size));
  }
  if (sizes.source == 0) sizes.source = sizes.target / options.scale;
  return sizes;
}

void require_finite(const PointsRef& points, const char* name) {
  for (Index i = 0; i < points.cols(); ++i) {
    if (points.col(i).allFinite()) continue;
    throw std::invalid_argument(std::string(name) + ": point " + std::to_string(i) +
                                " is not finite");
  }
}

}  // namespace

void frontend::validate_pair(const PointsRef& source, const PointsRef& target,
                             const FrontendOptions& frontend, const Options& options) {
  frontend.validate();
  Options checked = options;
  const bool given = checked.noise_mode == NoiseMode::Given;
  if (given && checked.noise_bound == 0) checked.noise_bound = 1;  // 0 asks for the derived one
  checked.validate();
  require_finite(source, "source");
  require_finite(target, "target");
}

CloudMatches frontend::match_with(CloudScales& source, CloudScales& target,
                                  const FrontendOptions& asked, const Options& options,
                                  const frontend::FrontendSetting& setting) {
  const parallel::Deadline deadline(options.time_limit, options.stop);
  FrontendOptions frontend = asked;
  frontend.feature_radius *= setting.feature_radius_factor;
  if (setting.keep_all_matches) {
    frontend.mutual = false;
    frontend.max_ratio = 1;
  }
  CloudMatches matches;
  matches.filtered = frontend.mutual || frontend.max_ratio < 1;
  frontend::StageClock clock(matches.stages);
  const VoxelSizes sizes =
      choose_voxel_sizes(source, target, frontend, options, setting.keep_all_matches);
  matches.source_voxel_size = setting.voxel_factor * sizes.source;
  matches.target_voxel_size = setting.voxel_factor * sizes.target;
  matches.noise_bound = options.noise_bound > 0
                            ? options.noise_bound
                            : frontend.noise_bound_voxels * matches.target_voxel_size;

  const int threads = options.num_threads;
  const Surface& from = source.surface(matches.source_voxel_size, frontend, threads, clock);
  const Surface& to = target.surface(matches.target_voxel_size, frontend, threads, clock);
  const Features& source_features =
      source.features(from, setting.source_side, frontend.source_viewpoint, threads, clock);
  const Features& target_features =
      target.features(to, setting.target_side, frontend.target_viewpoint, threads, clock);
  frontend::MatchingOptions matching{frontend.mutual, static_cast<float>(frontend.max_ratio),
                                     threads, options.one_to_one,
                                     deadline.within(kMatchingShare * deadline.remaining())};
  Points source_normals, target_normals;
  std::optional<MatchPriors> priors;
  if (MatchPriors::say_something(options)) {
    source_normals = oriented_normals(from, setting.source_side, frontend.source_viewpoint);
    target_normals = oriented_normals(to, setting.target_side, frontend.target_viewpoint);
    priors.emplace(OrientedPoints{from.voxels, source_normals},
                   OrientedPoints{to.voxels, target_normals}, options, matches.noise_bound);
    matching.priors = &*priors;
  }
  const auto found = frontend::match_features(source_features, target_features, matching);
  matches.share_compared = found.share_compared;
  for (const frontend::FeatureMatch& pair : found.pairs) {
    matches.source_indices.push_back(pair.source);
    matches.target_indices.push_back(pair.target);
  }
  matches.source = from.voxels(Eigen::all, matches.source_indices);
  matches.target = to.voxels(Eigen::all, matches.target_indices);
  matches.source_voxels = from.voxels;
  matches.target_voxels = to.voxels;
  clock.lap("matching");
  return matches;
}

CloudMatches frontend::match_scales(CloudScales& source, CloudScales& target,
                                    const FrontendOptions& frontend, const Options& options) {
  return match_with(source, target, frontend, options,
                    list_settings(frontend, {source.points(), target.points()}).front());
}

CloudMatches match_clouds(const PointsRef& source, const PointsRef& target,
                          const FrontendOptions& frontend, const Options& options) {
  frontend::validate_pair(source, target, frontend, options);
  frontend::CloudScales from(source), to(target);
  return frontend::match_scales(from, to, frontend, options);
}

}  // namespace gmcr
