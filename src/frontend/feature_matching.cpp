#include "frontend/feature_matching.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr int kLanes = 8;    // targets that one pass over the bins compares
constexpr int kQueries = 4;  // sources that share the loads of that pass
constexpr float kInfinity = std::numeric_limits<float>::infinity();

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

/// Features in groups of `kLanes`, bin by bin inside a group; the last group is padded with
/// infinity, which is never nearest.
class Interleaved {
 public:
  explicit Interleaved(const Features& features)
      : num_groups_((features.cols() + kLanes - 1) / kLanes),
        values_(static_cast<std::size_t>(num_groups_ * kLanes * kFpfhBins), kInfinity) {
    for (Index j = 0; j < features.cols(); ++j) {
      for (int bin = 0; bin < kFpfhBins; ++bin) {
        values_[static_cast<std::size_t>(((j / kLanes) * kFpfhBins + bin) * kLanes + j % kLanes)] =
            features(bin, j);
      }
    }
  }

  Index num_groups() const { return num_groups_; }
  const float* group(Index g) const { return values_.data() + g * kLanes * kFpfhBins; }

 private:
  Index num_groups_;
  std::vector<float> values_;
};

using Distances = std::array<std::array<float, kLanes>, kQueries>;

/// Squared distances of `kQueries` sources to one group of targets.
Distances squared_distances(const std::array<const float*, kQueries>& queries, const float* group) {
  Distances sums{};
  for (int bin = 0; bin < kFpfhBins; ++bin) {
    for (int q = 0; q < kQueries; ++q) {
      for (int lane = 0; lane < kLanes; ++lane) {
        const float difference = queries[q][bin] - group[bin * kLanes + lane];
        sums[q][lane] += difference * difference;
      }
    }
  }
  return sums;
}

struct Nearest {
  float squared_distance = kInfinity;
  float second = kInfinity;
  Index index = -1;

  /// Candidates come in ascending order of index, so that a tie keeps the smallest.
  void offer(float candidate, Index candidate_index) {
    if (candidate < squared_distance) {
      second = squared_distance;
      squared_distance = candidate;
      index = candidate_index;
    } else if (candidate < second) {
      second = candidate;
    }
  }
};

struct NearestBothWays {
  std::vector<Nearest> of_source;
  std::vector<Nearest> of_target;
};

/// Compares sources [begin, end) with all targets, until the deadline.
void compare_block(const Features& source, const Interleaved& targets, Index begin, Index end,
                   const parallel::Deadline& deadline, std::vector<Nearest>& of_source,
                   std::vector<Nearest>& of_target) {
  for (Index first = begin; first < end; first += kQueries) {
    if (deadline.expired()) return;
    const int count = static_cast<int>(std::min<Index>(kQueries, end - first));
    std::array<const float*, kQueries> queries;
    for (int q = 0; q < kQueries; ++q) {
      queries[q] = source.col(first + std::min(q, count - 1)).data();
    }
    for (Index g = 0; g < targets.num_groups(); ++g) {
      const Distances distances = squared_distances(queries, targets.group(g));
      for (int q = 0; q < count; ++q) {
        for (int lane = 0; lane < kLanes; ++lane) {
          of_source[first + q].offer(distances[q][lane], g * kLanes + lane);
          of_target[g * kLanes + lane].offer(distances[q][lane], first + q);
        }
      }
    }
  }
}

NearestBothWays find_nearest(const Features& source, const Features& target,
                             const MatchingOptions& options) {
  const Interleaved targets(target);
  const auto num_slots = static_cast<std::size_t>(targets.num_groups() * kLanes);
  NearestBothWays nearest;
  nearest.of_source.resize(static_cast<std::size_t>(source.cols()));
  nearest.of_target.resize(num_slots);

  // a bounded number of blocks, each with its own best sources; merged in order
  const Index grain = std::max<Index>(256, (source.cols() + 31) / 32);
  std::vector<std::vector<Nearest>> block_best((source.cols() + grain - 1) / grain);
  parallel::parallel_for(source.cols(), grain, options.num_threads, [&](Index begin, Index end) {
    auto& of_target = block_best[begin / grain];
    of_target.resize(num_slots);
    compare_block(source, targets, begin, end, options.deadline, nearest.of_source, of_target);
  });
  for (const auto& of_target : block_best) {
    for (std::size_t j = 0; j < num_slots; ++j) {
      nearest.of_target[j].offer(of_target[j].squared_distance, of_target[j].index);
    }
  }
  return nearest;
}

}  // namespace

FeatureMatches match_features(const Features& source, const Features& target,
                              const MatchingOptions& options) {
  const Compacted sources = keep_nonzero(source);
  const Compacted targets = keep_nonzero(target);
  FeatureMatches matches;
  if (sources.columns.empty() || targets.columns.empty()) return matches;
  const NearestBothWays nearest = find_nearest(sources.features, targets.features, options);
  const float squared_ratio = options.max_ratio * options.max_ratio;
  std::vector<Nearest> closest(targets.columns.size());
  Index num_compared = 0;
  for (std::size_t i = 0; i < sources.columns.size(); ++i) {
    const Nearest& best = nearest.of_source[i];
    if (best.index < 0) continue;
    ++num_compared;
    closest[static_cast<std::size_t>(best.index)].offer(best.squared_distance,
                                                        static_cast<Index>(i));
  }
  for (std::size_t i = 0; i < sources.columns.size(); ++i) {
    const Nearest& best = nearest.of_source[i];
    if (best.index < 0) continue;
    const auto j = static_cast<std::size_t>(best.index);
    if (options.mutual && nearest.of_target[j].index != static_cast<Index>(i)) continue;
    if (options.max_ratio < 1 && best.squared_distance > squared_ratio * best.second) continue;
    if (options.one_to_one && closest[j].index != static_cast<Index>(i)) continue;
    matches.pairs.push_back({sources.columns[i], targets.columns[j]});
  }
  matches.share_compared =
      static_cast<double>(num_compared) / static_cast<double>(sources.columns.size());
  return matches;
}

}  // namespace gmcr::frontend
