#pragma once

#include <cstdint>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Which experiment a problem belongs to.
enum class SyntheticKind {
  Ball,        ///< random outliers, uniform in the ball around the transformed cloud
  Random,      ///< random benchmark of the paper (Gentner et al. 2023, exp:mc_synth)
  Structured,  ///< structured benchmark of the paper (Gentner et al. 2023, sec:structured_exp)
};

/// Distribution of the noise of an inlier.
enum class NoiseShape {
  Ball,      ///< uniform in the ball of radius `noise_extent`
  Gaussian,  ///< normal of sigma `noise_extent` / 3 an axis, cut off at the norm `noise_extent`
  Cube,      ///< uniform in [-noise_extent, noise_extent]^3
};

/// A random registration problem, up to its seed.
///
/// All kinds: the source is scaled to fit a cube of edge 1 m that is centred at the origin (largest
/// side 1, proportions kept), R is uniform in SO(3), s uniform in `scale_range`, t uniform in
/// [-max_translation, max_translation]^3. Noise is added in the target frame, after the transform,
/// because the paper's noise bound of 0.02 covers its noise of 0.01 an axis only so.
struct SyntheticOptions {
  SyntheticKind kind = SyntheticKind::Ball;  ///< where the outliers come from
  Index num_correspondences = 1000;          ///< >= 0
  double outlier_rate = 0.5;  ///< in [0, 1]; round((1 - rate) * N), halves up, are inliers
  std::uint64_t seed = 0;     ///< same options, same seed: same bits

  NoiseShape noise_shape = NoiseShape::Ball;  ///< of the target points
  double noise_extent = 0.01;  ///< metres, >= 0; its meaning depends on `noise_shape`
  /// Bound of the error of every inlier, metres, > 0; at least the largest norm of the noise.
  double noise_bound = 0.01;

  ScaleRange scale_range{1, 1};  ///< no unit
  double max_translation = 1.5;  ///< metres, >= 0

  // Random and Structured
  Index num_cloud_points = 1500;  ///< points of the source cloud, >= num_correspondences
  /// Points without a partner, on the sphere around the target, >= 0.
  Index num_sphere_points = 200;

  // Structured
  /// Clusters of outliers, >= 0. 0: ceil(10 * outlier_rate) + 2, more where these cannot hold all.
  Index num_bases = 0;
  Index source_neighbours = 9;  ///< a cluster's sources: the base and its k nearest points, >= 0
  Index target_neighbours = 9;  ///< a cluster's targets: likewise, >= source_neighbours
  /// An inlier's target is one of the k nearest points of the true one, >= 0; 0: the true one.
  Index association_neighbours = 3;

  /// @throws std::invalid_argument naming field and value.
  void validate() const;
};

/// Options of the paper's random benchmark: N = 80, noise 0.01 an axis, noise bound 0.02, scales
/// from 1 to 5.
SyntheticOptions paper_random_options();

/// Options of the paper's structured benchmark: as the random one with N = 90, noise bound 0.07.
SyntheticOptions paper_structured_options();

/// Correspondences with their truth.
struct SyntheticProblem {
  Points source;                  ///< 3 x N, metres
  Points target;                  ///< 3 x N, metres
  Similarity target_from_source;  ///< the truth
  /// N values: whether |target_i - target_from_source * source_i| <= noise_bound.
  std::vector<bool> is_inlier;
  double noise_bound = 0;  ///< metres, as in the options
};

/// Problem on points that are uniform in the cube.
///
/// Ball: an outlier keeps its source; its target is uniform in the smallest ball around the image
/// of the cube's centre that holds the images of all sources.
///
/// Random: a target cloud is made of all `num_cloud_points` transformed points with noise, then
/// `num_sphere_points` points uniform on the sphere around their centroid that touches the
/// outermost. Sources are drawn without repetition; an outlier's target is drawn from that cloud.
///
/// Structured: clouds as in Random. Inliers are drawn first; the target of each is replaced by one
/// of its `association_neighbours` nearest other points, drawn from those within `noise_bound` of
/// the truth; where there are none it stays. Then base outliers are drawn as in Random, from the
/// points of the model; the remaining outliers are dealt to random bases: a source near the base's
/// source and a target near the base's target, neither repeated within the cluster. Points of
/// different clusters may coincide.
///
/// An outlier that falls within the noise bound of the truth is drawn again. The order of the
/// correspondences is random.
/// @throws std::invalid_argument where an option is out of range, or where the noise bound is so
///   large that no outlier can be drawn.
/// Deterministic: the same options give the same bits with any compiler and standard library.
/// Cost O(N); Structured O(N * num_cloud_points).
SyntheticProblem make_synthetic(const SyntheticOptions& options);

/// The same on points of `model` (3 x M, any unit, finite), drawn without repetition.
/// @throws std::invalid_argument also where the model has too few points, one that is not finite,
///   or no extent.
SyntheticProblem make_synthetic(const SyntheticOptions& options, const PointsRef& model);

}  // namespace gmcr
