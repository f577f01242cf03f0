#include "problem/problem.hpp"

#include <algorithm>
#include <numeric>

#include "parallel/parallel_for.hpp"
#include "problem/graph/consistency_graph.hpp"
#include "problem/input.hpp"
#include "problem/scales.hpp"

namespace gmcr::problem {
namespace {

/// A time limit that graphs exceed by more is for a sample.
constexpr double kFarBeyond = 2;

bool has_one_scale(const Options& options) {
  return options.scale_mode == ScaleMode::Known ||
         (options.scale_range && options.scale_range->min == options.scale_range->max);
}

/// The correspondences that the priors on the translation admit, ascending.
std::vector<Index> admitted_correspondences(const Correspondences& all, const Priors& priors,
                                            const ScaleRange& scales) {
  std::vector<Index> admitted(static_cast<std::size_t>(all.size()));
  std::iota(admitted.begin(), admitted.end(), Index{0});
  if (priors.admit_all()) return admitted;
  const PairFilter filter(all, priors, false, scales);
  std::erase_if(admitted, [&](Index i) { return !filter.admits(i, scales); });
  return admitted;
}

}  // namespace

Problem::Problem(const PointsRef& source, const PointsRef& target, const Options& options, Run& run,
                 Route route)
    : options_(options),
      input_{source, target, inlier_bounds(options, source.cols())},
      min_inliers_(estimation::min_correspondences(options, has_one_scale(options))),
      size_(source.cols()),
      buckets_(scale_buckets_of(options, source, target)) {
  Diagnostics& diagnostics = run.diagnostics();
  diagnostics.num_correspondences = diagnostics.num_used = size_;
  diagnostics.num_threads = parallel::resolve_num_threads(options.num_threads);
  if (is_too_small()) return;
  correspondences_ = centre(source, target, input_.bounds);
  const ScaleRange scales = scales_to_search(options, correspondences_);
  const std::vector<Index> used = admitted_correspondences(correspondences_, options, scales);
  diagnostics.scale_range = scales;
  diagnostics.num_used = size_ = static_cast<Index>(used.size());
  if (is_too_small()) return;
  const bool is_whole = route == Route::Whole || options.method == Method::Paper;
  run.require_memory_for_graph(is_whole ? size_ : std::min(size_, kLeastSample));
  const bool exceeds_memory = size_ > run.num_in_memory();
  const bool exceeds_time =
      size_ > kQuickGraph &&
      foreseen_seconds(size_, scales.min == scales.max) > kFarBeyond * options.time_limit;
  is_sampled_ = !is_whole && (exceeds_memory || exceeds_time);
  if (is_sampled_) run.limit(search_of_a_sample(exceeds_memory ? Limit::Memory : Limit::Time));
  const bool is_part = size_ < input_.size();
  const Points used_source = is_part ? Points(source(Eigen::all, used)) : Points(3, 0);
  const Points used_target = is_part ? Points(target(Eigen::all, used)) : Points(3, 0);
  const CallerCorrespondences part{used_source, used_target, input_.bounds(used)};
  if (is_part) correspondences_ = centre(part.source, part.target, part.bounds);
  constraints_ = {scales, options, correspondences_.source_origin, correspondences_.target_origin};
  {
    const StageTimer timer(run, "evidence");
    objective_.emplace(correspondences_, is_sampled_ ? Evidence::Count : options.evidence,
                       options.memory_limit / 4, scales, buckets_, run.deadline(),
                       is_part ? &part : &input_);
  }
  if (is_sampled_) {
    if (options.evidence == Evidence::Distinct) run.limit(evidence_counted());
    return;
  }
  if (!objective_->weights_complete() && !run.stopped()) run.limit(weights_incomplete());
  filter_.emplace(correspondences_, options, options.one_to_one, scales);
  arrays_ = consistency_arrays(correspondences_, scales.max);
}

bool Problem::is_hurried() const {
  constexpr double kSecondsEach = 2e-6;
  return is_sampled_ && kSecondsEach * static_cast<double>(size_) > options_.time_limit;
}

std::vector<Index> Problem::clear_of_rounding(const std::vector<Index>& indices) const {
  constexpr double kMostRounding = 4;  // bounds
  std::vector<Index> clear = indices;
  std::erase_if(clear, [&](Index i) {
    return arrays_.bounds[i] > (1 + kMostRounding) * correspondences_.bounds[i];
  });
  return static_cast<Index>(clear.size()) < kMinInliers ? indices : clear;
}

}  // namespace gmcr::problem
