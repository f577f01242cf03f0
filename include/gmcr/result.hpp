#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// What a solve came to.
enum class Status {
  Ok,  ///< `target_from_source` and `inliers` are the answer
  /// Fewer than 3, or than the priors leave to be determined: 2 where gravity or the rotation is
  /// known, 1 where rotation and scale are. Nothing was estimated, the transform is the identity.
  TooFewCorrespondences,
  /// No pose has as many inliers, or the noise was to be estimated and chance explains all that
  /// have; the transform is the identity.
  NoConsensus,
  Degenerate,  ///< the inliers do not determine the transform; it is one of many that fit
};

/// How far a pose can be relied on.
enum class Verdict {
  Trusted,    ///< much more agrees than chance explains
  Doubtful,   ///< plausible, but check it
  Untrusted,  ///< what chance alone would give, or no pose at all
};

/// "trusted", "doubtful" or "untrusted".
const char* to_string(Verdict verdict);

/// How far the evidence of the consensus can be from the best possible.
struct EvidenceCertificate {
  double lower = 0;        ///< that of `Certificate::inliers`
  double upper = 0;        ///< proven: no transform has more evidence
  bool certified = false;  ///< upper <= lower to rounding: no transform has more
};

/// How far the consensus can be from the best possible, in numbers of inliers.
///
/// Speaks of the transforms that the priors admit and, where the scale is estimated, of the scales
/// that were searched (`Diagnostics::scale_range`). The transform that holds the most is given with
/// its consensus set: it lies near the returned one, which is the likeliest there and may hold
/// fewer.
struct Certificate {
  Index lower = 0;  ///< size of `inliers`
  /// Proven: no transform has more inliers. The number of all that the priors admit where memory or
  /// time let only a sample of them be searched, as `Diagnostics::limits_hit` says.
  Index upper = 0;
  bool certified = false;  ///< lower == upper: the consensus is a maximum one
  /// The same for what was maximised; with `Evidence::Count` the same numbers.
  EvidenceCertificate evidence;
  Similarity target_from_source;  ///< the transform that achieves `lower` and `evidence.lower`
  std::vector<Index> inliers;     ///< its consensus set, ascending
};

/// How well the transform is determined. By matches, from the residuals within 3 noise bounds:
/// first-order covariance of the likeliest fit, the noise of b_i with a standard deviation
/// proportional to noise_bound_i, its level estimated from the residuals themselves, and enlarged
/// where the residuals of near matches go together. Exact data leaves the rounding of the target
/// points. Of two clouds whose pose was refined, by the surfaces: the scatter of what their parts
/// say, over how much the pose is held; along motions that they leave open, by the matches.
///
/// The parameters are those of  x -> exp(sigma) s exp([omega]x) R x + t + tau, in this order: omega
/// (3, radians, target frame, applied after R), tau (3, metres), and where the scale was estimated
/// sigma (1, relative change of the scale).
struct Covariance {
  Eigen::MatrixXd matrix;  ///< 6 x 6 (rigid) or 7 x 7 (similarity), symmetric
  /// Variances along the principal directions, square metres, ascending, of the motion of the
  /// inliers (6 or 7): rotation about and scale from their centroid are multiplied by their RMS
  /// distance from it, both weighted as in the fit. A last one much above the others is that of a
  /// turn about a line near all inliers, which they hardly determine.
  Eigen::VectorXd eigenvalues;
};

/// How a pose graph wants the covariance of a transform.
enum class PoseGraph {
  /// GTSAM, of T in T Exp(xi): rotation first, in the frame of the source.
  Gtsam,
  /// ROS (geometry_msgs/PoseWithCovariance): translation first, then the rotation about the axes of
  /// the target frame.
  Ros,
};

/// Covariance of the rotation and the translation, whatever the scale.
/// @param target_from_source  the transform that it is of.
Eigen::Matrix<double, 6, 6> pose_graph_covariance(const Covariance& covariance,
                                                  const Similarity& target_from_source,
                                                  PoseGraph convention);

/// The noise bound that was chosen from the data, and how sure that is.
struct NoiseEstimate {
  /// Metres: the tightest bound that keeps a consensus about as sure as any bound. For noise in a
  /// ball its radius, for Gaussian noise 1.7 to 2.5 standard deviations.
  double noise_bound = 0;
  /// Bounds over which the consensus is stable: a search with any of those that were tried between
  /// them leads to the same pose. Metres.
  double stable_min = 0;
  double stable_max = 0;  ///< see `stable_min`
  /// log10 of the expected number of consensus sets as large and as tight among random
  /// correspondences; the more negative, the surer. Above 0 chance explains it.
  double log10_false_alarms = 0;
};

/// Another pose that many correspondences agree on.
struct Alternative {
  Similarity target_from_source;  ///< as in `Result`
  std::vector<Index> inliers;     ///< as in `Result`
  double evidence = 0;            ///< as in `Result`
};

