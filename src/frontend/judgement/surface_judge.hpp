#pragma once

#include <memory>
#include <vector>

#include "frontend/alignment/centred_pair.hpp"
#include "frontend/alignment/refine_pose.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// A pose that was refined on the voxels of the judge.
struct Candidate {
  Similarity target_from_source;
  bool is_refined = false;  ///< moved from where it started, since the surfaces meet better there
  double noise = 0;         ///< as in `RefinedPose`
  double overlap = 0;       ///< `SurfaceFit::overlap`
  double contradicted = 0;  ///< as in `SurfaceFit`
};

/// Those of candidates, alternatives or rivals.
template <class Posed>
std::vector<Similarity> poses_of(const std::vector<Posed>& all) {
  std::vector<Similarity> poses;
  for (const Posed& one : all) poses.push_back(one.target_from_source);
  return poses;
}

/// Refines and compares poses of two clouds by how their surfaces meet: all on the same voxels, so
/// that poses of unlike attempts can be compared.
class SurfaceJudge {
 public:
  /// @param pair   the voxels of the first attempt, shared with who measures its poses.
  /// @param voxel  metres, target frame.
  SurfaceJudge(std::shared_ptr<CentredPair> pair, double voxel, const Options& options);

  /// The pose near `start` at which the surfaces meet best.
  Candidate approach(const Similarity& start, const parallel::Deadline& deadline);

  /// The same from the initial pose of the options, which may be as far off as its bounds leave it,
  /// but is followed over twelve voxels at most.
  Candidate approach_initial_pose(double scale, const parallel::Deadline& deadline);

  /// The same of each by fewer points, to see whether a closer look is worth its time.
  std::vector<Candidate> glance(const std::vector<Similarity>& starts,
                                const parallel::Deadline& deadline);

  /// The same by fewer points yet, a few steps on the way: to tell the promising of many starts.
  std::vector<Candidate> peek(const std::vector<Similarity>& starts,
                              const parallel::Deadline& deadline);

  /// The pose turned by half about each principal axis of the source, through its centroid, and
  /// about each axis of its normals, through the middle of its extents along them: how
  /// symmetric parts, corridors and bare ground, and rooms, are mistaken for themselves. Those that
  /// the priors admit.
  std::vector<Similarity> half_turns(const Similarity& pose) const;

  /// Poses of the mirrored source, its x negated, that put it where a reflection of the source lies
  /// at a pose: across the axes of `half_turns`.
  std::vector<Similarity> reflections(const Similarity& pose) const;

  /// Whether both sensors are known, so that what they saw through tells poses apart.
  bool knows_views() const { return pair_->source_view && pair_->target_view; }

  /// Whether the poses are apart by more than a refinement could bridge: RMS distance of the images
  /// of the source above so many voxels.
  bool are_distinct(const Similarity& a, const Similarity& b, double voxels = 3) const;

  /// Whether the source at one pose lies, almost all of it, within 1.5 voxels of where it lies
  /// at the other one: the poses differ by a symmetry of it.
  bool is_symmetry(const Similarity& a, const Similarity& b);

 private:
  /// Axes of the normals of the source, which are those of a room, and the middle of its extents.
  struct Box {
    Eigen::Matrix3d axes;    ///< columns
    Eigen::Vector3d middle;  ///< metres
  };
  Box box_of_source() const;
  Candidate look(const Similarity& start, const RefinementScale& scale, const Options& options,
                 const parallel::Deadline& deadline);
  std::vector<Candidate> look_at_all(const std::vector<Similarity>& starts,
                                     const RefinementScale& scale,
                                     const parallel::Deadline& deadline);

  std::shared_ptr<CentredPair> pair_;
  double voxel_;               ///< metres, target frame
  Eigen::Vector3d centroid_;   ///< of the source, metres
  Eigen::Matrix3d axes_;       ///< principal axes of the source, columns
  Eigen::Vector3d variances_;  ///< of the source along them, square metres
  const Options& options_;
  Options alone_;  ///< the same for one thread, of those that look at many starts
};

}  // namespace gmcr::frontend
