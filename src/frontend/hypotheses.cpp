#include "frontend/hypotheses.hpp"

#include <algorithm>

namespace gmcr::frontend {
namespace {

/// Overlap over that of the pose that the matches prefer, above which another one is taken instead.
constexpr double kBetter = 1.1;
/// The same, above which another one fits about as well.
constexpr double kAsGood = 0.9;

}  // namespace

Hypotheses::Hypotheses(const CloudMatches& matches, const Options& options,
                       const parallel::Deadline& deadline)
    : judge_(matches, options), deadline_(deadline) {}

Candidate Hypotheses::look_at(const Similarity& start) {
  seen_.push_back(judge_.approach(start, deadline_));
  return seen_.back();
}

Candidate Hypotheses::best_of(const Result& registration) {
  Candidate best = look_at(registration.target_from_source);
  for (const Alternative& alternative : registration.alternatives) {
    if (deadline_.expired()) break;
    const Candidate other = look_at(alternative.target_from_source);
    if (other.overlap > kBetter * best.overlap) best = other;
  }
  return best;
}

Candidate Hypotheses::turned_or(const Candidate& candidate) {
  Candidate best = candidate;
  for (const Similarity& turned : judge_.half_turns(candidate.target_from_source)) {
    if (deadline_.expired()) break;
    const Candidate other = look_at(turned);
    if (other.overlap > kBetter * best.overlap) best = other;
  }
  return best;
}

std::vector<RivalPose> Hypotheses::rivals_of(const Candidate& candidate) const {
  std::vector<RivalPose> rivals;
  for (const Candidate& other : seen_) {
    const Similarity& pose = other.target_from_source;
    const bool is_new = std::all_of(rivals.begin(), rivals.end(), [&](const RivalPose& rival) {
      return judge_.are_distinct(rival.target_from_source, pose);
    });
    if (!is_new || other.overlap < kAsGood * candidate.overlap ||
        !judge_.are_distinct(candidate.target_from_source, pose)) {
      continue;
    }
    rivals.push_back({pose, other.overlap / candidate.overlap});
  }
  std::stable_sort(rivals.begin(), rivals.end(),
                   [](const RivalPose& a, const RivalPose& b) { return a.overlap > b.overlap; });
  return rivals;
}

}  // namespace gmcr::frontend
