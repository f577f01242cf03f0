#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "frontend/cloud_pair.hpp"
#include "frontend/judgement/hypotheses.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::frontend {

/// A result that may be returned.
struct Attempt {
  CloudResult result;
  Similarity matched;   ///< the pose that the matches gave
  Candidate candidate;  ///< its pose; its overlap is what attempts are compared by
};

/// Attempts at two clouds, each of which adds to what the earlier ones found: all poses are refined
/// and compared on the voxels of the first, and from where an object is turned on those of that
/// attempt.
class Attempts {
 public:
  /// Keeps references to all of them.
  Attempts(CloudScales& source, CloudScales& target, const FrontendOptions& frontend,
           const Options& options, const parallel::Deadline& deadline);

  /// Tries one setting, and keeps what is better than the best so far.
  /// @return false where the graph of the matches exceeds the memory budget and this is not the
  ///   first attempt, which would throw.
  bool add(const FrontendSetting& setting);

  int count() const { return count_; }
  const Attempt& best() const { return best_; }
  const FrontendSetting& best_setting() const { return best_setting_; }

  /// Whether the target may show the source as a whole, which is small enough to be turned all
  /// around.
  bool may_show_object() const;

  /// How much coarser voxels must be to merge points of sparse clouds; 1 where they were asked for.
  double coarsening() const;

  /// Says of the best that its mirrored source is worse, and judges it anew.
  void know_mirrored_is_worse();

  /// The best, after its rivals were looked at.
  const CloudResult& compared();

  /// The same at the pose that is refined most finely; with the stages and limits of all attempts.
  CloudResult settled();

 private:
  Options in_time(Options options) const;
  std::optional<double> guessed_scale(const FrontendSetting& setting);
  std::optional<CloudResult> match(const FrontendSetting& setting);
  void judge_by_voxels_of(const CloudMatches& matches);
  void see(CentredPair& pair);
  std::vector<RivalPose> rivals_of(const CloudResult& result, const Candidate& candidate);
  Attempt judged(CloudResult result);
  Attempt refined(CloudResult result, const FrontendSetting& setting);
  Attempt with_clearer_matches(Attempt attempt, const CloudResult& other);
  void keep_better(Attempt next, const FrontendSetting& setting);
  Candidate preferred();
  void compare_with_rivals();
  bool fits_mirrored() const;
  void note_limits(const CloudResult& result);
  bool refines() const { return frontend_.refine == Refine::Icp; }

  CloudScales& source_;
  CloudScales& target_;
  const FrontendOptions& frontend_;
  const Options& options_;
  const parallel::Deadline& deadline_;
  JudgedVoxels voxels_;                ///< by which all poses are judged
  std::shared_ptr<CentredPair> pair_;  ///< the same; null where one cloud has none
  /// What the sensors saw; null where they were somewhere unknown.
  std::optional<std::pair<std::shared_ptr<const RangeImage>, std::shared_ptr<const RangeImage>>>
      views_;
  std::optional<Hypotheses> hypotheses_;
  Attempt best_;
  FrontendSetting best_setting_;
  int count_ = 0;
  std::vector<StageTime> stages_;
  std::vector<LimitHit> limits_;
};

}  // namespace gmcr::frontend
