#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "estimation/closed_forms/moments.hpp"
#include "estimation/fits/minimax_fit.hpp"
#include "geometry/correspondence_arrays.hpp"
#include "gmcr/options.hpp"

namespace gmcr::proof {

/// Which sets of correspondences no transform can hold within their bounds.
///
/// If one holds all of a set, any weighted mean of the squared relative residuals is at most 1 for
/// it, and so is the least mean of all transforms, which is known in closed form
/// (`least_squares_bound`). Weights that make the least mean exceed 1 exclude the set.
class InfeasibleSets {
 public:
  /// Keeps the reference. @param arrays  with bounds that cover the rounding of residuals.
  InfeasibleSets(const geometry::CorrespondenceArrays& arrays, const ScaleRange& scales);

  /// Members that exclude each other.
  struct Conflict {
    std::vector<Index> members;      ///< few, if few are found; empty: no conflict was found
    std::optional<Similarity> pose;  ///< holds all that were asked about
  };
  Conflict find_conflict(const std::vector<Index>& members) const;

  /// Moments with weights that add up to 1.
  estimation::Moments mean_moments(const std::vector<Index>& members,
                                   const Eigen::ArrayXd& weights) const;

  /// Moments with the weights of some minimax fits, which bring the least mean close to the limit;
  /// nullopt where no transform holds all of the members.
  std::optional<estimation::Moments> minimax_moments(const std::vector<Index>& members) const;

  /// Whether the least mean leaves room for some members and others together.
  /// @param members        `mean_moments` of the members.
  /// @param members_share  weight of the members in the mean, in (0, 1); the others share the rest.
  bool may_hold(const estimation::Moments& members, double members_share,
                std::initializer_list<Index> others) const;

  estimation::MinimaxFit fit(const std::vector<Index>& members) const;

 private:
  static bool excludes(estimation::MinimaxFit& fit);
  bool settle(estimation::MinimaxFit& fit) const;

  const geometry::CorrespondenceArrays& arrays_;
  ScaleRange scales_;
  std::vector<estimation::Moments> moments_;  ///< of each correspondence, in units of its bound
};

}  // namespace gmcr::proof
