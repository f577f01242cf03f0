#include "frontend/alignment/centred_pair.hpp"

#include <utility>

#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {

Eigen::Vector3d centroid(const PointsRef& points) {
  const Eigen::Vector3d first = points.col(0);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Index i = 0; i < points.cols(); ++i) sum += points.col(i) - first;
  return first + sum / static_cast<double>(points.cols());
}

CentredPair::CentredPair(const PointsRef& source_points, const PointsRef& target_points,
                         double source_spacing, double target_spacing, int num_threads)
    : CentredPair([&] {
        Parts parts;
        parallel::call_both(
            num_threads,
            [&] {
              parts.source_centre = centroid(source_points);
              parts.source = std::make_shared<SurfaceCloud>(source_points, parts.source_centre,
                                                            source_spacing);
            },
            [&] {
              parts.target_centre = centroid(target_points);
              parts.target = std::make_shared<SurfaceCloud>(target_points, parts.target_centre,
                                                            target_spacing);
            });
        return parts;
      }()) {}

CentredPair::CentredPair(Parts parts)
    : source_centre_(std::move(parts.source_centre)),
      target_centre_(std::move(parts.target_centre)),
      shared_source_(std::move(parts.source)),
      shared_target_(std::move(parts.target)),
      source(*shared_source_),
      target(*shared_target_) {}

CentredPair::CentredPair(const PointsRef& source_points, double source_spacing,
                         std::shared_ptr<SurfaceCloud> shared_target, Eigen::Vector3d target_centre)
    : CentredPair([&] {
        const Eigen::Vector3d centre = centroid(source_points);
        return Parts{centre, std::move(target_centre),
                     std::make_shared<SurfaceCloud>(source_points, centre, source_spacing),
                     std::move(shared_target)};
      }()) {}

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
