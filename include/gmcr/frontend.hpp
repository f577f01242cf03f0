#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/result.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Which side of the surface the normals point to. FPFH sees the difference between the sides, so
/// the two clouds have to agree.
enum class NormalOrientation {
  Automatic,        ///< `TowardViewpoint` first; the others follow while the result is not trusted
  TowardViewpoint,  ///< toward `FrontendOptions::source_viewpoint` and `target_viewpoint`
  Outward,          ///< away from the centroid of the cloud: for models of whole objects
};

/// What makes the pose of two clouds finer than the matches do.
enum class Refine {
  Icp,   ///< the surfaces themselves: generalised ICP with a robust kernel, from coarse to fine
  None,  ///< nothing: the pose is the likeliest one by the matches
};

/// How clouds become correspondences. None of the names is one of `Options` or `InstanceOptions`,
/// so that a tool can take them all side by side. Lengths are in voxels, so that one set of
/// defaults serves objects and cities.
struct FrontendOptions {
  /// Edge of a voxel, metres of the target frame, >= 0; 0 chooses it from the clouds.
  double voxel_size = 0;
  /// Edge of a voxel, metres of the source frame, >= 0; 0 derives it from the target's and the
  /// known scale, or from the source's own extent where the scale is estimated; `register_clouds`
  /// then from the scale that a first matching gives.
  double source_voxel_size = 0;
  double normal_radius = 2;   ///< voxels, > 0
  double feature_radius = 5;  ///< voxels, >= normal_radius
  /// Noise bound for the registration, voxels of the target, > 0; used where
  /// `Options::noise_bound` is 0.
  double noise_bound_voxels = 1.5;

  NormalOrientation orientation = NormalOrientation::Automatic;  ///< sides of the normals
  /// Where the sensor was, metres, source frame. With the automatic orientation the origin is taken
  /// for it only where it lies within five extents of the cloud.
  Eigen::Vector3d source_viewpoint = Eigen::Vector3d::Zero();
  Eigen::Vector3d target_viewpoint = Eigen::Vector3d::Zero();  ///< metres, target frame

  /// Keep a match only where each point is the other's nearest in feature space.
  bool mutual = true;
  /// Keep a match only where its feature distance is at most this share of the distance to the
  /// second best, in (0, 1]; 1 keeps all.
  double max_ratio = 1;

  /// Settings that `register_clouds` may try before it settles for the best result, >= 1. The first
  /// is the one above; the others take normals from 1.5 times the radius, change voxel size and
  /// sides of the normals, pool the matches of two feature radii and, for a small object, turn it
  /// all around.
  int max_attempts = 8;

  /// Refinement of the pose of every attempt, and more finely of the one that is returned.
  Refine refine = Refine::Icp;

  /// @throws InvalidOption naming option and value.
  void validate() const;
};

/// Putative correspondences between two clouds.
struct CloudMatches {
  Points source;                      ///< 3 x M, matched points of the source, metres
  Points target;                      ///< 3 x M, matched points of the target, metres
  std::vector<Index> source_indices;  ///< M columns of `source_voxels`, ascending
  std::vector<Index> target_indices;  ///< M columns of `target_voxels`
  Points source_voxels;               ///< the source after the voxel grid
  Points target_voxels;               ///< the target after the voxel grid
  double source_voxel_size = 0;       ///< metres, source frame
  double target_voxel_size = 0;       ///< metres, target frame
  double noise_bound = 0;             ///< metres, target frame, for the registration
  /// Whether the mutual and the ratio test were applied; without them the number of matches that
  /// agree proves little.
  bool filtered = true;
  /// Feature radii whose matches were pooled: a point may have one of each.
  int num_radii = 1;
  /// Share of the source whose matches were sought before the time for it was up, in [0, 1].
  double share_compared = 1;
  std::vector<StageTime> stages;  ///< "voxel", "normals", "features", "matching"
};

/// What the refinement did to the pose of two clouds.
struct Refinement {
  std::string method = "none";  ///< the word of `FrontendOptions::refine`
  bool is_applied = false;      ///< whether the pose is the refined one
  std::string note = "none";    ///< one sentence
  /// Standard deviation of the distance of the surfaces that meet, along their normals, metres,
  /// target frame; 0 where the pose was not refined.
  double noise = 0;
};

/// A small motion of the source that the surfaces hardly resist.
struct WeakDirection {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();   ///< unit axis, target frame; 0: no turn
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< unit, target frame; 0 where it is a turn
  /// Mean square of the motion along the normals over that of the motion, in [0, 1].
  double stiffness = 0;
};

/// How the surfaces of two clouds meet under a pose, by the normals of their voxels.
struct SurfaceFit {
  double source_share = 0;  ///< of the source that the target covers, with its normals, in [0, 1]
  double target_share = 0;  ///< of the target that the source covers, with its normals
  double agreement = 0;     ///< share of the voxels that meet whose normals are within 26 degrees
  double noise = 0;         ///< standard deviation of the distance along the normals, metres
  std::vector<WeakDirection> weak_directions;  ///< what the surfaces leave open, weakest first
  /// Share of a cloud that lies where the other sensor saw through; 0 where no viewpoint is known,
  /// and without refinement.
  double contradicted = 0;

