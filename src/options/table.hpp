#pragma once

#include "gmcr/clique.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/priors.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/synthetic.hpp"
#include "options/option.hpp"

/// The one table of options. `validate` and its messages, the flags of the tool and their help, the
/// options in JSON, and the fields and keywords of Python with their docstrings are made from it;
/// defaults are those of the structs.
namespace gmcr::options {

template <>
struct Table<GravityPrior> : TableDefaults {
  static constexpr std::tuple options{
      Option{&GravityPrior::source,
             {.name = "source", .help = "Direction in the source frame", .range = kDirection}},
      Option{&GravityPrior::target,
             {.name = "target", .help = "Direction in the target frame", .range = kDirection}},
      Option{&GravityPrior::max_tilt,
             {.name = "max_tilt",
              .help = "Largest angle between the two directions after the transform",
              .unit = "radians",
              .group = "Priors",
              .range = kAngle,
              .alias = "max-tilt"}}};
};

template <>
struct Table<InitialPose> : TableDefaults {
  static constexpr std::tuple options{
      Option{&InitialPose::target_from_source,
             {.name = "target_from_source", .help = "The pose, whose scale is not used"}},
      Option{&InitialPose::max_rotation,
             {.name = "max_rotation",
              .help = "Largest angle from the rotation of the initial pose",
              .unit = "radians",
              .group = "Priors",
              .range = kAngle,
              .alias = "max-rotation-error"}},
      Option{&InitialPose::max_translation,
             {.name = "max_translation",
              .help = "Largest distance from the translation of the initial pose",
              .unit = "metres",
              .group = "Priors",
              .range = kReachOrNone,
              .alias = "max-translation-error"}}};
};

template <>
struct Table<Options> : TableDefaults {
  static constexpr std::tuple options{
      Option{&Options::noise_mode,
             {.name = "noise_mode",
              .help = "Whether the noise is 'given', or 'estimated': one bound for all is chosen "
                      "from the data",
              .group = "Noise"}},
      Option{&Options::noise_bound,
             {.name = "noise_bound",
              .help = "Largest error of a right match, in [1e-50, 1e50]; needed where the noise is "
                      "given, unless "
                      "each match has a bound of its own",
              .unit = "metres",
              .group = "Noise"}},
      Option{&Options::noise_bounds,
             {.name = "noise_bounds",
              .help = "One bound for each match, instead of noise_bound",
              .unit = "metres",
              .group = "Noise",
              .range = kMagnitude}},
      Option{&Options::scale_mode,
             {.name = "scale_mode",
              .help = "Whether the scale is 'known' or 'estimated'",
              .group = "Scale"}},
      Option{&Options::scale,
             {.name = "scale",
              .help = "Known scale, target / source",
              .group = "Scale",
              .range = kMagnitude}},
      Option{&Options::scale_range,
             {.name = "scale_range",
              .help = "Smallest and largest scale to search where it is estimated; from the data "
                      "where not given",
              .group = "Scale"}},
      Option{&Options::method,
             {.name = "method",
              .help = "'gmcr', many candidates with a certificate, or 'paper', the stages of the "
                      "paper",
              .group = "Search"}},
      Option{&Options::evidence,
             {.name = "evidence",
              .help = "What is maximised: 'distinct' evidence, for which matches that say the same "
                      "share one vote, or the 'count' of inliers",
              .group = "Search"}},
      Option{&Options::gravity,
             {.name = "gravity",
              .help = "Direction of gravity, or of another known axis, in both frames",
              .group = "Priors"}},
      Option{
          &Options::initial_pose,
          {.name = "initial_pose", .help = "Pose that the transform is near", .group = "Priors"}},
      Option{&Options::max_translation,
             {.name = "max_translation",
              .help = "Longest translation",
              .unit = "metres",
              .group = "Priors",
              .range = kReach}},
      Option{&Options::one_to_one,
             {.name = "one_to_one",
              .help = "Search for poses with at most one inlier of those that share a point",
              .group = "Search"}},
      Option{&Options::num_hypotheses,
             {.name = "num_hypotheses",
              .help = "Poses to return: the best and its alternatives",
              .group = "Answers",
              .range = kOneOrMore,
              .alias = "hypotheses"}},
      Option{&Options::certify,
             {.name = "certify",
              .help = "Spend what is left of the time limit on proving that no pose is better",
              .group = "Answers"}},
      Option{&Options::num_threads,
             {.name = "num_threads",
              .help = "Threads, which do not change the result; 0 uses every core",
              .group = "Limits",
              .range = kThreads,
              .alias = "threads"}},
      Option{&Options::time_limit,
             {.name = "time_limit",
              .help = "Wall time for the search",
              .unit = "seconds",
              .group = "Limits",
              .range = kAboveZero}},
      Option{&Options::memory_limit,
             {.name = "memory_limit",
              .help = "Memory for graphs",
              .unit = "bytes",
              .group = "Limits",
              .range = kAboveZero}},
      Option{&Options::progress,
             {.name = "progress",
              .help = "Called now and then as progress(stage, fraction); False stops the search, "
                      "which then ends as if its time were up"}}};

