#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"

namespace gmcr {

enum class Status {
  Ok,                     ///< `target_from_source` and `inliers` are the answer
  TooFewCorrespondences,  ///< fewer than 3; nothing was estimated, the transform is the identity
  NoConsensus,            ///< no pose has 3 inliers; the transform is the identity
  Degenerate,  ///< the inliers do not determine the transform; it is one of many that fit
};

/// How far the consensus can be from the best possible, in numbers of inliers.
///
/// Speaks of the correspondences that were used and, where the scale is estimated, of the scales
/// that were searched (`Diagnostics::scale_range`).
struct Certificate {
  Index lower = 0;         ///< achieved by the returned transform
  Index upper = 0;         ///< proven: no transform has more inliers
  bool certified = false;  ///< lower == upper: the consensus is a maximum one
};

struct StageTime {
  std::string name;
  double seconds = 0;
};

/// What the solver did.
struct Diagnostics {
  std::vector<StageTime> stages;  ///< in order of first use; times of repeated stages are summed
  double total_seconds = 0;
  Index num_correspondences = 0;       ///< in the input
  Index num_used = 0;                  ///< after the one-to-one test
  ScaleRange scale_range;              ///< scales that were searched; min == max: it was known
  Index num_candidates = 0;            ///< poses judged on all correspondences
  Index num_scale_ranges = 0;          ///< scale ranges whose graph was searched
  std::uint64_t num_clique_nodes = 0;  ///< search nodes of all clique searches
  int num_threads = 0;
  /// One sentence for each limit that made the work less than complete; empty: none did.
  std::vector<std::string> limits_hit;
};

struct Result {
  Status status = Status::TooFewCorrespondences;
  std::string status_reason;  ///< empty when Ok
  Similarity target_from_source;
  /// Exactly the correspondences whose residual |b - (s R a + t)| is within the noise bound (over
  /// the threshold); ascending indices into the caller's input.
  std::vector<Index> inliers;
  /// Sum of the evidence of the inliers: their number with `Evidence::Count`, less where some of
  /// them are the same evidence seen twice with `Evidence::Distinct`.
  double evidence = 0;
  Certificate certificate;
  Diagnostics diagnostics;
};

/// "ok", "too_few_correspondences", "no_consensus" or "degenerate".
const char* to_string(Status status);

}  // namespace gmcr