  /// Sum of the two shares: of two poses on the same voxels the better one has more.
  double overlap() const { return source_share + target_share; }
};

/// Another pose of the surfaces that was looked at, refined alike.
struct RivalPose {
  Similarity target_from_source;  ///< refined like the pose that is returned
  double overlap = 0;  ///< over that of the pose that is returned: near 1, the surfaces fit as well
  bool is_symmetry = false;  ///< the source lies where it lies at the pose that is returned
};

/// The voxels by which all poses of two clouds are judged: those of the first attempt.
struct JudgedVoxels {
  Points source;                 ///< 3 x P, metres
  Points target;                 ///< 3 x Q, metres
  double source_voxel_size = 0;  ///< metres, source frame
  double target_voxel_size = 0;  ///< metres, target frame
  /// Where the sensor of the source was, metres, where the source may be a view from there.
  std::optional<Eigen::Vector3d> source_viewpoint;
  std::optional<Eigen::Vector3d> target_viewpoint;  ///< the same of the target
};

/// What a registration of two clouds found.
struct CloudResult {
  /// Pose and inliers; `inliers` index the columns of `matches.source`. Its diagnostics hold the
  /// stages of the front end too, summed over the attempts.
  Result registration;
  CloudMatches matches;         ///< those that the pose comes from, of the attempt that won
  Index num_source_points = 0;  ///< as given; `matches` holds the clouds after the voxel grid
  Index num_target_points = 0;  ///< as given
  JudgedVoxels voxels;          ///< of the surfaces, whatever voxels the matches are of
  /// Share of `voxels.source` with a point of `voxels.target` within one voxel of the target after
  /// the transform, in [0, 1]; 0 without a pose.
  double fitness = 0;
  /// Distinct evidence of the inliers, whatever was maximised: what the verdict goes by.
  double distinct_evidence = 0;
  double overlap_rmse = 0;  ///< RMS distance of those points, metres
  /// The same share the other way round: of `voxels.target` near the transformed source.
  double target_fitness = 0;
  /// What the surfaces and the matches say of the pose; that of `registration` speaks of the
  /// matches alone.
  Verdict verdict = Verdict::Untrusted;
  std::string verdict_reason;  ///< one sentence
  int num_attempts = 0;        ///< front-end settings that were tried
  Refinement refinement;       ///< what the alignment of the surfaces did
  SurfaceFit surfaces;         ///< of the pose
  /// Whether the mirrored source was tried alike and is worse, so that the surfaces lie apart by
  /// the noise of the sensor, not because one of the clouds is left-handed: where it was matched,
  /// it has clearly less evidence; where it was turned, it overlaps less.
  bool mirrored_is_worse = false;
  /// Whether the mirrored source meets the target better: one of the clouds is left-handed.
  bool mirrored_is_better = false;
  /// Whether the source was turned all around, as a whole object that the target shows, so that the
  /// surfaces found the pose and not the matches.
  bool found_by_turning = false;
  /// Other poses that could be meant, by symmetry or repetition: the surfaces meet about as well,
  /// or matches speak for them too and nothing that the sensors saw contradicts them. Best first.
  std::vector<RivalPose> rivals;
  /// What is odd about the clouds and may have gone wrong before they came here, a sentence each:
  /// repeated points, quantised coordinates, unlike units, a mirrored cloud, an unknown viewpoint.
  std::vector<std::string> notes;
};

/// Correspondences between two clouds: voxel grid, normals, FPFH (Rusu et al. 2009), nearest
/// neighbours in feature space.
///
/// @param source, target  3 x N and 3 x M, metres, finite; N and M may differ and may be 0.
/// @param options  the priors, `scale_mode`, `scale`, `scale_range`, `noise_bound`, `one_to_one`,
///   `num_threads`, `time_limit` and `stop` are read; only matches that the priors admit are
///   sought, by where points can lie and, to 30 degrees, by their normals; the search for nearest
///   features takes at most 60 % of the time limit, and ends with what it has
///   (`CloudMatches::share_compared`).
/// @return no matches where a cloud has fewer than 3 distinct voxels or no surface.
/// @throws std::invalid_argument where a point is not finite, an option is out of range, or the
///   cloud spans too many voxels to number them.
/// Cost O(N log N + M log M) for the features, O(N M) after the voxel grid for the matching.
/// Deterministic for any thread count.
CloudMatches match_clouds(const PointsRef& source, const PointsRef& target,
                          const FrontendOptions& frontend = {}, const Options& options = {});

