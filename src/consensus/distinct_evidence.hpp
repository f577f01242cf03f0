#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "invariants/correspondences.hpp"

namespace gmcr {

/// Weights of distinct evidence (L6).
///
/// A pair with |bbar_k| <= eps_k and s |abar_k| <= eps_k constrains neither scale nor rotation: its
/// two members are one piece of evidence seen twice. Correspondence i weighs
///   w_i(s) = 1 / (1 + number of such partners of i at scale s).
class DistinctEvidence {
 public:
  /// Finds all pairs that can be partners at some scale. Cost O(N log N + pairs that are near along
  /// x).
  /// @param max_bytes  for the list of partners. Where it does not suffice, `complete()` is false
  /// and
  ///   every weight is 1.
  DistinctEvidence(const Correspondences& correspondences, std::size_t max_bytes);

  bool complete() const { return complete_; }

  /// w_i(scale). Cost O(log number of partners).
  double weight(Index i, double scale) const;

 private:
  bool complete_ = true;
  std::vector<std::size_t> first_;  ///< N + 1 offsets into max_scales_
  std::vector<double>
      max_scales_;  ///< per correspondence, descending: up to which scale a partner is one
};

}  // namespace gmcr
