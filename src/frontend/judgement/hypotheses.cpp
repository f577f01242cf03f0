#include "frontend/judgement/hypotheses.hpp"

#include <algorithm>
#include <utility>

namespace gmcr::frontend {
namespace {

/// Overlap over that of the pose that the matches prefer, above which another one is taken instead.
constexpr double kBetter = 1.1;
/// The same, above which another one fits about as well.
constexpr double kAsGood = 0.9;
/// The same of a pose that no match speaks for: right ones of objects have rivals of up to 0.7,
/// wrong ones that cover as much of a view of 0.8 and more.
constexpr double kAsGoodUnmatched = 0.75;
/// The same where no sensor saw through what it puts there, and matches speak for it: of what
/// repeats, such as doors or trees, the poses that are off by a period share less and less.
constexpr double kAsGoodUnseen = 0.5;
/// Evidence over that of the pose with which matches speak for another one.
constexpr double kSpeaksFor = 0.25;
/// `Candidate::contradicted` of poses that the sensors agree with, and of those that they do not.
constexpr double kConsistent = 0.005;
constexpr double kContradicted = 0.015;
/// What a glance may be short of, which errs by a few per cent.
constexpr double kErrorOfGlance = 0.15;
/// Overlap by a peek over that of a pose, above which a half turn of it is glanced at.
constexpr double kWorthAGlance = 0.4;

}  // namespace

Hypotheses::Hypotheses(std::shared_ptr<CentredPair> pair, double voxel, const Options& options,
                       const parallel::Deadline& deadline)
    : judge_(std::move(pair), voxel, options),
      options_(options),
      deadline_(deadline),
      as_good_(kAsGood) {}

void Hypotheses::expect_no_matches() { as_good_ = kAsGoodUnmatched; }

void Hypotheses::add(const std::vector<Similarity>& starts,
                     const std::function<Candidate()>& best) {
  if (deadline_.expired()) return;
  for (const Candidate& glanced : judge_.glance(starts, deadline_)) {
    if (deadline_.expired()) return;
    const Candidate preferred = best();
    const bool may_repeat = judge_.knows_views() && glanced.contradicted < kContradicted &&
                            glanced.overlap > (kAsGoodUnseen - kErrorOfGlance) * preferred.overlap;
    if (glanced.overlap < (as_good_ - kErrorOfGlance) * preferred.overlap && !may_repeat) continue;
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
    if (is_better(seen_[k], best)) best = seen_[k];
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
  std::vector<Candidate> turned =
      judge_.peek(judge_.half_turns(candidate.target_from_source), deadline_);
  std::erase_if(turned, [&](const Candidate& peeked) {
    return peeked.overlap < kWorthAGlance * candidate.overlap;
  });
  add(poses_of(turned), [&] { return candidate; });
  const Candidate* best = &candidate;
  for (const Candidate& other : seen_) {
    const bool is_first = best == &candidate;
    if (is_better(other, candidate) && (is_first || other.overlap > best->overlap)) best = &other;
  }
  return *best;
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

/// Whether the sensors agree with a pose and not with the other one.
bool Hypotheses::is_ruled_out(const Candidate& other, const Candidate& candidate) const {
  return judge_.knows_views() && candidate.contradicted <= kConsistent &&
         other.contradicted >= kContradicted;
}

/// Whether the surfaces meet clearly better at the other pose, or about as well where the sensors
/// agree with that alone.
bool Hypotheses::is_better(const Candidate& other, const Candidate& candidate) const {
  if (is_ruled_out(other, candidate)) return false;
  const double least = is_ruled_out(candidate, other) ? as_good_ : kBetter;
  return other.overlap > least * candidate.overlap;
}

std::vector<RivalPose> Hypotheses::rivals_of(
    const Candidate& candidate, const std::function<double(const Candidate&)>& evidence) {
  const double least_evidence = kSpeaksFor * evidence(candidate);
  const auto is_rival = [&](const Candidate& other) {
    if (is_ruled_out(other, candidate)) return false;
    if (other.overlap >= as_good_ * candidate.overlap) return true;
    return judge_.knows_views() && other.contradicted <= kConsistent &&
           other.overlap >= kAsGoodUnseen * candidate.overlap && least_evidence > 0 &&
           evidence(other) >= least_evidence;
  };
  std::vector<RivalPose> rivals;
  for (const Candidate& other : seen_) {
    const Similarity& pose = other.target_from_source;
    const bool is_new = std::all_of(rivals.begin(), rivals.end(), [&](const RivalPose& rival) {
      return judge_.are_distinct(rival.target_from_source, pose);
    });
    if (!is_new || !judge_.are_distinct(candidate.target_from_source, pose) || !is_rival(other)) {
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
