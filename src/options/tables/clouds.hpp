#pragma once

#include "gmcr/frontend.hpp"
#include "options/option.hpp"

namespace gmcr::options {

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

}  // namespace gmcr::options
