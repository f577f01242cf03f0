#include "search/sampled_search.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "problem/selection.hpp"
#include "refine/local_optimisation.hpp"
#include "search/best_poses.hpp"

namespace gmcr::search {
namespace {

using problem::Problem;
using problem::Run;

// Sizes of the selections.
constexpr Index kFirst = 8192, kFirstOfUnknownScale = 2048;
constexpr Index kGrowth = 4;
constexpr Index kMost = 65536;

/// Members of a selection that agree with a pose beyond chance.
constexpr double kSure = 12;

/// As many as the time is likely to suffice for, at most.
Index first_count(const Problem& problem) {
  constexpr Index kLeast = 512;
  constexpr double kShare = 0.5;  // of the time
  Index count = problem.scale_is_known() ? kFirst : kFirstOfUnknownScale;
  while (count > kLeast && problem::foreseen_seconds(count, problem.scale_is_known()) >
                               kShare * problem.options().time_limit) {
    count /= 2;
  }
  return count;
}

/// A part of the problem, as one of its own with all that it refers to.
class Part {
 public:
  Part(const Problem& whole, Run& run, const std::vector<Index>& selected)
      : options_(options_of(whole, run, selected)),
        source_(whole.correspondences().source(Eigen::all, selected).colwise() +
                whole.correspondences().source_origin),
        target_(whole.correspondences().target(Eigen::all, selected).colwise() +
                whole.correspondences().target_origin),
        run_(options_),
        problem_(source_, target_, options_, run_, problem::Route::Whole) {}

  /// The best pose and its alternatives, between the frames of the whole.
  std::vector<problem::CentredPose> find(const Problem& whole) {
    if (problem_.is_too_small()) return {};
    BestPoseSearch search(problem_, run_);
    problem::Found found = search.found();
    if (search.poses().best()) add_alternatives(problem_, run_, *search.poses().best(), found);
    for (problem::CentredPose& pose : found.poses) {
      pose = problem::centre(problem::uncentre(pose, problem_.correspondences()),
                             whole.correspondences());
    }
    return found.poses;
  }

  const Diagnostics& diagnostics() const { return run_.diagnostics(); }

 private:
  static Options options_of(const Problem& whole, Run& run, const std::vector<Index>& selected) {
    Options some = whole.options();
    some.certify = false;
    some.scale_range = whole.scale_is_known() ? some.scale_range : whole.scales();
    // where copies of all took what there was, a part of it more
    constexpr double kLeastShare = 0.25;
    some.time_limit = std::max(
        {run.deadline().remaining(), kLeastShare * some.time_limit, parallel::kLeastSeconds});
    some.progress = [&run](const Progress& progress) {
      run.report(progress.stage, progress.fraction);
      return !run.cancelled();
    };
    if (some.noise_bounds.empty()) return some;
    const Eigen::ArrayXd bounds = whole.correspondences().bounds(selected);
    some.noise_bounds.assign(bounds.begin(), bounds.end());
    return some;
  }

  Options options_;
  Points source_, target_;
  Run run_;
  Problem problem_;
};

/// Poses, fitted to all correspondences, the best first.
class PosesOnAll {
 public:
  explicit PosesOnAll(const Problem& problem) : problem_(problem) {}

  void add(const problem::CentredPose& pose) {
    // a pose that was fitted to a sample is good enough where there is no time
    std::optional<problem::Hypothesis> fitted = problem_.is_hurried()
                                                    ? problem_.objective().judge(pose)
                                                    : refine::optimise_locally(problem_, pose);
    if (fitted) found_.push_back(std::move(*fitted));
  }

  /// As many poses as are asked for, none of which shares most of its inliers with a better one.
  std::vector<problem::CentredPose> poses() {
    std::stable_sort(found_.begin(), found_.end(), problem::is_better<problem::Frame::Centred>);
    std::vector<problem::CentredPose> distinct;
    const auto wanted = static_cast<std::size_t>(problem_.options().num_hypotheses);
    for (auto one = found_.begin(); one != found_.end() && distinct.size() < wanted; ++one) {
      const bool is_new = std::none_of(found_.begin(), one, [&](const auto& better) {
        return problem::shares_most(better.inliers, one->inliers);
      });
      if (is_new) distinct.push_back(one->pose);
    }
    return distinct;
  }

  /// Share of the correspondences that the best one holds.
  double best_share() const {
    Index most = 0;
    for (const auto& hypothesis : found_) most = std::max(most, hypothesis.num_inliers());
    return static_cast<double>(most) / static_cast<double>(problem_.size());
  }

 private:
  const Problem& problem_;
  std::vector<problem::Hypothesis> found_;
};

}  // namespace

problem::Found sampled_search(const Problem& problem, Run& run) {
  PosesOnAll poses(problem);
  const Index most = std::min(kMost, run.num_in_memory());
  for (Index count = std::min(first_count(problem), most);;
       count = std::min(kGrowth * count, most)) {
    Part part(problem, run, problem::stratified_selection(problem.size(), count));
    const std::vector<problem::CentredPose> found = part.find(problem);
    run.add_work(part.diagnostics());
    {
      const StageTimer timer(run, "pose");
      for (const problem::CentredPose& pose : found) poses.add(pose);
    }
    if (count == most || poses.best_share() * static_cast<double>(count) >= kSure) break;
    if (run.stopped()) break;
  }
  const auto all = static_cast<double>(problem.size());
  return {poses.poses(), problem.size(), all};
}

}  // namespace gmcr::search
