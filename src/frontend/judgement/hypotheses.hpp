#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "frontend/judgement/surface_judge.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// The poses of two clouds that were looked at, of all attempts, refined and compared by surfaces.
class Hypotheses {
 public:
  /// @param pair, voxel  as for `SurfaceJudge`.
  Hypotheses(std::shared_ptr<CentredPair> pair, double voxel, const Options& options,
             const parallel::Deadline& deadline);

  /// From here on no match speaks for a pose, and one that overlaps less is a rival of it too.
  void expect_no_matches();

  /// The pose near one from elsewhere at which the surfaces meet best. Its half turns and those
  /// that were rivals before are looked at for `rivals_of`.
  Candidate approach(const Similarity& pose, const std::vector<RivalPose>& rivals);

  /// The one of the pose and the alternatives of a solve, and at first of the initial pose, at
  /// which the surfaces meet best. The pose itself stays where another one is hardly better.
  Candidate best_of(const Result& registration);

  /// The best of these poses, and of all that were seen.
  Candidate best_with(const std::vector<Similarity>& poses);

  /// The best of the half turns of a pose and of all poses that were seen, where the surfaces meet
  /// clearly better there than at the pose; else the pose.
  Candidate challenged(const Candidate& candidate);

  /// Whether two poses are no farther apart than a refinement could bridge.
  bool are_one(const Candidate& a, const Candidate& b) const {
    return !judge_.are_distinct(a.target_from_source, b.target_from_source);
  }

  /// Poses that were seen, distinct from this one, at which the surfaces meet better, best first.
  std::vector<Candidate> better_than(const Candidate& candidate) const;

  /// Distinct poses at which the surfaces meet about as well, or that matches speak for too and
  /// nothing that the sensors saw contradicts, best first. What they saw through where a pose puts
  /// a surface rules it out.
  /// @param evidence  of the matches for a candidate.
  std::vector<RivalPose> rivals_of(const Candidate& candidate,
                                   const std::function<double(const Candidate&)>& evidence);

 private:
  /// The poses near `starts`, each of which is looked at closely only where it may be a rival of
  /// the best one so far.
  void add(const std::vector<Similarity>& starts, const std::function<Candidate()>& best);

  SurfaceJudge judge_;
  const Options& options_;
  const parallel::Deadline& deadline_;
  bool is_better(const Candidate& other, const Candidate& candidate) const;
  bool is_ruled_out(const Candidate& other, const Candidate& candidate) const;

  double as_good_;  ///< overlap over that of a pose with which another one is its rival
  std::vector<Candidate> seen_;
};

}  // namespace gmcr::frontend
