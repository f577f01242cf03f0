#include "frontend/matching/feature_matching.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "frontend/matching/admitted_comparison.hpp"
#include "frontend/matching/indexed_comparison.hpp"
#include "kernels/features/nearest_features.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

using kernels::IntegerFeatures;
using kernels::NearestFeature;
using kernels::NearestSources;

/// Columns with a feature, and where they came from.
struct Compacted {
  Features features;
  std::vector<Index> columns;
};

Compacted keep_nonzero(const Features& features) {
  Compacted kept;
  for (Index i = 0; i < features.cols(); ++i) {
    if (!features.col(i).isZero(0)) kept.columns.push_back(i);
  }
  kept.features = features(Eigen::all, kept.columns);
  return kept;
}

/// The nearest of all, or of those that the priors admit; `kNoPartner` where they admit none.
NearestBothWays nearest_of_all(const Compacted& from, const Compacted& to, double resolution,
                               const MatchingOptions& options) {
  const Features &source = from.features, &target = to.features;
  std::optional<IntegerFeatures> source_integers, target_integers;
  parallel::call_both(
      options.num_threads,
      [&] { source_integers.emplace(source.data(), source.rows(), source.cols(), resolution); },
      [&] { target_integers.emplace(target.data(), target.rows(), target.cols(), resolution); });
  const IntegerFeatures &sources = *source_integers, &targets = *target_integers;
  NearestBothWays nearest;
  nearest.of_source.resize(static_cast<std::size_t>(source.cols()));

  std::optional<AdmittedComparison> admitted;
  if (options.priors) {
    admitted.emplace(Described{from.columns, sources}, Described{to.columns, targets},
                     *options.priors);
  }

  // a bounded number of blocks, each with its own best sources; merged in order
  const Index grain = std::max<Index>(256, (source.cols() + 31) / 32);
  std::vector<NearestSources> of_blocks(
      static_cast<std::size_t>((source.cols() + grain - 1) / grain), NearestSources(targets));
  parallel::parallel_for(source.cols(), grain, options.num_threads, [&](Index begin, Index end) {
    NearestSources& of_block = of_blocks[static_cast<std::size_t>(begin / grain)];
    for (Index first = begin; first < end; first += kernels::kFeatureQueries) {
      if (options.deadline.expired()) return;
      const Index count = std::min(kernels::kFeatureQueries, end - first);
      NearestFeature* const of_sources = nearest.of_source.data() + first;
      if (admitted) {
        for (Index k = 0; k < count; ++k) of_sources[k] = admitted->nearest(first + k, of_block);
      } else {
        kernels::nearest_features(sources, first, count, targets, of_sources, of_block);
      }
    }
  });
  NearestSources of_targets(targets);
  for (const NearestSources& of_block : of_blocks) {
    for (std::size_t j = 0; j < of_block.indices.size(); ++j) {
      if (of_block.squared_distances[j] >= of_targets.squared_distances[j]) continue;
      of_targets.squared_distances[j] = of_block.squared_distances[j];
      of_targets.indices[j] = of_block.indices[j];
    }
  }
  nearest.of_target = std::move(of_targets.indices);
  return nearest;
}

NearestBothWays find_nearest(const Compacted& from, const Compacted& to,
                             const MatchingOptions& options) {
  const Features &source = from.features, &target = to.features;
  const double resolution = IntegerFeatures::resolution_for(static_cast<double>(std::max(
      source.colwise().squaredNorm().maxCoeff(), target.colwise().squaredNorm().maxCoeff())));
  const auto num_pairs = static_cast<double>(source.cols()) * static_cast<double>(target.cols());
  if (!options.priors && num_pairs > options.most_pairs) {
    return nearest_in_places(source, target, resolution, options.num_threads, options.deadline);
  }
  return nearest_of_all(from, to, resolution, options);
}

/// Whether the nearest is clearly nearer than the second nearest, if there is one.
bool is_clear(const NearestFeature& best, double squared_ratio) {
  return best.second >= IntegerFeatures::kFarAway ||
         best.squared_distance <= squared_ratio * best.second;
}

}  // namespace

FeatureMatches match_features(const Features& source, const Features& target,
                              const MatchingOptions& options) {
  Compacted sources, targets;
  parallel::call_both(
      options.num_threads, [&] { sources = keep_nonzero(source); },
      [&] { targets = keep_nonzero(target); });
  FeatureMatches matches;
  if (sources.columns.empty() || targets.columns.empty()) return matches;
  const NearestBothWays nearest = find_nearest(sources, targets, options);
  const double squared_ratio = static_cast<double>(options.max_ratio) * options.max_ratio;
  std::vector<NearestFeature> closest(targets.columns.size());
  Index num_compared = 0;
  for (std::size_t i = 0; i < sources.columns.size(); ++i) {
    const NearestFeature& best = nearest.of_source[i];
    if (best.index == -1) continue;
    ++num_compared;
    if (best.index < 0) continue;
    closest[static_cast<std::size_t>(best.index)].offer(best.squared_distance,
                                                        static_cast<std::int32_t>(i));
  }
  for (std::size_t i = 0; i < sources.columns.size(); ++i) {
    const NearestFeature& best = nearest.of_source[i];
    if (best.index < 0) continue;
    const auto j = static_cast<std::size_t>(best.index);
    if (options.mutual && nearest.of_target[j] != static_cast<Index>(i)) continue;
    if (options.max_ratio < 1 && !is_clear(best, squared_ratio)) continue;
    if (options.one_to_one && closest[j].index != static_cast<Index>(i)) continue;
    matches.pairs.push_back({sources.columns[i], targets.columns[j]});
  }
  matches.share_compared =
      static_cast<double>(num_compared) / static_cast<double>(sources.columns.size());
  return matches;
}

std::vector<FeatureMatch> pooled(std::vector<FeatureMatch> matches,
                                 const std::vector<FeatureMatch>& more) {
  matches.insert(matches.end(), more.begin(), more.end());
  std::sort(matches.begin(), matches.end());
  matches.erase(std::unique(matches.begin(), matches.end()), matches.end());
  return matches;
}

}  // namespace gmcr::frontend