/// Pose that aligns two clouds, from no initial guess: `match_clouds`, then
/// `register_correspondences`, then the refinement of `frontend.refine`, then a verdict from the
/// inliers and from how the surfaces meet.
///
/// Where the verdict is not `Trusted`, other settings of the front end are tried, up to
/// `frontend.max_attempts`. Priors of the options are heeded from the matching on: a point is
/// compared with those that can be its image, whose normals can be its normal's, and the initial
/// pose, refined, is one of the poses to choose from. Unless `frontend.refine` is `None`, the poses
/// of all attempts, their alternatives and the half turns of the best one are refined on the same
/// voxels and compared by how their surfaces meet; the best is kept, and others that fit about as
/// well are its `rivals`. A point that fills more than 1 % of a cloud counts once.
///
/// Where the scale is estimated, each attempt guesses it from matches at voxels by the clouds' own
/// extents, and seeks it within a tenth of that from matches at voxels of one size
/// (`Diagnostics::scale_range`); where `certify` or several hypotheses are asked for, at all
/// scales.
/// @param options  for the solver; `noise_bound` 0 takes the bound from the voxel size, and with
///   `NoiseMode::Estimated` it comes from the matches of each attempt.
/// @throws std::invalid_argument as `match_clouds`, and where `options.noise_bounds` is given: the
///   matches are not known beforehand.
/// Cost and determinism: those of the two steps.
CloudResult register_clouds(const PointsRef& source, const PointsRef& target,
                            const FrontendOptions& frontend = {}, const Options& options = {});

/// Several instances of the source in the target, such as parts in a bin: `register_clouds`, then
/// again without the points of the target within 1.5 voxels of the instance, and so on. A pose that
/// fits about as well somewhere else is another instance, not a rival.
///
/// @param options  as for `register_clouds`; `time_limit` is for all of them together.
/// @return the first whatever it is, so never empty; then those that have a pose, are not
/// untrusted,
///   and have the inliers and the share of the distinct evidence of the first that `instances` asks
///   for. Each is judged by itself; `matches` and indices are those of what was left of the target.
/// @throws std::invalid_argument as `register_clouds`, and on a bad instance option.
/// Cost: one registration an instance, and one that finds no more.
std::vector<CloudResult> register_cloud_instances(const PointsRef& source, const PointsRef& target,
                                                  const FrontendOptions& frontend = {},
                                                  const Options& options = {},
                                                  const InstanceOptions& instances = {});

/// The result at the pose near its own at which the surfaces of the two clouds meet best, as
/// `register_clouds` refines it; as it is where it has no pose or the surfaces meet best there.
///
/// Generalised ICP (Segal, Haehnel and Thrun, RSS 2009) with the kernel of Geman and McClure, whose
/// width follows the noise found, first on the voxel clouds of `result.matches`, then on finer ones
/// of the points, in frames at their centroids. The scale is refined where it is estimated; the
/// priors are kept. A refined pose is accepted where the surfaces meet more closely, relative to
/// the noise; the number of inliers has no say. Its half turns, and what were rivals of the pose
/// before, are compared with it anew (`CloudResult::rivals`). The covariance is that of the
/// surfaces.
/// @param source, target  the clouds that the result is of.
/// @param options  that the result was computed with; `time_limit` ends the refinement.
/// @throws std::invalid_argument as `register_clouds`.
/// Cost O(N log N). Deterministic for any thread count, but for the time limit.
CloudResult refine_clouds(CloudResult result, const PointsRef& source, const PointsRef& target,
                          const Options& options = {});

/// The result with another pose in place of its own, such as a refined one: inliers, evidence,
/// covariance, consistent scales, fitness, overlap RMSE and verdict are those of the new pose; the
/// certificate, which speaks of the matches, and the alternatives stay. The covariance is that of
/// the matches. Of its own pose the result stays as it is.
/// @param options  that the result was computed with.
/// @throws std::invalid_argument where the result is of no clouds.
/// Cost O(N log N).
CloudResult with_pose(CloudResult result, const Similarity& target_from_source,
                      const Options& options);

/// Mean of the points in each occupied cell of a cubic grid.
///
/// The grid starts at the smallest coordinates of the cloud, so a translation of the cloud
/// translates the result. Columns are in the order of the cells: x slowest, z fastest.
/// @param points      3 x N, metres, finite.
/// @param voxel_size  edge of a cell, metres, > 0, finite.
/// @return 3 x M, M <= N.
/// @throws std::invalid_argument naming `voxel_size` where an axis has more cells than 63 bits can
///   number.
/// Cost O(N log N). Deterministic.
Points voxel_grid(const PointsRef& points, double voxel_size);

/// Fast point feature histograms (Rusu, Blodow and Beetz, ICRA 2009) of a cloud by itself, with the
/// radii and the orientation of normals of the options: what `match_clouds` computes on its voxels.
/// @param points       3 x N, metres, finite.
/// @param voxel_size   the unit of the radii, metres, > 0.
/// @param num_threads  >= 0; 0 uses every core. The result does not depend on it.
/// @return 33 x N, column i is the feature of point i: three histograms of 11 bins, each sums to
///   200; 0 where a point has no normal or no neighbours.
/// @throws std::invalid_argument on a value that is not finite or a bad option.
/// Cost O(number of neighbours).
Eigen::Matrix<float, 33, Eigen::Dynamic> fpfh(const PointsRef& points,
                                              const FrontendOptions& frontend, double voxel_size,
                                              int num_threads);

}  // namespace gmcr
