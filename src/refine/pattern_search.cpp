#include "refine/pattern_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "refine/pose_neighbourhood.hpp"

namespace gmcr::refine {
namespace {

/// A turn, a shift and a change of scale, in units of the displacement that they cause.
using Motion = Eigen::Matrix<double, 7, 1>;

/// Along each axis and askew.
std::vector<Motion> directions(bool with_scale) {
  constexpr int kNumAskew = 4;
  const Index dimension = with_scale ? 7 : 6;
  std::vector<Motion> all;
  for (Index axis = 0; axis < dimension; ++axis) all.push_back(Motion::Unit(axis));
  std::mt19937_64 random(1);
  const double span = static_cast<double>(std::mt19937_64::max());
  for (int k = 0; k < kNumAskew; ++k) {
    Motion askew = Motion::Zero();
    for (Index axis = 0; axis < dimension; ++axis) {
      askew[axis] = 2 * (static_cast<double>(random()) / span) - 1;
    }
    all.push_back(askew.normalized());
  }
  return all;
}

/// Follows the best score among motions about the centroid of the inliers.
class PatternSearch {
 public:
  PatternSearch(const PoseNeighbourhood& near, const problem::Hypothesis& start)
      : near_(near), scales_(near.problem().scales()), pose_(start.pose) {
    const problem::Correspondences& c = near.problem().correspondences();
    centre_.setZero();
    for (const Index i : start.inliers) centre_ += c.target.col(i);
    centre_ /= static_cast<double>(start.inliers.size());
    double squared_radius = 0;
    for (const Index i : start.inliers) {
      squared_radius += (c.target.col(i) - centre_).squaredNorm();
      bound_ += c.bounds[i];
    }
    radius_ = std::sqrt(squared_radius / static_cast<double>(start.inliers.size()));
    bound_ /= static_cast<double>(start.inliers.size());
    score_ = near.score(near.relative_squares(pose_), pose_.scale());
  }

  const problem::CentredPose& run() {
    constexpr int kMaxPasses = 1000;
    constexpr double kMaxVisits = 3e5;  // of correspondences
    if (!(radius_ > 0)) return pose_;
    int passes = static_cast<int>(
        std::min<double>(kMaxPasses, kMaxVisits / static_cast<double>(near_.indices().size())));
    const std::vector<Motion> all = directions(scales_.min < scales_.max);
    for (const double step : {0.4, 0.2, 0.1, 0.05, 0.025}) {
      bool improved = true;
      while (improved) {
        improved = false;
        for (const Motion& direction : all) {
          for (const double signed_step : {step, -step}) {
            while (passes-- > 0 && try_motion(signed_step * direction)) improved = true;
            if (passes <= 0) return pose_;
          }
        }
      }
    }
    return pose_;
  }

 private:
  /// Tries a motion and keeps it where it is better.
  bool try_motion(const Motion& motion) {
    const problem::CentredPose next{apply(motion, pose_.similarity)};
    const Score score = near_.score(near_.relative_squares(next), next.scale());
    if (!score.is_better_than(score_)) return false;
    pose_ = next;
    score_ = score;
    return true;
  }

  /// The pose turned, shifted and scaled about the centre.
  Similarity apply(const Motion& motion, const Similarity& pose) const {
    const Eigen::Vector3d half = motion.head<3>() * (bound_ / radius_ / 2);
    // a small turn without sines, whose last bit differs from machine to machine
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(1, half.x(), half.y(), half.z()).normalized().toRotationMatrix();
    Similarity next = pose;
    if (motion[6] != 0) {
      next.scale =
          std::clamp(pose.scale * (1 + motion[6] * bound_ / radius_), scales_.min, scales_.max);
    }
    next.rotation = turn * pose.rotation;
    next.translation = (next.scale / pose.scale) * (turn * (pose.translation - centre_)) + centre_ +
                       bound_ * motion.segment<3>(3);
    return next;
  }

  const PoseNeighbourhood& near_;
  const ScaleRange scales_;
  problem::CentredPose pose_;
  Score score_;
  Eigen::Vector3d centre_;
  double radius_ = 0, bound_ = 0;
};

}  // namespace

problem::Hypothesis climb_by_motions(const problem::Problem& problem, problem::Hypothesis best) {
  constexpr double kNear = 1.6;
  if (best.num_inliers() < problem::kMinInliers || !problem.constraints().priors.admit_all())
    return best;
  const PoseNeighbourhood near(problem, best.pose, kNear);
  problem::Hypothesis next = problem.objective().judge(PatternSearch(near, best).run());
  return problem::is_better(next, best) ? next : best;
}

}  // namespace gmcr::refine
