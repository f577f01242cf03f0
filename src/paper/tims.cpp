#include "paper/tims.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gmcr::paper {

Tims make_tims(const problem::Correspondences& correspondences, std::vector<Pair> pairs) {
  Tims tims;
  const auto count = static_cast<Index>(pairs.size());
  tims.source.resize(3, count);
  tims.target.resize(3, count);
  tims.bounds.resize(count);
  for (Index k = 0; k < count; ++k) {
    const auto [i, j] = pairs[static_cast<std::size_t>(k)];
    // Eq. (4): abar_k = a_j - a_i, bbar_k = b_j - b_i, eps_k = eps_i + eps_j
    tims.source.col(k) = correspondences.source.col(j) - correspondences.source.col(i);
    tims.target.col(k) = correspondences.target.col(j) - correspondences.target.col(i);
    tims.bounds[k] = correspondences.bounds[i] + correspondences.bounds[j];
  }
  tims.pairs = std::move(pairs);
  return tims;
}

std::vector<Pair> all_pairs(Index num_correspondences) {
  std::vector<Pair> pairs;
  if (num_correspondences < 2) return pairs;
  pairs.reserve(static_cast<std::size_t>(num_correspondences * (num_correspondences - 1) / 2));
  for (Index i = 0; i < num_correspondences; ++i) {
    for (Index j = i + 1; j < num_correspondences; ++j) pairs.push_back({i, j});
  }
  return pairs;
}

Index max_members(Index num_pairs) {
  // L5: m (m - 1) / 2 <= num_pairs
  auto m = static_cast<Index>((1 + std::sqrt(1 + 8 * static_cast<double>(num_pairs))) / 2);
  while (m * (m - 1) / 2 > num_pairs) --m;
  while ((m + 1) * m / 2 <= num_pairs) ++m;
  return m;
}

ScaleMeasurements measure_scales(const Tims& tims) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ScaleMeasurements m;
  const Eigen::ArrayXd a = tims.source.colwise().norm(), b = tims.target.colwise().norm();
  // Eq. (8), (9): s_k = |bbar_k| / |abar_k|, known to alpha_k = eps_k / |abar_k|
  m.scale = b / a;
  m.alpha = tims.bounds / a;
  // Eq. (7), L1: k agrees at the scales of [s_k - alpha_k, s_k + alpha_k]
  m.lower = (b - tims.bounds) / a;
  m.upper = (b + tims.bounds) / a;
  for (Index k = 0; k < tims.size(); ++k) {
    if (a[k] > 0) continue;
    const bool always = b[k] <= tims.bounds[k];
    m.scale[k] = m.alpha[k] = kInfinity;
    m.lower[k] = always ? -kInfinity : kInfinity;
    m.upper[k] = -m.lower[k];
  }
  return m;
}

std::vector<Index> touched_correspondences(const Tims& tims, const std::vector<Index>& indices) {
  std::vector<Index> touched;
  for (const Index k : indices) {
    touched.push_back(tims.pairs[static_cast<std::size_t>(k)].first);
    touched.push_back(tims.pairs[static_cast<std::size_t>(k)].second);
  }
  std::sort(touched.begin(), touched.end());
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

Tims select(const Tims& tims, const std::vector<Index>& indices) {
  Tims selected;
  for (const Index k : indices) selected.pairs.push_back(tims.pairs[static_cast<std::size_t>(k)]);
  selected.source = tims.source(Eigen::all, indices);
  selected.target = tims.target(Eigen::all, indices);
  selected.bounds = tims.bounds(indices);
  return selected;
}

}  // namespace gmcr::paper
