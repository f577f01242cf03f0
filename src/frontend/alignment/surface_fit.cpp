#include "frontend/alignment/surface_fit.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "frontend/alignment/plane_pairs.hpp"

namespace gmcr::frontend {
namespace {

/// Agreement of normals at 26 and at 37 degrees between them.
constexpr double kAlike = 0.8;
constexpr double kMeeting = 0.6;

using Motion = Eigen::Matrix<double, 6, 1>;  // turn times the lever, shift
using MotionMatrix = Eigen::Matrix<double, 6, 6>;

struct MeetingCounts {
  double near = 0;     ///< samples with a pair
  double meeting = 0;  ///< whose normals agree
  double alike = 0;    ///< closely
};

MeetingCounts count(const PlanePairs& pairs) {
  MeetingCounts counts;
  for (const PlanePair& pair : pairs.pairs) {
    counts.near += 1;
    counts.meeting += pair.agreement > kMeeting;
    counts.alike += pair.agreement > kAlike;
  }
  return counts;
}

/// Mean square motion along the normals of what meets, of each unit motion about its centroid.
MotionMatrix stiffness_of(const std::vector<PlanePair>& pairs) {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double num_meeting = 0;
  for (const PlanePair& pair : pairs) {
    if (pair.agreement <= kMeeting) continue;
    centroid += pair.moved;
    num_meeting += 1;
  }
  if (num_meeting == 0) return MotionMatrix::Zero();
  centroid /= num_meeting;
  double squares = 0;
  for (const PlanePair& pair : pairs) {
    if (pair.agreement > kMeeting) squares += (pair.moved - centroid).squaredNorm();
  }
  const double lever = std::sqrt(squares / num_meeting);
  MotionMatrix stiffness = MotionMatrix::Zero();
  if (!(lever > 0)) return stiffness;
  for (const PlanePair& pair : pairs) {
    if (pair.agreement <= kMeeting) continue;
    Motion along;
    along << (pair.moved - centroid).cross(pair.normal) / lever, pair.normal;
    stiffness += along * along.transpose();
  }
  return stiffness / num_meeting;
}

/// The weak motions, told apart into turns and shifts: any mixture of equally weak ones is as weak.
std::vector<WeakDirection> weak_directions_of(const std::vector<PlanePair>& pairs) {
  const Eigen::SelfAdjointEigenSolver<MotionMatrix> solver(stiffness_of(pairs));
  const Index num_weak = (solver.eigenvalues().array() < kWeakStiffness).count();
  if (num_weak == 0) return {};
  // Of their span, the motions with the least and the most of a turn: the last eigenvectors of
  // (share of a turn, within the span) + 1, which is 0 outside.
  const auto weak = solver.eigenvectors().leftCols(num_weak);
  const MotionMatrix onto = weak * weak.transpose();
  const auto turns = onto.topRows<3>();
  const Eigen::SelfAdjointEigenSolver<MotionMatrix> apart(onto + turns.transpose() * turns);
  std::vector<WeakDirection> directions;
  for (Index k = 0; k < num_weak; ++k) {
    const Motion motion = apart.eigenvectors().col(5 - k);
    const Eigen::Vector3d turn = motion.head<3>(), shift = motion.tail<3>();
    WeakDirection& direction = directions.emplace_back();
    direction.stiffness = solver.eigenvalues()[k];
    if (turn.squaredNorm() > shift.squaredNorm()) {
      direction.turn = turn.normalized();
    } else {
      direction.shift = shift.normalized();
    }
  }
  return directions;
}

}  // namespace

SurfaceFit measure_surfaces(CentredPair& pair, const Similarity& target_from_source, double radius,
                            Index max_samples, int num_threads) {
  const Similarity pose = pair.centred(target_from_source);
  const auto pairs_of = [&](bool of_source) {
    const Samples samples =
        sample_side(of_source ? pair.source : pair.target, of_source, max_samples);
    return find_pairs(pair.source, pair.target, samples, pose, radius, num_threads);
  };
  PlanePairs forward = pairs_of(true);
  const PlanePairs backward = pairs_of(false);
  const MeetingCounts there = count(forward), back = count(backward);
  SurfaceFit fit;
  fit.source_share = there.meeting / static_cast<double>(forward.num_sought);
  fit.target_share = back.meeting / static_cast<double>(backward.num_sought);
  const double near = there.near + back.near;
  if (near == 0) return fit;
  fit.agreement = (there.alike + back.alike) / near;
  forward.pairs.insert(forward.pairs.end(), backward.pairs.begin(), backward.pairs.end());
  fit.noise = estimate_noise(forward);
  fit.weak_directions = weak_directions_of(forward.pairs);
  return fit;
}

}  // namespace gmcr::frontend
