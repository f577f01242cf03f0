#include "problem/graph/pair_filter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"
#include "kernels/pairs/consistency_row.hpp"
#include "parallel/parallel_for.hpp"
#include "problem/graph/consistency_graph.hpp"
#include "problem/graph/symmetric_blocks.hpp"

namespace gmcr::problem {
namespace {

/// For each point the first one with the same coordinates.
std::vector<Index> first_equal_point(const Points& points) {
  std::map<std::tuple<double, double, double>, Index> first;
  std::vector<Index> result;
  for (Index i = 0; i < points.cols(); ++i) {
    result.push_back(
        first.try_emplace({points(0, i), points(1, i), points(2, i)}, i).first->second);
  }
  return result;
}

/// |t - centre| <= radius as a correspondence of the origin of the source frame.
struct TranslationPrior {
  Eigen::Vector3d centre;
  double radius = 0;
};

std::vector<TranslationPrior> translation_priors(const Priors& priors) {
  std::vector<TranslationPrior> result;
  if (std::isfinite(priors.max_translation)) {
    result.push_back({Eigen::Vector3d::Zero(), priors.max_translation});
  }
  if (priors.initial_pose && std::isfinite(priors.initial_pose->max_translation)) {
    result.push_back({priors.initial_pose->target_from_source.translation,
                      priors.initial_pose->max_translation});
  }
  return result;
}

/// The correspondences and after them the virtual ones, with bounds widened by rounding.
geometry::CorrespondenceArrays with_virtual(const Correspondences& correspondences,
                                            const std::vector<TranslationPrior>& translations,
                                            const Eigen::ArrayXd& rounding, double scale_max) {
  geometry::CorrespondenceArrays arrays = consistency_arrays(correspondences, scale_max);
  const Index n = arrays.size(), count = n + static_cast<Index>(translations.size());
  if (count == n) return arrays;
  constexpr double kRounding = 1e-11;  // above what `Priors::admit` grants
  // of the origins alone; 0 where there are no correspondences that could be inliers
  const double widened = n == 0 ? 0 : rounding.minCoeff();
  arrays.source.conservativeResize(count, 3);
  arrays.target.conservativeResize(count, 3);
  arrays.bounds.conservativeResize(count);
  Index row = n;
  for (const auto& [centre, radius] : translations) {
    arrays.source.row(row) = -correspondences.source_origin.transpose();
    arrays.target.row(row) = (centre - correspondences.target_origin).transpose();
    arrays.bounds[row++] = radius + widened + kRounding * (centre.norm() + radius);
  }
  return arrays;
}

/// A rotation that maps a direction to the last axis.
Eigen::Matrix3d to_last_axis(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d up = direction.stableNormalized(), first = up.unitOrthogonal();
  Eigen::Matrix3d turn;
  turn << first.transpose(), up.cross(first).transpose(), up.transpose();
  return turn;
}

}  // namespace

PairFilter::PairFilter(const Correspondences& correspondences, const Priors& priors,
                       bool one_to_one, const ScaleRange& scales)
    : num_correspondences_(correspondences.size()), one_to_one_(one_to_one) {
  const std::vector<TranslationPrior> translations = translation_priors(priors);
  num_virtual_ = static_cast<Index>(translations.size());
  Eigen::ArrayXd rounding = rounding_of_residuals(correspondences, scales.max);
  arrays_ = with_virtual(correspondences, translations, rounding, scales.max);
  const double of_origins = num_correspondences_ == 0 ? 0 : rounding.minCoeff();
  rounding.conservativeResize(arrays_.size());
  rounding.tail(num_virtual_).setConstant(of_origins);
  if (priors.gravity) {
    add(true, priors.gravity->max_tilt, to_last_axis(priors.gravity->source),
        to_last_axis(priors.gravity->target), rounding);
  }
  if (priors.initial_pose) {
    add(false, priors.initial_pose->max_rotation,
        geometry::exact_rotation(priors.initial_pose->target_from_source.rotation),
        Eigen::Matrix3d::Identity(), rounding);
  }
  if (!one_to_one_) return;
  source_point_ = first_equal_point(correspondences.source);
  target_point_ = first_equal_point(correspondences.target);
}

void PairFilter::add(bool about_axis, double angle, const Eigen::Matrix3d& source_turn,
                     const Eigen::Matrix3d& target_turn, const Eigen::ArrayXd& rounding) {
  const double widened = angle + 2 * geometry::kAngleSlack;
  if (widened >= std::numbers::pi) return;
  AnglePrior prior{about_axis, elementary::cos(widened), elementary::sin(widened), {}};
  prior.ends.setZero(8, arrays_.size());
  prior.ends.topRows<3>() = source_turn * arrays_.source.transpose();
  prior.ends.middleRows<3>(3) = target_turn * arrays_.target.transpose();
  // turning the points rounds them once more
  prior.ends.row(6) = (arrays_.bounds + rounding).transpose();
  angles_.push_back(std::move(prior));
}

bool PairFilter::AnglePrior::admits(Index i, Index j, const ScaleRange& scales) const {
  const Eigen::Vector3d a = ends.col(j).head<3>() - ends.col(i).head<3>();
  const Eigen::Vector3d b = ends.col(j).segment<3>(3) - ends.col(i).segment<3>(3);
  const double bound = ends(6, i) + ends(6, j);
  // cosine and sine of the angle between the pair's two vectors, times |a| |b|
  double dot = 0, cross = 0;
  if (about_axis) {
    const double a_across = std::sqrt(a.head<2>().squaredNorm());
    const double b_across = std::sqrt(b.head<2>().squaredNorm());
    dot = a.z() * b.z() + a_across * b_across;
    cross = std::abs(a_across * b.z() - a.z() * b_across);
  } else {
    dot = a.dot(b);
    cross = a.cross(b).norm();
  }
  // the same of delta, that angle less the one that the prior leaves
  const double sine_delta = cross * cosine - dot * sine;
  if (sine_delta <= 0) return true;
  const double cosine_delta = dot * cosine + cross * sine;
  // distance from b to the nearest admitted image of a, times |a|
  const double squared_length = a.squaredNorm();
  const double off = cosine_delta - std::clamp(cosine_delta, scales.min * squared_length,
                                               scales.max * squared_length);
  return off * off + sine_delta * sine_delta <= bound * bound * squared_length;
}

bool PairFilter::admits_rotation(Index i, Index j, const ScaleRange& scales) const {
  return std::all_of(angles_.begin(), angles_.end(),
                     [&](const AnglePrior& prior) { return prior.admits(i, j, scales); });
}

bool PairFilter::share_end_point(Index i, Index j) const {
  const auto p = static_cast<std::size_t>(i), q = static_cast<std::size_t>(j);
  return source_point_[p] == source_point_[q] || target_point_[p] == target_point_[q];
}

bool PairFilter::admits(Index i, const ScaleRange& scales) const {
  for (Index v = num_correspondences_; v < num_correspondences_ + num_virtual_; ++v) {
    if (!kernels::is_consistent(arrays_, i, v, scales.min, scales.max)) return false;
    if (!admits_rotation(i, v, scales)) return false;
  }
  return true;
}

bool PairFilter::admits_pair(Index i, Index j, const ScaleRange& scales) const {
  if (one_to_one_ && share_end_point(i, j)) return false;
  return kernels::is_consistent(arrays_, i, j, scales.min, scales.max) &&
         admits_rotation(i, j, scales);
}

void PairFilter::apply(BitsetGraph& graph, const ScaleRange& scales, int num_threads,
                       const parallel::Deadline& deadline) const {
  if (angles_.empty() && !one_to_one_) return;
  constexpr Index kBlock = BitsetGraph::kBitsPerWord;
  const int threads = parallel::threads_for_pairs(graph.num_vertices(), num_threads);
  parallel::parallel_for(graph.num_vertices(), kBlock, threads, [&](Index begin, Index end) {
    if (deadline.expired()) return;
    for (Index i = begin; i < end; ++i) {
      const auto row = graph.mutable_row(i);
      for (auto word = static_cast<std::size_t>(begin / kBlock); word < row.size(); ++word) {
        for (BitsetGraph::Word left = row[word]; left != 0; left &= left - 1) {
          const Index j = static_cast<Index>(word) * kBlock + std::countr_zero(left);
          if ((one_to_one_ && share_end_point(i, j)) || !admits_rotation(i, j, scales)) {
            row[word] &= ~(left & -left);
          }
        }
      }
    }
  });
  mirror_upper_blocks(graph, threads, deadline);
}

std::vector<Index> PairFilter::one_to_one(const std::vector<Index>& indices) const {
  if (!one_to_one_) return indices;
  std::vector<bool> source_taken(source_point_.size()), target_taken(target_point_.size());
  std::vector<Index> subset;
  for (const Index i : indices) {
    const auto source = static_cast<std::size_t>(source_point_[static_cast<std::size_t>(i)]);
    const auto target = static_cast<std::size_t>(target_point_[static_cast<std::size_t>(i)]);
    if (source_taken[source] || target_taken[target]) continue;
    source_taken[source] = target_taken[target] = true;
    subset.push_back(i);
  }
  return subset;
}

}  // namespace gmcr::problem
