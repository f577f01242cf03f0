#include "frontend/alignment/centred_pair.hpp"

namespace gmcr::frontend {
namespace {

/// Mean of the points, summed from the first one: no digit is lost far from 0.
Eigen::Vector3d centroid(const PointsRef& points) {
  const Eigen::Vector3d first = points.col(0);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i < points.cols(); ++i) sum += points.col(i) - first;
  return first + sum / static_cast<double>(points.cols());
}

}  // namespace

CentredPair::CentredPair(const PointsRef& source_points, const PointsRef& target_points,
                         double source_spacing, double target_spacing)
    : source_centre_(centroid(source_points)),
      target_centre_(centroid(target_points)),
      source(source_points, source_centre_, source_spacing),
      target(target_points, target_centre_, target_spacing) {}

Similarity CentredPair::centred(const Similarity& target_from_source) const {
  Similarity pose = target_from_source;
  pose.translation = target_from_source * source_centre_ - target_centre_;
  return pose;
}

Similarity CentredPair::of_caller(const Similarity& centred) const {
  Similarity pose = centred;
  pose.translation =
      target_centre_ + centred.translation - centred.scale * (centred.rotation * source_centre_);
  return pose;
}

}  // namespace gmcr::frontend
