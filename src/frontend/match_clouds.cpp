#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "frontend/cloud_pair.hpp"
#include "frontend/judgement/judged_pose.hpp"
#include "frontend/matching/feature_matching.hpp"
#include "gmcr/registration.hpp"
#include "parallel/deadline.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace {

/// Share of the time that is left that may go to the search for nearest features: the rest is for
/// the pose.
constexpr double kMatchingShare = 0.6;

struct VoxelSizes {
  double source;
  double target;
};

/// Sizes as given, and from the clouds where not.
VoxelSizes choose_voxel_sizes(frontend::CloudScales& source, frontend::CloudScales& target,
                              const FrontendOptions& frontend, const Options& options) {
  VoxelSizes sizes{frontend.source_voxel_size, frontend.voxel_size};
  if (options.scale_mode == ScaleMode::Estimated) {
    if (sizes.source == 0) sizes.source = source.voxel_size();
    if (sizes.target == 0) sizes.target = target.voxel_size();
    return sizes;
  }
  if (sizes.target == 0 && sizes.source > 0) sizes.target = sizes.source * options.scale;
  if (sizes.target == 0) {
    double from = 0, to = 0;
    parallel::call_both(
        options.num_threads, [&] { from = source.voxel_size(); },
        [&] { to = target.voxel_size(); });
    sizes.target = std::min(from * options.scale, to);
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

/// Features of the second radius that is pooled over the first.
constexpr double kWiderFeatures = 1.4;

/// Whether matches may be pooled: they are mutual ones of all with all, of which a point may have
/// several.
bool may_pool(const FrontendOptions& frontend, const Options& options) {
  return frontend.mutual && frontend.max_ratio == 1 && !options.one_to_one &&
         !frontend::MatchPriors::say_something(options);
}

/// A cloud with its features at one scale.
struct DescribedCloud {
  const frontend::Surface& surface;
  const frontend::Features& features;
};

DescribedCloud described(frontend::CloudScales& cloud, NormalOrientation side, double voxel_size,
                         const FrontendOptions& frontend, const Eigen::Vector3d& viewpoint,
                         const Options& options, frontend::StageClock& clock) {
  const int threads = options.num_threads;
  const frontend::Surface& surface = cloud.surface(voxel_size, frontend, threads, clock);
  return {surface, cloud.features(surface, side, viewpoint, threads, clock)};
}

/// Matches at one scale, of those that the priors admit.
frontend::FeatureMatches match_at_one_scale(const DescribedCloud& from, const DescribedCloud& to,
                                            const frontend::FrontendSetting& setting,
                                            const FrontendOptions& frontend, const Options& options,
                                            double noise_bound,
                                            const parallel::Deadline& deadline) {
  frontend::MatchingOptions matching{frontend.mutual, static_cast<float>(frontend.max_ratio),
                                     options.num_threads, options.one_to_one, deadline};
  if (!frontend::MatchPriors::say_something(options)) {
    return frontend::match_features(from.features, to.features, matching);
  }
  const Points source_normals =
      frontend::oriented_normals(from.surface, setting.source_side, frontend.source_viewpoint);
  const Points target_normals =
      frontend::oriented_normals(to.surface, setting.target_side, frontend.target_viewpoint);
  const frontend::MatchPriors priors({from.surface.voxels, source_normals},
                                     {to.surface.voxels, target_normals}, options, noise_bound);
  matching.priors = &priors;
  return frontend::match_features(from.features, to.features, matching);
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
                                  const FrontendOptions& frontend, const Options& options,
                                  const frontend::FrontendSetting& setting) {
  const parallel::Deadline deadline(options.time_limit, options.stop);
  CloudMatches matches;
  matches.filtered = frontend.mutual || frontend.max_ratio < 1;
  frontend::StageClock clock(matches.stages);
  const VoxelSizes sizes = choose_voxel_sizes(source, target, frontend, options);
  matches.source_voxel_size = setting.voxel_factor * sizes.source;
  matches.target_voxel_size = setting.voxel_factor * sizes.target;
  matches.noise_bound = options.noise_bound > 0
                            ? options.noise_bound
                            : frontend.noise_bound_voxels * matches.target_voxel_size;
  const bool pools = setting.pools_radii && may_pool(frontend, options);
  std::vector<FeatureMatch> pairs;
  for (const double factor : {1.0, kWiderFeatures}) {
    FrontendOptions scaled = frontend;
    scaled.feature_radius *= factor;
    scaled.normal_radius =
        std::min(setting.normal_factor * frontend.normal_radius, frontend.feature_radius);
    std::optional<DescribedCloud> from_cloud, to_cloud;
    std::vector<StageTime> from_stages, to_stages;
    parallel::call_both(
        options.num_threads,
        [&] {
          frontend::StageClock own(from_stages);
          from_cloud.emplace(described(source, setting.source_side, matches.source_voxel_size,
                                       scaled, scaled.source_viewpoint, options, own));
        },
        [&] {
          frontend::StageClock own(to_stages);
          to_cloud.emplace(described(target, setting.target_side, matches.target_voxel_size, scaled,
                                     scaled.target_viewpoint, options, own));
        });
    clock.lap({from_stages, to_stages});
    const DescribedCloud &from = *from_cloud, &to = *to_cloud;
    if (pairs.empty()) {
      matches.source_voxels = from.surface.voxels;
      matches.target_voxels = to.surface.voxels;
    }
    const FeatureMatches found =
        match_at_one_scale(from, to, setting, frontend, options, matches.noise_bound,
                           deadline.within(kMatchingShare * deadline.remaining()));
    matches.share_compared = std::min(matches.share_compared, found.share_compared);
    pairs = pooled(std::move(pairs), found.pairs);
    clock.lap("matching");
    if (!pools) break;
    matches.num_radii = 2;
  }
  for (const FeatureMatch& pair : pairs) {
    matches.source_indices.push_back(pair.source);
    matches.target_indices.push_back(pair.target);
  }
  matches.source = matches.source_voxels(Eigen::all, matches.source_indices);
  matches.target = matches.target_voxels(Eigen::all, matches.target_indices);
  return matches;
}

Result frontend::register_matches(CloudMatches& matches, const Options& options) {
  if (options.noise_mode == NoiseMode::Given) {
    return register_correspondences(matches.source, matches.target,
                                    options_with_bound(options, matches));
  }
  Result result = register_correspondences(matches.source, matches.target, options);
  if (result.noise_estimate) matches.noise_bound = result.noise_estimate->noise_bound;
  return result;
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
