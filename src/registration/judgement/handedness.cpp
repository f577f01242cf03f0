#include "registration/judgement/handedness.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

#include "estimation/closed_forms/similarity_fit.hpp"

namespace gmcr::registration {
namespace {

using problem::CallerCorrespondences;

// How thick a flat set is, in noise bounds: RMS distance from the plane of most of its points. Some
// of them are inliers by chance.
constexpr double kFlat = 2;
constexpr double kMost = 0.7;
constexpr int kPlaneFits = 3;

// Reach of the fits, in noise bounds: what is near the plane first, then what is farther off it.
constexpr double kReaches[] = {16, 8, 4, 2, 1, 1};
// The flat set tells the scale; another one would hold other matches by chance.
constexpr double kSameScale = 1.1;

/// An even selection, enough to tell a plane.
std::vector<Index> some_of(const std::vector<Index>& inliers) {
  constexpr std::size_t kEnough = 200;
  if (inliers.size() <= kEnough) return inliers;
  std::vector<Index> some;
  for (std::size_t k = 0; k < kEnough; ++k) {
    some.push_back(inliers[k * inliers.size() / kEnough]);
  }
  return some;
}

struct Plane {
  Eigen::Vector3d point, normal;
  double thickness = 0, width = 0;  ///< RMS distance from the plane, and along its short side
};

/// Plane of the points whose distances are at most the reach.
Plane fit_plane(const Points& points, const Eigen::ArrayXd& distances, double reach) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (Index i = 0; i < points.cols(); ++i) {
    if (distances[i] > reach) continue;
    sum += points.col(i);
    count += 1;
  }
  const Eigen::Vector3d centroid = sum / count;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (Index i = 0; i < points.cols(); ++i) {
    if (distances[i] > reach) continue;
    const Eigen::Vector3d centred = points.col(i) - centroid;
    moments += centred * centred.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments / count);
  const Eigen::Vector3d deviations = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  return {centroid, axes.eigenvectors().col(0), deviations[0], deviations[1]};
}

/// Plane of most of the points, at least 3: the farthest ones are left out.
Plane fit_plane_to_most(const Points& points) {
  const Index count = points.cols();
  const auto most = std::max<Index>(3, static_cast<Index>(kMost * static_cast<double>(count)));
  Eigen::ArrayXd distances = Eigen::ArrayXd::Zero(count);
  Plane plane = fit_plane(points, distances, 0);
  std::vector<double> sorted(static_cast<std::size_t>(count));
  for (int fit = 0; fit < kPlaneFits; ++fit) {
    distances =
        (plane.normal.transpose() * (points.colwise() - plane.point)).cwiseAbs().transpose();
    std::copy(distances.begin(), distances.end(), sorted.begin());
    const auto farthest = sorted.begin() + (most - 1);
    std::nth_element(sorted.begin(), farthest, sorted.end());
    plane = fit_plane(points, distances, *farthest);
  }
  return plane;
}

std::vector<Index> within(const CallerCorrespondences& all, const Points& mirrored,
                          const Similarity& pose, double factor) {
  std::vector<Index> found;
  for (Index i = 0; i < all.size(); ++i) {
    const double residual = (all.target.col(i) - pose * Eigen::Vector3d(mirrored.col(i))).norm();
    if (residual <= factor * all.bounds[i]) found.push_back(i);
  }
  return found;
}

}  // namespace

Index reflected_inliers(const CallerCorrespondences& all, const problem::CallerPose& pose,
                        const std::vector<Index>& inliers, const ScaleRange& scales) {
  if (inliers.size() < 4) return 0;  // three are always flat
  const Plane plane = fit_plane_to_most(all.source(Eigen::all, some_of(inliers)));
  const double flat = kFlat * all.bounds(inliers).maxCoeff() / pose.scale();
  if (plane.thickness > flat || plane.width <= flat) return 0;

  // A reflection is a rotation of the mirrored source.
  const Points mirrored =
      all.source -
      2 * plane.normal * (plane.normal.transpose() * (all.source.colwise() - plane.point));
  const ScaleRange same_scale{std::max(scales.min, pose.scale() / kSameScale),
                              std::min(scales.max, pose.scale() * kSameScale)};
  Similarity reflected = pose.similarity;
  for (const double reach : kReaches) {
    const auto fit = estimation::fit_similarity(
        mirrored, all.target, all.bounds, within(all, mirrored, reflected, reach), same_scale);
    if (!fit) return 0;
    reflected = *fit;
  }
  return static_cast<Index>(within(all, mirrored, reflected, 1).size());
}

}  // namespace gmcr::registration
