#include "search/sampled_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "estimation/constrained_fit.hpp"
#include "kernels/residuals.hpp"
#include "problem/selection.hpp"

namespace gmcr::search {
namespace {

constexpr Index kMaxDraws = 20'000;
constexpr Index kMaxFits = 500;
constexpr Index kJudges = 1024;   ///< correspondences that a fit is judged on
constexpr double kNear = 2;       ///< bounds within which they suit: a fit to few is rough
constexpr double kMissed = 1e-3;  ///< chance that all draws so far missed a better pose

/// Scales at which a pair of correspondences agrees, of those in the range (L1).
ScaleRange agreeing_scales(const problem::Correspondences& c, Index i, Index j,
                           const ScaleRange& scales) {
  const double a = (c.source.col(j) - c.source.col(i)).norm();
  const double b = (c.target.col(j) - c.target.col(i)).norm();
  const double e = c.bounds[i] + c.bounds[j];
  if (!(a > 0)) return b <= e ? scales : ScaleRange{1, 0};
  return {std::max(scales.min, (b - e) / a), std::min(scales.max, (b + e) / a)};
}

/// Draws of a few different correspondences.
class Draws {
 public:
  Draws(Index num_correspondences, Index count) : n_(num_correspondences), count_(count) {}

  /// Number k, if its members differ and agree pair by pair at one scale of the problem.
  std::optional<std::vector<Index>> agreeing(const problem::Problem& problem, Index k) const {
    std::vector<Index> members;
    ScaleRange scales = problem.scales();
    for (Index m = 0; m < count_; ++m) {
      const auto place = problem::mixed(static_cast<std::uint64_t>(k * count_ + m));
      const auto next = static_cast<Index>(place % static_cast<std::uint64_t>(n_));
      for (const Index member : members) {
        if (member == next) return std::nullopt;
        scales = agreeing_scales(problem.correspondences(), member, next, scales);
        if (!(scales.min <= scales.max)) return std::nullopt;
      }
      members.push_back(next);
    }
    return members;
  }

 private:
  Index n_, count_;
};

/// Some of the correspondences, spread evenly, to judge poses by.
class Judges {
 public:
  explicit Judges(const problem::Correspondences& c)
      : chosen_(problem::stratified_selection(c.size(), kJudges)),
        source_(c.source(Eigen::all, chosen_).transpose()),
        target_(c.target(Eigen::all, chosen_).transpose()),
        squared_bounds_(c.bounds(chosen_).square()) {}

  /// Share of them that a pose suits.
  double share(const Similarity& pose) const {
    const auto near = kernels::consensus(pose, source_, target_, squared_bounds_, kNear * kNear);
    return static_cast<double>(near.indices.size()) / static_cast<double>(chosen_.size());
  }

 private:
  std::vector<Index> chosen_;
  Eigen::MatrixX3d source_, target_;
  Eigen::ArrayXd squared_bounds_;
};

/// Draws after which one of right correspondences alone was hardly missed, where so many are right.
double enough_draws(double share_right, Index count) {
  const double all_right = std::pow(share_right, static_cast<double>(count));
  return all_right < 1 ? std::log(kMissed) / std::log1p(-all_right) : 1;
}

}  // namespace

std::optional<problem::CentredPose> sampled_start(const problem::Problem& problem) {
  const problem::Correspondences& c = problem.correspondences();
  const Index count = problem.min_inliers();
  const Draws draws(c.size(), count);
  const Judges judges(c);
  std::optional<problem::CentredPose> best;
  double best_share = 0;
  Index num_fits = 0;
  for (Index k = 0; k < kMaxDraws && num_fits < kMaxFits; ++k) {
    if (best && static_cast<double>(k) >= enough_draws(best_share, count)) break;
    const auto members = draws.agreeing(problem, k);
    if (!members) continue;
    ++num_fits;
    const auto fit =
        estimation::fit_pose(c.source, c.target, c.bounds, *members, problem.constraints());
    if (!fit) continue;
    const double share = judges.share(*fit);
    if (best && share <= best_share) continue;
    best = problem::CentredPose{*fit};
    best_share = share;
  }
  return best;
}

}  // namespace gmcr::search
