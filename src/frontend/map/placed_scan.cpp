#include "frontend/map/placed_scan.hpp"

#include <algorithm>

namespace gmcr::frontend {
namespace {

constexpr std::size_t kNumClose = 5;  // places that are looked at closely
/// Overlap over that of the best, above which another place fits about as well.
constexpr double kAsGood = 0.85;

void sort_by_overlap(std::vector<Candidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.overlap > b.overlap; });
}

}  // namespace

std::optional<PlacedScan> compare_places(const std::shared_ptr<CentredPair>& pair, double voxel,
                                         const std::vector<Similarity>& starts,
                                         const Options& options,
                                         const parallel::Deadline& deadline) {
  SurfaceJudge judge(pair, voxel, options);
  std::vector<Candidate> candidates;
  for (const Candidate& candidate : judge.glance(starts, deadline)) {
    if (!options.admit(candidate.target_from_source)) continue;
    const bool is_new =
        std::none_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
          return !judge.are_distinct(other.target_from_source, candidate.target_from_source);
        });
    if (is_new) candidates.push_back(candidate);
  }
  if (candidates.empty()) return std::nullopt;
  sort_by_overlap(candidates);
  for (std::size_t k = 0; k < std::min(kNumClose, candidates.size()) && !deadline.expired(); ++k) {
    candidates[k] = judge.approach(candidates[k].target_from_source, deadline);
  }
  sort_by_overlap(candidates);
  PlacedScan placed;
  placed.best = candidates.front();
  for (const Candidate& other : candidates) {
    if (!judge.are_distinct(placed.best.target_from_source, other.target_from_source)) continue;
    const double share = other.overlap / placed.best.overlap;
    placed.runner_up = std::max(placed.runner_up, share);
    if (share >= kAsGood) placed.rivals.push_back({other.target_from_source, share});
  }
  return placed;
}

}  // namespace gmcr::frontend
