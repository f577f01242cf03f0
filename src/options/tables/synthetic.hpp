#pragma once

#include "gmcr/synthetic.hpp"
#include "options/option.hpp"

namespace gmcr::options {

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
