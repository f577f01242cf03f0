#pragma once

#include <Eigen/Core>
#include <vector>

#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr::problem {

/// Where coordinates are measured from. Points and poses of one frame and of another are different
/// types, so that mixing them does not compile.
enum class Frame {
  Caller,  ///< the caller's origins: residuals that the caller can check
  /// The middles of the clouds, so that a cloud far from its origin loses no digits, whatever a few
  /// far points are.
  Centred,
};

template <Frame frame>
struct CorrespondencesIn;

/// The caller's matches, in place: a view, valid for as long as the points are.
template <>
struct CorrespondencesIn<Frame::Caller> {
  PointsRef source, target;  ///< 3 x N, metres
  Eigen::ArrayXd bounds;     ///< N inlier bounds eps_i, metres

  Index size() const { return source.cols(); }
};
using CallerCorrespondences = CorrespondencesIn<Frame::Caller>;

/// Matches in frames at the middles of their points.
template <>
struct CorrespondencesIn<Frame::Centred> {
  Points source, target;  ///< 3 x N, metres, relative to the origins below
  Eigen::ArrayXd bounds;  ///< N inlier bounds eps_i, metres
  Eigen::Vector3d source_origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d target_origin = Eigen::Vector3d::Zero();

  Index size() const { return source.cols(); }
};
using Correspondences = CorrespondencesIn<Frame::Centred>;

/// A transform between two frames of one kind.
template <Frame frame>
struct PoseIn {
  Similarity similarity;

  double scale() const { return similarity.scale; }
};
using CallerPose = PoseIn<Frame::Caller>;
using CentredPose = PoseIn<Frame::Centred>;

/// Centres both clouds at their coordinate-wise medians. @param bounds  N inlier bounds, metres.
Correspondences centre(const PointsRef& source, const PointsRef& target,
                       const Eigen::ArrayXd& bounds);

/// The correspondences with the given indices, in that order, same origins.
Correspondences subset(const Correspondences& all, const std::vector<Index>& indices);

/// The pose between the caller's frames, and back.
CallerPose uncentre(const CentredPose& pose, const Correspondences& correspondences);
CentredPose centre(const CallerPose& pose, const Correspondences& correspondences);

/// Longest distance of a column from the origin, metres.
double max_norm(const PointsRef& points);

}  // namespace gmcr::problem
