#include "synthetic/clouds.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "synthetic/draft.hpp"

namespace gmcr::synthetic {

Points cube_points(Index count, Random& random) {
  Points points(3, count);
  for (Index i = 0; i < count; ++i) points.col(i) = random.in_cube(0.5);
  return points;
}

Points model_points(const PointsRef& model, Index count, Random& random) {
  if (model.cols() < count) {
    throw std::invalid_argument("model: " + std::to_string(model.cols()) + " points, " +
                                std::to_string(count) + " are needed");
  }
  if (!model.allFinite()) throw std::invalid_argument("model: a point is not finite");
  if (count == 0) return Points(3, 0);
  const Eigen::Vector3d low = model.rowwise().minCoeff();
  const Eigen::Vector3d high = model.rowwise().maxCoeff();
  const double side = (high - low).maxCoeff();
  if (!(side > 0)) throw std::invalid_argument("model: all points coincide");

  const Eigen::Vector3d centre = 0.5 * (low + high);
  const std::vector<Index> chosen = random.sample(count, model.cols());
  Points points(3, count);
  for (Index i = 0; i < count; ++i) {
    points.col(i) = (model.col(chosen[static_cast<std::size_t>(i)]) - centre) / side;
  }
  return points;
}

Points paper_target_cloud(const SyntheticOptions& options, const Similarity& target_from_source,
                          const Points& source, Random& random) {
  const Index num_images = source.cols();
  Points cloud(3, num_images + options.num_sphere_points);
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (Index i = 0; i < num_images; ++i) {
    cloud.col(i) = target_from_source * source.col(i) + draw_noise(options, random);
    centroid += cloud.col(i);
  }
  centroid /= static_cast<double>(std::max<Index>(1, num_images));

  double radius = 0;
  for (Index i = 0; i < num_images; ++i) {
    radius = std::max(radius, (cloud.col(i) - centroid).norm());
  }
  for (Index i = num_images; i < cloud.cols(); ++i) {
    cloud.col(i) = centroid + radius * random.unit_vector();
  }
  return cloud;
}

std::vector<Index> nearest_points(const Points& cloud, Index num_points, Index centre,
                                  Index count) {
  std::vector<std::pair<double, Index>> others;
  others.reserve(static_cast<std::size_t>(num_points));
  for (Index i = 0; i < num_points; ++i) {
    if (i != centre) others.emplace_back((cloud.col(i) - cloud.col(centre)).squaredNorm(), i);
  }
  const auto kept = others.begin() + std::min<Index>(count, std::ssize(others));
  std::partial_sort(others.begin(), kept, others.end());
  std::vector<Index> nearest;
  for (auto other = others.begin(); other != kept; ++other) nearest.push_back(other->second);
  return nearest;
}

}  // namespace gmcr::synthetic