  static constexpr Gone gone[] = {{"threshold", "divide noise_bound by it"}};

  static bool is_used(const Options& values, const std::string& name) {
    const bool one_bound = values.noise_mode == NoiseMode::Given && values.noise_bounds.empty();
    if (name == "noise_bound") return one_bound;
    if (name == "scale") return values.scale_mode == ScaleMode::Known;
    return true;
  }
};

template <>
struct Table<InstanceOptions> : TableDefaults {
  static constexpr std::tuple options{
      Option{&InstanceOptions::max_instances,
             {.name = "max_instances",
              .help = "Instances of the source to find in the target, best first",
              .group = "Answers",
              .range = kOneOrMore,
              .alias = "instances"}},
      Option{&InstanceOptions::min_instance_inliers,
             {.name = "min_instance_inliers",
              .help = "Inliers that an instance needs",
              .group = "Answers",
              .range = kThreeOrMore}},
      Option{&InstanceOptions::min_instance_share,
             {.name = "min_instance_share",
              .help = "Share of the evidence of the first instance that another needs",
              .group = "Answers",
              .range = kShare}}};

  static constexpr Gone gone[] = {{"min_inliers", "it is called min_instance_inliers"},
                                  {"min_share", "it is called min_instance_share"}};
};

template <>
struct Table<FrontendOptions> : TableDefaults {
  static constexpr std::tuple options{
      Option{&FrontendOptions::voxel_size,
             {.name = "voxel_size",
              .help = "Edge of a voxel of the target; 0: from the clouds",
              .unit = "metres",
              .group = "Matching",
              .range = kNotNegative,
              .alias = "voxel"}},
      Option{&FrontendOptions::source_voxel_size,
             {.name = "source_voxel_size",
              .help = "Edge of a voxel of the source, where its scale differs; 0: derived",
              .unit = "metres",
              .group = "Matching",
              .range = kNotNegative,
              .alias = "source-voxel"}},
      Option{&FrontendOptions::normal_radius,
             {.name = "normal_radius",
              .help = "Radius for normals",
              .unit = "voxels",
              .group = "Matching",
              .range = kPositive}},
      Option{&FrontendOptions::feature_radius,
             {.name = "feature_radius",
              .help = "Radius for FPFH, at least normal_radius",
              .unit = "voxels",
              .group = "Matching",
              .range = kPositive}},
      Option{&FrontendOptions::noise_bound_voxels,
             {.name = "noise_bound_voxels",
              .help = "Noise bound for the registration where noise_bound is 0",
              .unit = "voxels",
              .group = "Matching",
              .range = kPositive}},
      Option{&FrontendOptions::orientation,
             {.name = "orientation",
              .help = "Where normals point: 'toward_viewpoint', 'outward', or 'automatic', which "
                      "tries these",
              .group = "Matching"}},
      Option{&FrontendOptions::source_viewpoint,
             {.name = "source_viewpoint",
              .help = "Sensor position, source frame",
              .unit = "metres",
              .group = "Matching",
              .range = kFinite}},
      Option{&FrontendOptions::target_viewpoint,
             {.name = "target_viewpoint",
              .help = "Sensor position, target frame",
              .unit = "metres",
              .group = "Matching",
              .range = kFinite}},
      Option{&FrontendOptions::mutual,
             {.name = "mutual",
              .help = "Keep a match only where it is the best both ways",
              .group = "Matching"}},
      Option{&FrontendOptions::max_ratio,
             {.name = "max_ratio",
              .help = "Largest feature distance over that of the second best",
              .group = "Matching",
              .range = kRatio}},
      Option{&FrontendOptions::max_attempts,
             {.name = "max_attempts",
              .help = "Settings to try before settling for a doubtful result",
              .group = "Matching",
              .range = kOneOrMore,
              .alias = "attempts"}},
      Option{&FrontendOptions::refine,
             {.name = "refine",
              .help = "Refinement of the pose: 'icp', by the surfaces of the clouds, or 'none'",
              .group = "Answers"}}};

