#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "gmcr/types.hpp"
#include "noise/false_alarms.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::noise {

/// Search for the tightest noise bound under which the consensus of a pose is about as sure as
/// under any. Bounds are metres.
class BoundSearch {
 public:
  /// @param source, target  N >= 3 correspondences, none twice.
  /// @param options         of the caller; half of its time is for the search. Kept by reference.
  BoundSearch(const PointsRef& source, const PointsRef& target, const Options& options);

  /// Tries the ladder of bounds, then those that its poses lead to.
  void run();

  /// The bound for the best pose met; the loosest rung where there is none.
  double chosen_bound() const;

  NoiseEstimate estimate() const;

  bool late() const { return late_; }            ///< the time ended the search
  bool cancelled() const { return cancelled_; }  ///< the caller ended it
  std::uint64_t num_clique_nodes() const { return num_clique_nodes_; }

 private:
  /// A bound that was tried, and where it led to.
  struct Trial {
    double bound = 0;
    std::optional<Similarity> pose;
    FalseAlarms alarms;
  };

  /// The set of correspondences that decides on the bound.
  struct Choice {
    std::size_t trial = 0;
    Index count = 0;      ///< correspondences in the set
    double residual = 0;  ///< the largest of theirs, metres
    double log10 = 0;     ///< of its false alarms
  };

  std::vector<double> ladder() const;
  void climb(Index most);
  void choose();
  Index selection_size(double bound, Index most) const;
  Options cheap_options(double bound) const;
  bool may_go_on();
  void try_bound(double bound, Index count);
  bool is_best_pose(const Similarity& pose) const;
  std::pair<double, double> stable_bounds() const;

  const Options& options_;
  parallel::Deadline deadline_;
  Points source_, target_;
  PairDistances source_distances_, target_distances_;
  std::vector<double> length_differences_;  ///< of pairs of correspondences, ascending, metres
  double rounding_ = 0;                     ///< of the coordinates, metres
  std::shared_ptr<const CliqueSolver> clique_solver_;
  std::vector<Trial> trials_;
  std::optional<Choice> choice_;
  double num_steps_ = 1;  ///< expected number of trials
  bool late_ = false, cancelled_ = false;
  std::uint64_t num_clique_nodes_ = 0;
};

}  // namespace gmcr::noise
