#include "problem/correspondences.hpp"

#include <cmath>

#include "problem/selection.hpp"

namespace gmcr::problem {

Correspondences centre(const PointsRef& source, const PointsRef& target,
                       const Eigen::ArrayXd& bounds) {
  Correspondences c;
  c.bounds = bounds;
  c.source_origin = middle_of(source);
  c.target_origin = middle_of(target);
  c.source = source.colwise() - c.source_origin;
  c.target = target.colwise() - c.target_origin;
  return c;
}

Correspondences subset(const Correspondences& all, const std::vector<Index>& indices) {
  return {all.source(Eigen::all, indices), all.target(Eigen::all, indices), all.bounds(indices),
          all.source_origin, all.target_origin};
}

CallerPose uncentre(const CentredPose& pose, const Correspondences& correspondences) {
  Similarity s = pose.similarity;
  s.translation += correspondences.target_origin -
                   pose.scale() * (pose.similarity.rotation * correspondences.source_origin);
  return {s};
}

CentredPose centre(const CallerPose& pose, const Correspondences& correspondences) {
  Similarity s = pose.similarity;
  s.translation += pose.scale() * (pose.similarity.rotation * correspondences.source_origin) -
                   correspondences.target_origin;
  return {s};
}

double max_norm(const PointsRef& points) {
  return points.cols() == 0 ? 0 : std::sqrt(points.colwise().squaredNorm().maxCoeff());
}

}  // namespace gmcr::problem
