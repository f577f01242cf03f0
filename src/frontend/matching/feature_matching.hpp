#pragma once

#include <compare>
#include <vector>

#include "frontend/features/fpfh.hpp"
#include "frontend/matching/match_priors.hpp"
#include "gmcr/types.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

struct MatchingOptions {
  bool mutual = true;   ///< each is the other's nearest
  float max_ratio = 1;  ///< of the distances to the nearest and the second nearest, (0, 1]
  int num_threads = 0;
  bool one_to_one = false;  ///< of the matches of a target, the closest only
  parallel::Deadline deadline = parallel::Deadline::never();  ///< ends the search where it is
  const MatchPriors* priors = nullptr;  ///< of the same columns; null: any two may match
  /// More pairs than that take longer than an index that leaves most of them out (decision 55).
  double most_pairs = 1e9;
};

struct FeatureMatch {
  Index source;
  Index target;

  auto operator<=>(const FeatureMatch&) const = default;
};

struct FeatureMatches {
  std::vector<FeatureMatch> pairs;
  double share_compared = 1;  ///< of the source features that have been compared with all
};

/// Nearest target feature of each source feature, by Euclidean distance of the features rounded to
/// 1/64 (a histogram sums to 200); ties to the smallest index. Columns that are 0 have no feature
/// and match nothing.
///
/// Compares all with all: in 33 dimensions a k-d tree visits most of the points anyway, and the
/// loop runs at the speed of the vector units (`kernels::nearest_features`). Above `most_pairs` it
/// compares those in like places (`nearest_in_places`), with priors those that they admit.
/// @return in ascending order of the source; where the deadline ended the search, of a part of it.
/// Cost O(N M), or O((N + M) sqrt(M)). Deterministic for any thread count.
FeatureMatches match_features(const Features& source, const Features& target,
                              const MatchingOptions& options);

/// The matches of both, each once, in ascending order of source and target.
std::vector<FeatureMatch> pooled(std::vector<FeatureMatch> matches,
                                 const std::vector<FeatureMatch>& more);

}  // namespace gmcr::frontend
