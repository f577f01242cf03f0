#include "frontend/alignment/plane_pairs.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "frontend/alignment/plane_metric.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr Index kPairGrain = 512;  // fewer pairs take less time than to wake a thread

/// 0 at 60 degrees between the normals and more, 1 where they are parallel, whatever their signs.
double agreement_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::clamp(2 * std::abs(a.dot(b)) - 1, 0.0, 1.0);
}

double squared_distance_of(const PlanePair& pair) {
  const PlaneMetric metric(pair.normal.dot(pair.moved_normal));
  const double a = pair.residual.dot(pair.moved_normal), b = pair.residual.dot(pair.normal);
  return PlaneMetric::isotropic * pair.residual.squaredNorm() + metric.sum * (a + b) * (a + b) +
         metric.difference * (a - b) * (a - b);
}

}  // namespace

Samples sample_side(const SurfaceCloud& cloud, bool of_source, Index max_count) {
  Samples samples;
  samples.of_source = of_source;
  const Index stride = (cloud.size() + max_count - 1) / max_count;
  for (Index i = 0; i < cloud.size(); i += stride) samples.columns.push_back(i);
  return samples;
}

Samples choose_samples(const SurfaceCloud& source, const SurfaceCloud& target, Index max_count) {
  const bool of_source = source.size() <= target.size();
  return sample_side(of_source ? source : target, of_source, max_count);
}

PlanePairs find_pairs(SurfaceCloud& source, SurfaceCloud& target, const Samples& samples,
                      const Similarity& pose, double radius, int num_threads) {
  SurfaceCloud& sampled = samples.of_source ? source : target;
  SurfaceCloud& other = samples.of_source ? target : source;
  const Similarity to_other = samples.of_source ? pose : pose.inverse();
  const auto count = static_cast<Index>(samples.columns.size());
  Points queries(3, count);
  for (Index k = 0; k < count; ++k) {
    queries.col(k) = to_other * sampled.point(samples.columns[static_cast<std::size_t>(k)]);
  }
  const double reach = samples.of_source ? radius : radius / pose.scale;
  const std::vector<Index> found = other.nearest(queries, reach, num_threads);
  sampled.require_normals(samples.columns, num_threads);
  other.require_normals(found, num_threads);

  PlanePairs result;
  result.num_sought = count;
  result.pairs.resize(found.size());
  parallel::parallel_for(count, kPairGrain, num_threads, [&](Index begin, Index end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      PlanePair& pair = result.pairs[k];
      pair.normal.setZero();
      if (found[k] < 0) continue;
      const Index i = samples.of_source ? samples.columns[k] : found[k];
      const Index j = samples.of_source ? found[k] : samples.columns[k];
      pair.moved_normal = pose.rotation * source.normal(i);
      if (pair.moved_normal.isZero(0)) continue;
      pair.normal = target.normal(j);
      pair.moved = pose * source.point(i);
      pair.residual = pair.moved - target.point(j);
      pair.agreement = agreement_of(pair.moved_normal, pair.normal);
      pair.squared_distance = squared_distance_of(pair);
    }
  });
  std::erase_if(result.pairs, [](const PlanePair& pair) { return pair.normal.isZero(0); });
  return result;
}

double estimate_noise(const PlanePairs& pairs) {
  constexpr double kNormalDeviation = 1.4826;  // of a normal distribution, over its median size
  std::vector<double> squared;
  for (const PlanePair& pair : pairs.pairs) {
    if (pair.agreement > 0) squared.push_back(pair.squared_distance);
  }
  if (squared.empty()) return 0;
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return kNormalDeviation * std::sqrt(*middle);
}

double mean_cost(const PlanePairs& pairs, double kernel) {
  double saved = 0;
  for (const PlanePair& pair : pairs.pairs) {
    saved += pair.agreement * kernel * kernel / (kernel * kernel + pair.squared_distance);
  }
  return 1 - saved / static_cast<double>(pairs.num_sought);
}

NormalEquations normal_equations(const PlanePairs& pairs, double kernel) {
  NormalEquations equations;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  double second = 0;
  for (const PlanePair& pair : pairs.pairs) {
    const double weight = weight_of(pair, kernel);
    equations.weight += weight;
    first += weight * pair.moved;
    second += weight * pair.moved.squaredNorm();
  }
  equations.pivot = first / equations.weight;
  equations.lever =
      std::sqrt(std::max(second / equations.weight - equations.pivot.squaredNorm(), 1e-300));

  // moments of the arms for the isotropic part, and the parts along the normals
  double weights = 0;
  Eigen::Vector3d arms = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 7, 7>& matrix = equations.matrix;
  matrix.setZero();
  equations.gradient.setZero();
  for (const PlanePair& pair : pairs.pairs) {
    const double weight = weight_of(pair, kernel);
    if (weight == 0) continue;
    const Eigen::Vector3d arm = (pair.moved - equations.pivot) / equations.lever;
    const PlaneMetric metric(pair.normal.dot(pair.moved_normal));
    const Eigen::Vector3d sum = pair.moved_normal + pair.normal;
    const Eigen::Vector3d difference = pair.moved_normal - pair.normal;
    const MotionStep by_sum = along(sum, arm), by_difference = along(difference, arm);
    const double isotropic = weight * PlaneMetric::isotropic;
    const MotionStep of_sum = (weight * metric.sum) * by_sum;
    const MotionStep of_difference = (weight * metric.difference) * by_difference;
    weights += isotropic;
    arms += isotropic * arm;
    squares += isotropic * arm * arm.transpose();
    matrix += of_sum * by_sum.transpose() + of_difference * by_difference.transpose();
    equations.gradient += isotropic * along(pair.residual, arm) + of_sum * pair.residual.dot(sum) +
                          of_difference * pair.residual.dot(difference);
  }
  Eigen::Matrix3d cross;  // arms x
  cross << 0, -arms.z(), arms.y(), arms.z(), 0, -arms.x(), -arms.y(), arms.x(), 0;
  matrix.topLeftCorner<3, 3>() += squares.trace() * Eigen::Matrix3d::Identity() - squares;
  matrix.block<3, 3>(0, 3) += cross;
  matrix.block<3, 3>(3, 0) += cross.transpose();
  matrix.block<3, 3>(3, 3) += weights * Eigen::Matrix3d::Identity();
  matrix.block<3, 1>(3, 6) += arms;
  matrix.block<1, 3>(6, 3) += arms.transpose();
  matrix(6, 6) += squares.trace();
  return equations;
}

}  // namespace gmcr::frontend
