#include "frontend/alignment/plane_pairs.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr Index kBlock = 512;

/// 0 at 60 degrees between the normals and more, 1 where they are parallel, whatever their signs.
double agreement_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::clamp(2 * std::abs(a.dot(b)) - 1, 0.0, 1.0);
}

Eigen::Matrix3d information_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Matrix3d covariance =
      2 * Eigen::Matrix3d::Identity() - (1 - kFlatness) * (a * a.transpose() + b * b.transpose());
  return 2 * kFlatness * covariance.inverse();
}

double weight_of(const PlanePair& pair, double kernel) {
  const double ratio = kernel * kernel / (kernel * kernel + pair.squared_distance());
  return pair.agreement * ratio * ratio;
}

/// What body(begin, end) gives for blocks of a fixed size, added up in their order.
template <class Sum, class Body>
Sum sum_in_blocks(Index count, int num_threads, const Sum& zero, const Body& body) {
  std::vector<Sum> partial(static_cast<std::size_t>((count + kBlock - 1) / kBlock), zero);
  parallel::parallel_for(count, kBlock, num_threads, [&](Index begin, Index end) {
    partial[static_cast<std::size_t>(begin / kBlock)] = body(begin, end);
  });
  Sum total = zero;
  for (const Sum& part : partial) total += part;
  return total;
}

/// Motion of a point at `arm` from the pivot, by each of the seven parameters in metres.
Eigen::Matrix<double, 3, 7> motion_of(const Eigen::Vector3d& arm, double lever) {
  const Eigen::Vector3d a = arm / lever;
  Eigen::Matrix<double, 3, 7> motion;
  motion << 0, a.z(), -a.y(), 1, 0, 0, a.x(),  //
      -a.z(), 0, a.x(), 0, 1, 0, a.y(),        //
      a.y(), -a.x(), 0, 0, 0, 1, a.z();
  return motion;
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
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (found[k] < 0) continue;
    const Index i = samples.of_source ? samples.columns[k] : found[k];
    const Index j = samples.of_source ? found[k] : samples.columns[k];
    const Eigen::Vector3d moved_normal = pose.rotation * source.normal(i);
    const Eigen::Vector3d normal = target.normal(j);
    if (moved_normal.isZero(0) || normal.isZero(0)) continue;
    PlanePair& pair = result.pairs.emplace_back();
    pair.moved = pose * source.point(i);
    pair.residual = pair.moved - target.point(j);
    pair.normal = normal;
    pair.information = information_of(moved_normal, normal);
    pair.agreement = agreement_of(moved_normal, normal);
  }
  return result;
}

double estimate_noise(const PlanePairs& pairs) {
  constexpr double kNormalDeviation = 1.4826;  // of a normal distribution, over its median size
  std::vector<double> squared;
  for (const PlanePair& pair : pairs.pairs) {
    if (pair.agreement > 0) squared.push_back(pair.squared_distance());
  }
  if (squared.empty()) return 0;
  const auto middle = squared.begin() + static_cast<std::ptrdiff_t>(squared.size() / 2);
  std::nth_element(squared.begin(), middle, squared.end());
  return kNormalDeviation * std::sqrt(*middle);
}

double mean_cost(const PlanePairs& pairs, double kernel) {
  double saved = 0;
  for (const PlanePair& pair : pairs.pairs) {
    saved += pair.agreement * kernel * kernel / (kernel * kernel + pair.squared_distance());
  }
  return 1 - saved / static_cast<double>(pairs.num_sought);
}

NormalEquations normal_equations(const PlanePairs& pairs, double kernel, int num_threads) {
  using Sums = Eigen::Matrix<double, 7, 8>;
  using Moments = Eigen::Matrix<double, 5, 1>;  // weight, weighted point, weighted square
  const std::vector<PlanePair>& all = pairs.pairs;
  const auto count = static_cast<Index>(all.size());
  const Moments moments =
      sum_in_blocks(count, num_threads, Moments(Moments::Zero()), [&](Index begin, Index end) {
        Moments sum = Moments::Zero();
        for (Index k = begin; k < end; ++k) {
          const PlanePair& pair = all[static_cast<std::size_t>(k)];
          const double weight = weight_of(pair, kernel);
          sum[0] += weight;
          sum.segment<3>(1) += weight * pair.moved;
          sum[4] += weight * pair.moved.squaredNorm();
        }
        return sum;
      });
  NormalEquations equations;
  equations.weight = moments[0];
  equations.pivot = moments.segment<3>(1) / moments[0];
  equations.lever =
      std::sqrt(std::max(moments[4] / moments[0] - equations.pivot.squaredNorm(), 1e-300));
  const Sums sums =
      sum_in_blocks(count, num_threads, Sums(Sums::Zero()), [&](Index begin, Index end) {
        Sums sum = Sums::Zero();
        for (Index k = begin; k < end; ++k) {
          const PlanePair& pair = all[static_cast<std::size_t>(k)];
          const auto motion = motion_of(pair.moved - equations.pivot, equations.lever);
          const Eigen::Matrix<double, 7, 3> weighted =
              motion.transpose() * (weight_of(pair, kernel) * pair.information);
          sum.leftCols<7>() += weighted * motion;
          sum.col(7) += weighted * pair.residual;
        }
        return sum;
      });
  equations.matrix = sums.leftCols<7>();
  equations.gradient = sums.col(7);
  return equations;
}

}  // namespace gmcr::frontend
