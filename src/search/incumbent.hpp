#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "estimation/pose_constraints.hpp"
#include "gmcr/bitset_graph.hpp"
#include "gmcr/options.hpp"
#include "kernels/consistency_row.hpp"
#include "problem/objective.hpp"
#include "problem/pair_filter.hpp"
#include "problem/run.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::search {

/// What a bound speaks of.
enum class Measure { Inliers, Evidence };

/// Whether a bound leaves room for more than what is to be beaten, beyond the rounding of weights.
inline bool exceeds(double bound, double to_beat) { return bound > to_beat * (1 + 1e-12); }

/// Proven: no admitted pose has more.
struct UpperBounds {
  double inliers = 0;
  double evidence = 0;
};

/// The best pose so far, and what a better one must exceed.
class PoseSearch {
 public:
  /// Keeps the references.
  /// @param found  hypotheses that are known: their inliers are left out of the graphs, and poses
  ///   that share most of their inliers with one of them are not looked for.
  PoseSearch(problem::SolveContext& context, const problem::Objective& objective,
             const estimation::PoseConstraints& constraints, const problem::PairFilter& filter,
             std::vector<problem::Hypothesis> found = {});

  problem::SolveContext& context() { return context_; }
  const ScaleRange& scales() const { return constraints_.scales; }
  const problem::Octaves& octaves() const { return objective_.octaves(); }
  double weight(Index i, double scale) const { return objective_.weight(i, scale); }
  const kernels::CorrespondenceArrays& arrays() const { return arrays_; }

  /// Turns a clique into a pose and keeps it where it is the best one. Each clique is examined
  /// once, and so is each consensus set that cliques lead to.
  void offer(const std::vector<Index>& clique);

  /// Keeps a pose, or the nearest one that the priors admit, where it is the best one.
  void offer(const Similarity& pose);

  const std::optional<problem::Hypothesis>& best() const { return best_; }

  /// Correspondences within `factor` bounds of the best pose, ascending; none where there is none.
  std::vector<Index> near_best(double factor) const;

  /// The most that any pose examined has, of inliers of which no two share a point where
  /// one-to-one is asked for; the best one may have fewer, of more distinct evidence.
  double to_beat(Measure measure) const {
    return measure == Measure::Inliers ? max_inliers_ : max_evidence_;
  }

  /// Notes why a bound on the measure may be loose.
  void note_early_end(Measure measure, const LimitHit& hit) {
    early_ends_[measure].emplace(hit.sentence, hit.limit);
  }

  /// Tells the diagnostics of the early ends, for each bound that exceeds what was achieved.
  void explain(const UpperBounds& bounds);

  /// What each correspondence adds to the measure, at most, at scales in the range.
  std::vector<double> weights(Measure measure, const ScaleRange& scales) const;

  /// Whether bounds are to be tightened: those of further hypotheses are not reported.
  bool certifies() const { return context_.options().certify && found_.empty(); }

  /// Whether evidence differs from the number of inliers.
  bool counts_evidence() const { return objective_.is_weighted(); }

  /// Removes the edges that lead to no pose looked for.
  void filter_graph(BitsetGraph& graph, const ScaleRange& scales) const;

 private:
  refine::Rival rival() const;
  void consider(problem::Hypothesis pose);

  problem::SolveContext& context_;
  const problem::Objective& objective_;
  const estimation::PoseConstraints& constraints_;
  const problem::PairFilter& filter_;
  kernels::CorrespondenceArrays arrays_;
  std::vector<problem::Hypothesis> found_;
  std::optional<problem::Hypothesis> best_;
  int num_in_vain_ = 0;  ///< poses near the best one that were no better
  double max_inliers_ = 0;
  double max_evidence_ = 0;
  std::set<std::vector<Index>> examined_;  ///< cliques
  std::set<std::vector<Index>> reached_;   ///< consensus sets
  std::map<Measure, std::map<std::string, Limit>> early_ends_;
};

/// The consistency graph of a range of scales, less the pairs that the filter does not admit.
struct RangeGraph {
  ScaleRange scales;
  BitsetGraph graph;
};

/// @param build  returns the graph; its time is that of the stage "graph".
RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales,
                             const std::function<BitsetGraph()>& build);

/// The same from all pairs.
RangeGraph build_range_graph(PoseSearch& search, const ScaleRange& scales);

/// Offers greedy maximal cliques grown from the vertices of largest degree that neither an earlier
/// one covers nor the best pose explains, where a clique could beat the best evidence.
void grow_cliques(PoseSearch& search, const RangeGraph& range, Index max_starts);

/// Offers greedy maximal cliques of the correspondences near the best pose, until none leads to a
/// better one.
void explore_around_best(PoseSearch& search, const RangeGraph& range);

/// Searches the range's graph for a clique that measures more than what is to be beaten and offers
/// it.
/// @return proven upper bound on the measure of poses in the range, or what is to be beaten where
///   none has more.
double search_clique(PoseSearch& search, const RangeGraph& range, Measure measure,
                     std::uint64_t max_nodes);

}  // namespace gmcr::search
