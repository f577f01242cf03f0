#include "problem/problem.hpp"

#include <algorithm>
#include <numeric>

#include "parallel/parallel_for.hpp"
#include "problem/consistency_graph.hpp"
#include "problem/input.hpp"
#include "problem/scales.hpp"

namespace gmcr::problem {
namespace {

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

Problem::Problem(const PointsRef& source, const PointsRef& target, const Options& options, Run& run)
    : options_(options),
      input_{source, target, inlier_bounds(options, source.cols())},
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
  run.require_memory_for_graph(size_);
  if (size_ < input_.size()) {
    correspondences_ =
        centre(source(Eigen::all, used), target(Eigen::all, used), input_.bounds(used));
  }
  constraints_ = {scales, options, correspondences_.source_origin, correspondences_.target_origin};
  {
    const StageTimer timer(run, "evidence");
    objective_.emplace(correspondences_, options.evidence, options.memory_limit / 4, scales,
                       buckets_);
  }
  if (!objective_->weights_complete()) run.limit(weights_incomplete());
  filter_.emplace(correspondences_, options, options.one_to_one, scales);
  arrays_ = consistency_arrays(correspondences_, scales.max);
}

}  // namespace gmcr::problem
