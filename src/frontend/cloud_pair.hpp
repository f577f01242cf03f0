#pragma once

#include "frontend/features/cloud_scales.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// One way to run the front end.
struct FrontendSetting {
  double voxel_factor = 1;  ///< of the voxel size that was asked for or chosen
  NormalOrientation source_side = NormalOrientation::TowardViewpoint;
  NormalOrientation target_side = NormalOrientation::TowardViewpoint;
  double normal_factor = 1;   ///< of the normal radius, which stays within the feature radius
  bool pools_radii = false;   ///< matches at a wider feature radius too
  bool turns_source = false;  ///< all around, as an object that the target shows

  bool operator==(const FrontendSetting&) const = default;
};

/// The two clouds of a caller.
struct Clouds {
  const PointsRef& source;
  const PointsRef& target;
};

/// Whether `viewpoint` is the origin, which nobody named, and the cloud lies far from it and is no
/// view from there: then where the sensor was is unknown.
bool is_viewpoint_unknown(const PointsRef& points, const Eigen::Vector3d& viewpoint);

/// The settings that `frontend` allows, most promising first, each once; at least one. Where the
/// orientation is automatic, a cloud whose viewpoint is unknown has its normals outward.
std::vector<FrontendSetting> list_settings(const FrontendOptions& frontend, const Clouds& clouds);

/// @throws std::invalid_argument where the clouds or the options break the contract of
///   `match_clouds`.
void validate_pair(const PointsRef& source, const PointsRef& target,
                   const FrontendOptions& frontend, const Options& options);

/// `match_clouds` with one setting and arguments that were validated.
CloudMatches match_with(CloudScales& source, CloudScales& target, const FrontendOptions& frontend,
                        const Options& options, const FrontendSetting& setting);

/// Registers the matches, with the bound that they come with or one from the matches themselves,
/// which then is theirs.
Result register_matches(CloudMatches& matches, const Options& options);

/// `match_clouds` of arguments that were validated.
CloudMatches match_scales(CloudScales& source, CloudScales& target, const FrontendOptions& frontend,
                          const Options& options);

/// `register_clouds` of arguments that were validated, of clouds in which no point is repeated
/// much.
CloudResult register_scales(CloudScales& source, CloudScales& target,
                            const FrontendOptions& frontend, const Options& options);

/// @throws InvalidOption where `Options::noise_bounds` are given: the matches are not known yet.
void refuse_noise_bounds(const Options& options);

}  // namespace gmcr::frontend