/// Wall time of a stage of the work.
struct StageTime {
  std::string name;    ///< such as "clique"; `stage_in_words` says it for people
  double seconds = 0;  ///< summed over all times it ran
};

/// What ended a part of the work before it was complete.
enum class Limit {
  Time,     ///< `Options::time_limit`
  Stopped,  ///< the caller, through `Options::stop` or `Options::progress`
  /// `Options::memory_limit`: also where the graph of all correspondences exceeds it, so that a
  /// sample was searched, and only the poses were judged on all.
  Memory,
  CliqueSearch,     ///< a search for a maximum clique ended before its proof
  EvidenceSearch,   ///< a search for the clique of most evidence ended before its proof
  ScaleSearch,      ///< the branch and bound over the scale ended before its proof
  ConsensusSearch,  ///< the search over consensus sets (`Options::certify`) ended before its proof
};

/// All of them, in this order.
inline constexpr Limit kLimits[] = {
    Limit::Time,           Limit::Stopped,     Limit::Memory,         Limit::CliqueSearch,
    Limit::EvidenceSearch, Limit::ScaleSearch, Limit::ConsensusSearch};

/// A limit that made the work less than complete.
struct LimitHit {
  Limit limit = Limit::Time;  ///< which
  std::string sentence;       ///< what it ended, for people

  bool operator==(const LimitHit&) const = default;  ///< by both
};

/// What the solver did.
struct Diagnostics {
  std::vector<StageTime> stages;  ///< in order of first use; times of repeated stages are summed
  double total_seconds = 0;       ///< wall time of the whole call
  Index num_correspondences = 0;  ///< in the input
  Index num_used = 0;             ///< that the priors admit
  ScaleRange scale_range;         ///< scales that were searched; min == max: it was known
  Index num_candidates = 0;       ///< poses judged on all correspondences
  Index num_scale_ranges = 0;     ///< scale ranges whose graph was searched
  std::uint64_t num_clique_nodes = 0;  ///< search nodes of all clique searches
  int num_threads = 0;                 ///< that worked
  std::vector<LimitHit> limits_hit;    ///< each sentence once; empty: the work is complete
};

/// What a solve of correspondences found.
struct Result {
  Status status = Status::TooFewCorrespondences;  ///< whether there is a pose
  std::string status_reason;                      ///< empty when Ok
  /// The likeliest transform near the one that holds the most (`Certificate`), from the residuals
  /// of all correspondences within 3 noise bounds: the most accurate one.
  Similarity target_from_source;
  /// Exactly the correspondences whose residual |b - (s R a + t)| is within the noise bound;
  /// ascending indices into the caller's input.
  std::vector<Index> inliers;
  /// Sum of the evidence of the inliers: their number with `Evidence::Count`, less where some of
  /// them are the same evidence seen twice with `Evidence::Distinct`.
  double evidence = 0;
  /// What the matches say of the pose: whether chance explains so many inliers, whether these are
  /// few things said often, and whether a reflection fits better.
  Verdict verdict = Verdict::Untrusted;
  std::string verdict_reason;  ///< one sentence
  /// log10 of the expected number of consensus sets as large among random matches of the same
  /// points; the more negative, the surer. Above 0 chance explains it; 0 where there is no pose.
  /// Where the pose was found at another noise bound than the given one, as chance explains what
  /// agrees there, it speaks of that bound; `verdict_reason` names it.
  double log10_false_alarms = 0;
  Certificate certificate;  ///< how far from the best possible this can be
  /// Scales at which all pairs of inliers agree (L1); contains that of the transform. min == max
  /// where the scale is known; 0 to infinity where all inliers coincide in the source. Wider than
  /// said where the time budget ended the work.
  ScaleRange consistent_scales{1, 1};
  std::optional<Covariance> covariance;  ///< where the status is Ok; needs 3 matches near, and time
  /// Where several hypotheses were asked for: the next best poses, by descending evidence. Each
  /// shares at most half of its inliers with any better one.
  std::vector<Alternative> alternatives;
  /// Where the noise was to be estimated and there are at least 3 distinct correspondences.
  std::optional<NoiseEstimate> noise_estimate;
  Diagnostics diagnostics;  ///< stages, counts, limits that were hit

  /// Evidence of the best alternative over that of the result, in [0, 1]; near 1: ambiguous. 0
  /// where no alternative was found.
  double runner_up_ratio() const {
    return alternatives.empty() ? 0 : std::min(1.0, alternatives.front().evidence / evidence);
  }
};

/// "ok", "too_few_correspondences", "no_consensus" or "degenerate".
const char* to_string(Status status);

/// "time", "stopped", "memory", "clique_search", "evidence_search", "scale_search" or
/// "consensus_search".
const char* to_string(Limit limit);

}  // namespace gmcr
