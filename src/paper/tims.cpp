#include "paper/tims.hpp"

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

ScaleMeasurements measure_scales(const Tims& tims) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ScaleMeasurements m;
  const Eigen::ArrayXd a = tims.source.colwise().norm(), b = tims.target.colwise().norm();
  m.scale = b / a;
  m.alpha = tims.bounds / a;
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

}  // namespace gmcr::paper
