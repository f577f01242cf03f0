#include "frontend/judgement/hypotheses.hpp"

#include <algorithm>
#include <utility>

namespace gmcr::frontend {
namespace {

/// Overlap over that of the pose that the matches prefer, above which another one is taken instead.
constexpr double kBetter = 1.1;
/// The same, above which another one fits about as well.
constexpr double kAsGood = 0.9;
/// The same by a glance, which errs by a few per cent.
constexpr double kWorthALook = 0.75;

}  // namespace

Hypotheses::Hypotheses(std::shared_ptr<CentredPair> pair, double voxel, const Options& options,
                       const parallel::Deadline& deadline)
    : judge_(std::move(pair), voxel, options), options_(options), deadline_(deadline) {}

void Hypotheses::add(const std::vector<Similarity>& starts,
                     const std::function<Candidate()>& best) {
  if (deadline_.expired()) return;
  for (const Candidate& glanced : judge_.glance(starts, deadline_)) {
    if (deadline_.expired()) return;
    if (glanced.overlap < kWorthALook * best().overlap) continue;
    seen_.push_back(judge_.approach(glanced.target_from_source, deadline_));
  }
}

Candidate Hypotheses::best_of(const Result& registration) {
  const Candidate first = judge_.approach(registration.target_from_source, deadline_);
  const std::size_t num_before = seen_.size();
  seen_.push_back(first);
  if (num_before == 0 && options_.initial_pose && !deadline_.expired()) {
    seen_.push_back(judge_.approach_initial_pose(first.target_from_source.scale, deadline_));
  }
  add(poses_of(registration.alternatives), [&] { return first; });
  Candidate best = first;
  for (std::size_t k = num_before; k < seen_.size(); ++k) {
    if (seen_[k].overlap > kBetter * best.overlap) best = seen_[k];
  }
  return best;
}

Candidate Hypotheses::approach(const Similarity& pose, const std::vector<RivalPose>& rivals) {
  const Candidate candidate = judge_.approach(pose, deadline_);
  std::vector<Similarity> others = poses_of(rivals);
  for (const Similarity& turned : judge_.half_turns(candidate.target_from_source)) {
    others.push_back(turned);
  }
  add(others, [&] { return candidate; });
  return candidate;
}

Candidate Hypotheses::best_with(const std::vector<Similarity>& poses) {
  const auto best = [&] {
    return *std::max_element(
        seen_.begin(), seen_.end(),
        [](const Candidate& a, const Candidate& b) { return a.overlap < b.overlap; });
  };
  add(poses, best);
  return best();
}

Candidate Hypotheses::challenged(const Candidate& candidate) {
  add(judge_.half_turns(candidate.target_from_source), [&] { return candidate; });
  Candidate best = candidate;
  for (const Candidate& other : seen_) {
    if (other.overlap > kBetter * candidate.overlap && other.overlap > best.overlap) best = other;
  }
  return best;
}

std::vector<Candidate> Hypotheses::better_than(const Candidate& candidate) const {
  std::vector<Candidate> better;
  for (const Candidate& other : seen_) {
    if (other.overlap > candidate.overlap &&
        judge_.are_distinct(candidate.target_from_source, other.target_from_source)) {
      better.push_back(other);
    }
  }
  std::stable_sort(better.begin(), better.end(),
                   [](const Candidate& a, const Candidate& b) { return a.overlap > b.overlap; });
  return better;
}

std::vector<RivalPose> Hypotheses::rivals_of(const Candidate& candidate) {
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
    rivals.push_back({pose, other.overlap / candidate.overlap,
                      judge_.is_symmetry(candidate.target_from_source, pose)});
  }
  std::stable_sort(rivals.begin(), rivals.end(),
                   [](const RivalPose& a, const RivalPose& b) { return a.overlap > b.overlap; });
  return rivals;
}

}  // namespace gmcr::frontend
