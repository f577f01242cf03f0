#pragma once

#include "gmcr/options.hpp"
#include "gmcr/priors.hpp"
#include "gmcr/registration.hpp"
#include "options/option.hpp"

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

}  // namespace gmcr::options