  static constexpr Gone gone[] = {{"one_to_one", "it is one of Options"}};
};

template <>
struct Table<CliqueOptions> : TableDefaults {
  static constexpr std::tuple options{
      Option{&CliqueOptions::time_limit,
             {.name = "time_limit",
              .help = "Wall time for the search",
              .unit = "seconds",
              .range = kZeroOrMore}},
      Option{&CliqueOptions::max_nodes,
             {.name = "max_nodes", .help = "Search nodes to visit, never exceeded"}},
      Option{&CliqueOptions::max_work,
             {.name = "max_work", .help = "Word operations, about; 2**30 take about a second"}},
      Option{&CliqueOptions::initial_clique,
             {.name = "initial_clique", .help = "Known clique to start from; may be empty"}},
      Option{&CliqueOptions::must_exceed,
             {.name = "must_exceed",
              .help = "Report only a clique with more vertices than this; 0 reports any",
              .range = kZeroOrMore}},
      Option{&CliqueOptions::num_threads,
             {.name = "num_threads",
              .help = "Threads, which do not change the result; 0 uses every core",
              .range = kThreads,
              .alias = "threads"}},
      Option{&CliqueOptions::max_memory,
             {.name = "max_memory", .help = "Memory for copies of the graph", .unit = "bytes"}}};
};

template <>
struct Table<WeightedCliqueOptions> : TableDefaults {
  static constexpr std::tuple options{
      Option{&WeightedCliqueOptions::time_limit,
             {.name = "time_limit",
              .help = "Wall time for the search",
              .unit = "seconds",
              .range = kZeroOrMore}},
      Option{&WeightedCliqueOptions::max_nodes,
             {.name = "max_nodes", .help = "Search nodes to visit"}},
      Option{&WeightedCliqueOptions::max_work,
             {.name = "max_work", .help = "Word operations, about; 2**30 take about a second"}},
      Option{&WeightedCliqueOptions::max_memory,
             {.name = "max_memory", .help = "Memory for copies of the graph", .unit = "bytes"}},
      Option{&WeightedCliqueOptions::must_exceed,
             {.name = "must_exceed",
              .help = "Report only a clique that weighs more than this; 0 reports any",
              .range = kZeroOrMore}},
      Option{&WeightedCliqueOptions::num_threads,
             {.name = "num_threads",
              .help = "Threads, which do not change the result; 0 uses every core",
              .range = kThreads,
              .alias = "threads"}}};
};

template <>
struct Table<SyntheticOptions> : TableDefaults {
  static constexpr std::tuple options{
      Option{&SyntheticOptions::kind,
             {.name = "kind", .help = "Protocol: 'ball', 'random' or 'structured'"}},
      Option{
          &SyntheticOptions::num_correspondences,
          {.name = "num_correspondences", .help = "Matches", .range = kZeroOrMore, .alias = "num"}},
      Option{&SyntheticOptions::outlier_rate,
             {.name = "outlier_rate",
              .help = "Share of wrong matches",
              .range = kShare,
              .alias = "outliers"}},
      Option{&SyntheticOptions::seed, {.name = "seed", .help = "Same seed, same problem"}},
      Option{&SyntheticOptions::noise_shape,
             {.name = "noise_shape", .help = "Noise of an inlier: 'ball', 'gaussian' or 'cube'"}},
      Option{&SyntheticOptions::noise_extent,
             {.name = "noise_extent",
              .help = "Extent of the noise: radius of the ball, three standard deviations, or half "
                      "an edge",
              .unit = "metres",
              .range = kNotNegative,
              .alias = "noise"}},
      Option{&SyntheticOptions::noise_bound,
             {.name = "noise_bound",
              .help = "Bound of the error of every inlier, at least the largest noise",
              .unit = "metres",
              .range = kPositive}},
      Option{&SyntheticOptions::scale_range,
             {.name = "scale_range", .help = "Smallest and largest scale to draw"}},
      Option{&SyntheticOptions::max_translation,
             {.name = "max_translation",
              .help = "Largest shift an axis",
              .unit = "metres",
              .range = kNotNegative}},
      Option{&SyntheticOptions::num_cloud_points,
             {.name = "num_cloud_points",
              .help = "Points of the source cloud ('random', 'structured')"}},
      Option{&SyntheticOptions::num_sphere_points,
             {.name = "num_sphere_points",
              .help = "Points without a partner, on the sphere around the target",
              .range = kZeroOrMore}},
      Option{&SyntheticOptions::num_bases,
             {.name = "num_bases",
              .help = "Clusters of outliers ('structured'); 0: from the outlier rate",
              .range = kZeroOrMore}},
      Option{&SyntheticOptions::source_neighbours,
             {.name = "source_neighbours",
              .help = "A cluster's sources: the base and its nearest points",
              .range = kZeroOrMore}},
      Option{&SyntheticOptions::target_neighbours,
             {.name = "target_neighbours",
              .help = "A cluster's targets, at least source_neighbours",
              .range = kZeroOrMore}},
      Option{
          &SyntheticOptions::association_neighbours,
          {.name = "association_neighbours",
           .help = "An inlier's target is one of that many points near the true one; 0: the true "
                   "one",
           .range = kZeroOrMore}}};
};

}  // namespace gmcr::options
