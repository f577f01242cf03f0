#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "geometry/correspondence_arrays.hpp"
#include "gmcr/bitset_graph.hpp"
#include "gmcr/options.hpp"
#include "gmcr/similarity.hpp"
#include "parallel/deadline.hpp"
#include "problem/correspondences.hpp"
#include "problem/objective/measure.hpp"
#include "proof/infeasible_sets.hpp"

namespace gmcr::proof {

/// Exact search for the heaviest set of correspondences that one transform holds within bounds.
///
/// A clique of the consistency graph may still fit no transform: pairwise distances admit mirrored
/// and loosely fitting sets. Whether all of a set fit is decided by a weighted least-squares
/// alignment, whose minimum over all of SE(3) is a closed form: where the weighted mean of the
/// squared relative residuals exceeds 1, no transform holds them all. So branch and bound over the
/// vertices of the graph, as for a maximum clique, drops the pairs that do not fit jointly with the
/// vertices chosen so far; and where a whole clique is left, a few of its members that exclude each
/// other are found by minimax fits and given up in turn (as in the tree search of Chin et al.
/// 2015).
class ConsensusSearch {
 public:
  /// Takes a pose that holds more than was to be beaten; returns what is to be beaten from now on.
  using TryPose = std::function<double(const problem::CentredPose&)>;

  /// What a search may take. Work is counted, so that the bits stay the same: a least-squares bound
  /// is one, a minimax fit `kWorkOfFit`.
  struct Effort {
    const parallel::Deadline& deadline;
    std::uint64_t work = std::numeric_limits<std::uint64_t>::max();
  };

  /// Keeps the references.
  /// @param arrays   correspondences with bounds that cover the rounding of residuals.
  /// @param graph    consistency graph of the scales.
  /// @param weights  one a correspondence, > 0, at least its evidence at each of the scales.
  ConsensusSearch(const geometry::CorrespondenceArrays& arrays, const BitsetGraph& graph,
                  std::span<const double> weights, const ScaleRange& scales, TryPose try_pose,
                  const Effort& effort);

  /// @return upper bound on the weight of every set that a transform holds, or what was to be
  ///   beaten in the end, where none weighs more. Valid also where the effort ended it.
  double run(double to_beat);

  /// Of the effort.
  std::uint64_t work_left() const { return work_left_; }

 private:
  /// Sets that hold all of `kept` and some of `open`.
  struct Node {
    std::vector<Index> kept;
    std::vector<Index> open;
    BitsetGraph graph;  ///< over `open`: the pairs that may fit jointly with `kept`
    double kept_weight = 0;
  };
  double search(Node& node);
  double branch(const Node& node);
  Node child(const Node& node, std::span<const Index> before, Index chosen) const;
  /// Vertices of a graph over `open` that sets of more than `to_beat_` may hold, ascending; others
  /// too where the deadline passes.
  std::vector<Index> candidates(const BitsetGraph& graph, const std::vector<Index>& open,
                                double kept_weight) const;
  void drop_light(Node& node) const;
  void drop_infeasible(Node& node);
  void drop_infeasible_with_many(Node& node);
  void sort_by_fit(Node& node) const;
  void keep_open(Node& node, const std::vector<bool>& keep) const;
  void select_open(Node& node, const std::vector<Index>& vertices) const;
  double resolve(const std::vector<Index>& kept, const std::vector<Index>& open);
  double loss_bound(const std::vector<Index>& kept, std::vector<Index> open, double enough);
  InfeasibleSets::Conflict find_conflict(const std::vector<Index>& members);
  double weight_of(const std::vector<Index>& members) const;
  bool exceeds(double weight) const { return problem::exceeds(weight, to_beat_); }
  void spend(std::uint64_t work) { work_left_ -= std::min(work, work_left_); }
  bool is_over() const { return work_left_ == 0 || deadline_.expired(); }

  const BitsetGraph& graph_;
  std::span<const double> weights_;
  TryPose try_pose_;
  const parallel::Deadline& deadline_;
  std::uint64_t work_left_;
  InfeasibleSets sets_;
  double to_beat_ = 0;
};

}  // namespace gmcr::proof
