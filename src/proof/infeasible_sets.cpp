#include "proof/infeasible_sets.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace gmcr::proof {
namespace {

constexpr double kLimit = 1 + 1e-9;  // of a mean of squares, beyond its rounding

Points columns(const Eigen::MatrixX3d& points, const std::vector<Index>& indices) {
  return points(indices, Eigen::all).transpose();
}

}  // namespace

InfeasibleSets::InfeasibleSets(const geometry::CorrespondenceArrays& arrays,
                               const ScaleRange& scales)
    : arrays_(arrays), scales_(scales) {
  moments_.reserve(static_cast<std::size_t>(arrays.size()));
  for (Index i = 0; i < arrays.size(); ++i) {
    moments_.push_back(estimation::point_moments(arrays.source.row(i), arrays.target.row(i),
                                                 1 / (arrays.bounds[i] * arrays.bounds[i])));
  }
}

InfeasibleSets::Conflict InfeasibleSets::find_conflict(const std::vector<Index>& members) const {
  constexpr std::array<std::size_t, 8> kSizes{4, 5, 6, 7, 8, 10, 14, 20};
  if (members.size() < 3) return {};
  estimation::MinimaxFit all = fit(members);
  if (!settle(all)) {
    const bool holds = all.residuals().maxCoeff() <= 1;
    return {{}, holds ? std::optional(all.pose()) : std::nullopt};
  }
  // those that weigh most exclude each other, if any few do
  std::vector<Index> order(members.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return all.weights()[a] > all.weights()[b]; });
  std::vector<Index> heaviest;
  for (const Index k : order) heaviest.push_back(members[static_cast<std::size_t>(k)]);
  for (const std::size_t size : kSizes) {
    if (size >= heaviest.size()) break;
    const std::vector<Index> few(heaviest.begin(),
                                 heaviest.begin() + static_cast<std::ptrdiff_t>(size));
    estimation::MinimaxFit fit_of_few = fit(few);
    if (settle(fit_of_few)) return {few, std::nullopt};
  }
  return {heaviest, std::nullopt};
}

estimation::Moments InfeasibleSets::mean_moments(const std::vector<Index>& members,
                                                 const Eigen::ArrayXd& weights) const {
  estimation::Moments sum;
  const double total = weights.sum();
  for (std::size_t k = 0; k < members.size(); ++k) {
    sum +=
        moments_[static_cast<std::size_t>(members[k])] * (weights[static_cast<Index>(k)] / total);
  }
  return sum;
}

std::optional<estimation::Moments> InfeasibleSets::minimax_moments(
    const std::vector<Index>& members) const {
  constexpr int kSteps = 20;
  estimation::MinimaxFit minimax = fit(members);
  Eigen::ArrayXd weights = minimax.weights();
  for (int step = 0; step < kSteps; ++step) {
    weights = minimax.weights();
    if (!minimax.step()) break;
    if (excludes(minimax)) return std::nullopt;
  }
  return mean_moments(members, weights);
}

bool InfeasibleSets::may_hold(const estimation::Moments& members, double members_share,
                              std::initializer_list<Index> others) const {
  estimation::Moments sum = members * members_share;
  for (const Index i : others) {
    sum += moments_[static_cast<std::size_t>(i)] *
           ((1 - members_share) / static_cast<double>(others.size()));
  }
  // L5: held together, the least weighted mean of |residual|^2 / eps^2 is at most 1
  return estimation::least_squares_bound(sum, scales_) <= kLimit;
}

estimation::MinimaxFit InfeasibleSets::fit(const std::vector<Index>& members) const {
  return estimation::MinimaxFit(columns(arrays_.source, members), columns(arrays_.target, members),
                                arrays_.bounds(members), estimation::PoseConstraints{scales_});
}

bool InfeasibleSets::excludes(estimation::MinimaxFit& fit) {
  // L5: a least weighted mean above 1 excludes the set
  return fit.mean_square() > kLimit && fit.lower_bound() > kLimit;
}

/// Fits until all members are held or excluded, or patience ends. @return whether they are
/// excluded.
bool InfeasibleSets::settle(estimation::MinimaxFit& fit) const {
  constexpr int kMaxSteps = 200;
  for (int step = 0; step < kMaxSteps && fit.step(); ++step) {
    if (fit.residuals().maxCoeff() <= 1) return false;
    if (excludes(fit)) return true;
  }
  return false;
}

}  // namespace gmcr::proof
