#pragma once

#include <vector>

#include "frontend/surface_judge.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// The poses of two clouds that were looked at, of all attempts, refined and compared by surfaces.
class Hypotheses {
 public:
  /// @param matches  of the first attempt.
  Hypotheses(const CloudMatches& matches, const Options& options,
             const parallel::Deadline& deadline);

  /// The one of the pose and the alternatives of a solve at which the surfaces meet best. The pose
  /// itself stays where an alternative is hardly better.
  Candidate best_of(const Result& registration);

  /// The half turn of a pose at which the surfaces meet clearly better than at the pose, or else
  /// the pose.
  Candidate turned_or(const Candidate& candidate);

  /// Distinct poses at which the surfaces meet about as well, best first.
  std::vector<RivalPose> rivals_of(const Candidate& candidate) const;

 private:
  Candidate look_at(const Similarity& start);

  SurfaceJudge judge_;
  const parallel::Deadline& deadline_;
  std::vector<Candidate> seen_;
};

}  // namespace gmcr::frontend
