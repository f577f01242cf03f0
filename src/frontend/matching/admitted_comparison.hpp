#pragma once

#include <cstdint>
#include <vector>

#include "frontend/matching/match_priors.hpp"
#include "kernels/features/nearest_features.hpp"

namespace gmcr::frontend {

/// Columns of a cloud that have a feature, and these.
struct Described {
  const std::vector<Index>& columns;  ///< ascending
  const kernels::IntegerFeatures& features;
};

/// Index of `NearestFeature` where the priors admit no partner.
inline constexpr std::int32_t kNoPartner = -2;

/// Compares each source with the targets that the priors admit, and gives what
/// `kernels::nearest_features` gives where they admit all.
class AdmittedComparison {
 public:
  /// Keeps references to the columns of the source and to the priors. Cost O(N + M).
  AdmittedComparison(const Described& source, const Described& target, const MatchPriors& priors);

  /// @param source      number among the features.
  /// @param of_targets  updated; sources come in ascending order.
  /// Cost O(targets that are admitted).
  kernels::NearestFeature nearest(Index source, kernels::NearestSources& of_targets) const;

 private:
  /// A column a feature, filled up with zeros to whole registers.
  using Columns = Eigen::Matrix<std::int16_t, 40, Eigen::Dynamic>;
  static Columns columns_of(const kernels::IntegerFeatures& features);

  const std::vector<Index>& source_columns_;
  const MatchPriors& priors_;
  Columns source_, target_;
  std::vector<std::int32_t> number_of_;  ///< of a target column among the features, or -1
};

}  // namespace gmcr::frontend
