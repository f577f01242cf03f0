#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "problem/objective/measure.hpp"
#include "problem/problem.hpp"
#include "problem/run.hpp"
#include "refine/local_optimisation.hpp"

namespace gmcr::search {

using problem::exceeds;
using problem::Measure;
using problem::PerMeasure;
using problem::StageTimer;

/// The best pose so far, and what a better one must exceed.
class PoseSearch {
 public:
  /// Keeps the references.
  /// @param left_out  hypotheses that are known, the best first: what they explain is left out of
  ///   the graphs, and neither poses that share most of their inliers with one of them are looked
  ///   for nor such as have too little of the evidence of the best to be an alternative to it.
  PoseSearch(const problem::Problem& problem, problem::Run& run,
             std::vector<problem::Hypothesis> left_out = {});

  const problem::Problem& problem() const { return problem_; }
  problem::Run& run() const { return run_; }
  const std::vector<problem::Hypothesis>& left_out() const { return left_out_; }

  /// Turns a clique into a pose and keeps it where it is the best one. Each clique is examined
  /// once, and so is each consensus set that cliques lead to.
  void try_clique(const std::vector<Index>& clique);

  /// Keeps a pose, or the nearest one that the priors admit, where it is the best one.
  void try_pose(const problem::CentredPose& pose);

  /// Keeps a pose that was fitted to all correspondences as one to answer with. It does not reach
  /// for more, which takes longer.
  void start_from(const problem::Hypothesis& pose);

  /// Keeps what reaching for more makes of a pose, where it is the best one.
  void offer(problem::Hypothesis pose);

  const std::optional<problem::Hypothesis>& best() const { return best_; }

  /// Correspondences within `factor` bounds of the best pose, ascending; none where there is none.
  std::vector<Index> near_best(double factor) const;

  /// The most that any pose examined has, of inliers of which no two share a point where
  /// one-to-one is asked for, or that an alternative needs; the best one may have fewer, of more
  /// distinct evidence.
  double to_beat(Measure measure) const { return most_.of(measure); }

  /// Notes why a bound on the measure may be loose.
  void note_early_end(Measure measure, const LimitHit& hit) {
    early_ends_[measure].emplace(hit.sentence, hit.limit);
  }

  /// Tells the diagnostics of the early ends, for each bound that exceeds what was achieved.
  void report_early_ends(const PerMeasure& bounds);

 private:
  refine::Incumbent incumbent() const;
  void note(const problem::Hypothesis& reached);

  const problem::Problem& problem_;
  problem::Run& run_;
  std::vector<problem::Hypothesis> left_out_;
  std::optional<problem::Hypothesis> best_;
  int num_in_vain_ = 0;                    ///< poses near the best one that were no better
  double least_evidence_ = 0;              ///< of a pose that is looked for
  PerMeasure most_;                        ///< of all poses examined
  std::set<std::vector<Index>> examined_;  ///< cliques
  std::set<std::vector<Index>> reached_;   ///< consensus sets
  std::map<Measure, std::map<std::string, Limit>> early_ends_;
};

}  // namespace gmcr::search
