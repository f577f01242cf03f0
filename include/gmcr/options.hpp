#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "gmcr/clique.hpp"
#include "gmcr/invalid_option.hpp"
#include "gmcr/priors.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// Magnitudes that coordinates, noise bounds and scales may have: powers of them that a solve takes
/// neither overflow nor vanish. A coordinate may be 0 as well. docs/reliability.md says more.
inline constexpr double kLeastMagnitude = 1e-50;
inline constexpr double kLargestMagnitude = 1e50;  ///< see `kLeastMagnitude`

/// How the consensus is searched for.
enum class Method {
  Gmcr,   ///< many candidates judged by the objective on all correspondences, with a certificate
  Paper,  ///< the stages of the paper: scale, rotation and translation, one maximum clique each
};

/// What is maximised.
enum class Evidence {
  Distinct,  ///< correspondences that say the same thing twice share one vote
  Count,     ///< every inlier counts 1: plain maximum consensus
};

/// Whether the scale is one of the unknowns.
enum class ScaleMode {
  Known,      ///< `Options::scale` is the scale
  Estimated,  ///< the scale is searched for, inside `Options::scale_range` if given
};

/// Where the noise bound comes from.
enum class NoiseMode {
  Given,  ///< `Options::noise_bound` or `Options::noise_bounds`
  /// One bound for all is chosen from the data; the result says which and how surely. Both bounds
  /// below stay empty then.
  Estimated,
};

/// Closed interval of scales, 0 < min <= max.
struct ScaleRange {
  double min = 0;  ///< smallest scale
  double max = 0;  ///< largest scale
};

/// How far a solve has come.
struct Progress {
  const char* stage = "";  ///< name of the stage, as in `Diagnostics::stages`
  double fraction = 0;     ///< share of the stage that is done, in [0, 1]
};

/// Called now and then from the thread that called the solver; return false to stop the search,
/// which then ends as if its time were up.
using ProgressCallback = std::function<bool(const Progress&)>;

/// Every choice a caller can make, among them the priors: `gravity`, `initial_pose` and
/// `max_translation`. Names, units and defaults are the same in Python and in the tool, which read
/// them from `src/options/table.hpp`; what each means, and what it may be, stands there in words.
struct Options : Priors {
  NoiseMode noise_mode = NoiseMode::Given;  ///< given below, or estimated
  /// Bound on the noise of a target point, metres, in the range above. Required where the noise is
  /// given, unless `noise_bounds` is.
  double noise_bound = 0;
  /// One bound per correspondence, metres, each in the range above, instead of `noise_bound`.
  /// Empty: not used.
  std::vector<double> noise_bounds;

  ScaleMode scale_mode = ScaleMode::Known;  ///< `scale`, or estimated
  double scale = 1;                         ///< the scale when known, in the range above
  /// Where to search when the scale is estimated; from the data when not given.
  std::optional<ScaleRange> scale_range;

  Method method = Method::Gmcr;            ///< ours, or the stages of the paper
  Evidence evidence = Evidence::Distinct;  ///< what each inlier is worth
  /// Search for poses with at most one inlier of those that share a source or a target point. The
  /// inliers and the certificate still speak of all. Matches of clouds that share a target and are
  /// not mutual are thinned out to the one that is closest in feature space.
  bool one_to_one = false;

  /// Poses to return, >= 1: the best one and up to num_hypotheses - 1 alternatives, each with a
  /// consensus set of its own and at least a quarter of the evidence of the best (symmetric
  /// objects, repeated structure).
  int num_hypotheses = 1;
  /// Spend what is left of the time limit on proving the consensus a maximum one: a search over
  /// sets of correspondences that no pose fits jointly tightens the upper bounds.
  bool certify = false;

  int num_threads = 0;  ///< >= 0; 0 uses every core. The result does not depend on it.
  /// What a solve may use. Where one binds, the result says so in `Diagnostics::limits_hit`.
  double time_limit = 60;                             ///< seconds of wall time, > 0; infinity: any
  std::size_t memory_limit = std::size_t{4} << 30;    ///< bytes for graphs, > 0
  std::shared_ptr<const CliqueSolver> clique_solver;  ///< null: `max_clique`
  ProgressCallback progress;                          ///< null: none
  std::stop_token stop;  ///< a request, from any thread, ends the search as if its time were up

  /// @throws InvalidOption naming option and value.
  void validate() const;
};

}  // namespace gmcr
