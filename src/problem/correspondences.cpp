#include "problem/correspondences.hpp"

#include <cmath>

namespace gmcr::problem {

Correspondences centre(const PointsRef& source, const PointsRef& target,
                       const Eigen::ArrayXd& bounds) {
  Correspondences c;
  c.bounds = bounds;
  if (source.cols() > 0) {
    c.source_origin = source.rowwise().mean();
    c.target_origin = target.rowwise().mean();
  }
  c.source = source.colwise() - c.source_origin;
  c.target = target.colwise() - c.target_origin;
  return c;
}

Correspondences subset(const Correspondences& all, const std::vector<Index>& indices) {
  return {all.source(Eigen::all, indices), all.target(Eigen::all, indices), all.bounds(indices),
          all.source_origin, all.target_origin};
}

Similarity uncentre(const Similarity& centred, const Correspondences& correspondences) {
  Similarity s = centred;
  s.translation += correspondences.target_origin -
                   centred.scale * (centred.rotation * correspondences.source_origin);
  return s;
}

double max_norm(const PointsRef& points) {
  return points.cols() == 0 ? 0 : std::sqrt(points.colwise().squaredNorm().maxCoeff());
}

}  // namespace gmcr::problem
