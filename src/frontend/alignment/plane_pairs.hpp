#pragma once

#include <Eigen/Core>
#include <vector>

#include "frontend/alignment/surface_cloud.hpp"
#include "gmcr/similarity.hpp"

namespace gmcr::frontend {

/// A point of the source, moved, and the point of the target that it is taken to meet.
struct PlanePair {
  Eigen::Vector3d moved;         ///< metres, about the centre of the target
  Eigen::Vector3d residual;      ///< moved - target point
  Eigen::Vector3d normal;        ///< of the target, unit
  Eigen::Vector3d moved_normal;  ///< of the source, unit
  double agreement = 0;          ///< of the normals, in [0, 1]; 0: the pair says nothing
  /// Of the two patches, metres^2: for parallel ones that of their planes, and kFlatness times that
  /// along them.
  double squared_distance = 0;
};

/// Variance of a plane patch along its normal over that along the plane (Segal et al. 2009, who
/// take 1e-3; normals from few neighbours are not that sure).
inline constexpr double kFlatness = 1e-2;

/// What meets under a pose: pairs of the columns that are sought, in their order.
struct PlanePairs {
  std::vector<PlanePair> pairs;  ///< that have normals
  Index num_sought = 0;
};

/// The side whose points are sought on the other, and which of them.
struct Samples {
  bool of_source = true;
  std::vector<Index> columns;
};

/// At most `max_count` points of one side, by a fixed stride.
Samples sample_side(const SurfaceCloud& cloud, bool of_source, Index max_count);

/// The same of the cloud that has fewer: more of it is covered.
Samples choose_samples(const SurfaceCloud& source, const SurfaceCloud& target, Index max_count);

/// Pairs each sample with its nearest point on the other side, after the pose.
/// @param pose    between the centred frames of the two clouds.
/// @param radius  metres, target frame: farther ones are no pair.
/// Cost O(samples). Deterministic for any thread count.
PlanePairs find_pairs(SurfaceCloud& source, SurfaceCloud& target, const Samples& samples,
                      const Similarity& pose, double radius, int num_threads);

/// Standard deviation of the distances of the pairs, from the median of those whose normals agree,
/// metres; 0 where there is none.
double estimate_noise(const PlanePairs& pairs);

/// Sum over the samples of the Geman-McClure cost e^2 / (kernel^2 + e^2) of their pairs, over their
/// number, in [0, 1]; a sample without a pair, or with one whose normals disagree, costs 1.
double mean_cost(const PlanePairs& pairs, double kernel);

/// A small motion: rotation, translation and growth, the first and the last times a lever, metres.
using MotionStep = Eigen::Matrix<double, 7, 1>;

/// Normal equations of a small motion  x -> x + omega x (x - pivot) + tau + sigma (x - pivot)  of
/// the moved points; rotation and scale are multiplied by `lever`, so that all are metres.
struct NormalEquations {
  Eigen::Matrix<double, 7, 7> matrix;  ///< omega (3), tau (3), sigma
  MotionStep gradient;                 ///< half of that of the cost
  Eigen::Vector3d pivot;               ///< weighted mean of the moved points
  double lever = 0;                    ///< their RMS distance from it, metres
  double weight = 0;                   ///< sum of the weights
};

/// Gauss-Newton with the weights (kernel^2 / (kernel^2 + e^2))^2 of Geman and McClure, times the
/// agreement of the normals. Summed one after the other.
/// @param pairs  at least one whose agreement is above 0.
NormalEquations normal_equations(const PlanePairs& pairs, double kernel);

}  // namespace gmcr::frontend
