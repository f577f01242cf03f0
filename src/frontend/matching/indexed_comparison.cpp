#include "frontend/matching/indexed_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gmcr/descriptors.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

using kernels::IntegerFeatures;
using kernels::NearestFeature;
using kernels::NearestSources;

/// Places over the square root of the number of targets: to find the places of a source takes about
/// as long as to compare it with what lies there.
constexpr double kPlacesOfRoot = 3;
constexpr int kPlacesOfSource = 12;
// k-means on some of the targets, a place, which change little after two rounds.
constexpr Index kLearntFrom = 16;
constexpr int kPlaceRounds = 2;
constexpr Index kBetweenLooks = 8192;  ///< features, at the clock

/// At most `count` columns, spread evenly.
Features spread_selection(const Features& features, Index count) {
  std::vector<Index> columns(static_cast<std::size_t>(std::min(count, features.cols())));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    columns[k] = static_cast<Index>(k) * features.cols() / static_cast<Index>(columns.size());
  }
  return features(Eigen::all, columns);
}

/// The nearest places of each feature: of all features in ascending order, the nearest first.
DescriptorMatches nearest_places(const Features& features, const Features& places, int count,
                                 int num_threads) {
  DescriptorMatching options;
  options.k = count;
  options.mutual = false;
  options.num_threads = num_threads;
  return match_descriptors(features, places, options);
}

Features learn_places(const Features& targets, int num_threads) {
  const auto count = static_cast<Index>(kPlacesOfRoot * std::sqrt(targets.cols()));
  const Features learnt_from = spread_selection(targets, kLearntFrom * count);
  Features places = spread_selection(targets, count);
  for (int round = 0; round < kPlaceRounds; ++round) {
    const DescriptorMatches nearest = nearest_places(learnt_from, places, 1, num_threads);
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(places.rows(), places.cols());
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(places.cols());
    for (std::size_t k = 0; k < nearest.target_indices.size(); ++k) {
      const Index place = nearest.target_indices[k];
      sums.col(place) += learnt_from.col(nearest.source_indices[k]).cast<double>();
      counts[place] += 1;
    }
    for (Index place = 0; place < places.cols(); ++place) {
      if (counts[place] == 0) continue;
      places.col(place) = (sums.col(place) / counts[place]).cast<float>();
    }
  }
  return places;
}

IntegerFeatures integers_of(const Features& features, const std::vector<Index>& columns,
                            double resolution) {
  const Features chosen = features(Eigen::all, columns);
  return {chosen.data(), chosen.rows(), chosen.cols(), resolution};
}

/// The nearest of two sets of candidates.
NearestFeature merged(const NearestFeature& a, const NearestFeature& b) {
  const bool is_a = a.squared_distance < b.squared_distance ||
                    (a.squared_distance == b.squared_distance && a.index < b.index);
  NearestFeature nearest = is_a ? a : b;
  nearest.second = std::min({a.second, b.second, std::max(a.squared_distance, b.squared_distance)});
  return nearest;
}

/// Targets by the place that they are nearest to.
struct PlacedTargets {
  Features places;
  std::vector<std::vector<Index>> members;  ///< of each, ascending; never none
};

/// The deadline leaves out the targets that have no place yet.
PlacedTargets place(const Features& targets, int num_threads, const parallel::Deadline& deadline) {
  const Features learnt = learn_places(targets, num_threads);
  std::vector<std::vector<Index>> members(static_cast<std::size_t>(learnt.cols()));
  for (Index first = 0; first < targets.cols() && !deadline.expired(); first += kBetweenLooks) {
    const Index count = std::min(kBetweenLooks, targets.cols() - first);
    const DescriptorMatches nearest =
        nearest_places(targets.middleCols(first, count), learnt, 1, num_threads);
    for (std::size_t k = 0; k < nearest.target_indices.size(); ++k) {
      members[static_cast<std::size_t>(nearest.target_indices[k])].push_back(
          first + nearest.source_indices[k]);
    }
  }
  PlacedTargets placed;
  std::vector<Index> kept;
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (members[k].empty()) continue;
    kept.push_back(static_cast<Index>(k));
    placed.members.push_back(std::move(members[k]));
  }
  placed.places = learnt(Eigen::all, kept);
  return placed;
}

/// A source that is compared with a place, and where the answer goes.
struct Visit {
  Index source;
  std::size_t answer;
};

/// The nearest so far, and how near the sources of the targets are.
struct Nearest {
  NearestBothWays both_ways;
  std::vector<std::int32_t> squared_distances;  ///< of the targets
};

/// Compares the visitors of a place, which ascend, with its members.
void compare(const Features& source, const std::vector<Visit>& visits, const Features& target,
             const std::vector<Index>& members, double resolution, Nearest& nearest,
             std::vector<NearestFeature>& answers) {
  std::vector<Index> visitors;
  for (const Visit& visit : visits) visitors.push_back(visit.source);
  const IntegerFeatures sources = integers_of(source, visitors, resolution);
  const IntegerFeatures targets = integers_of(target, members, resolution);
  NearestSources of_targets(targets);
  for (Index first = 0; first < sources.size(); first += kernels::kFeatureQueries) {
    const Index count = std::min(kernels::kFeatureQueries, sources.size() - first);
    NearestFeature found[kernels::kFeatureQueries];
    kernels::nearest_features(sources, first, count, targets, found, of_targets);
    for (Index k = 0; k < count; ++k) {
      NearestFeature& answer = answers[visits[static_cast<std::size_t>(first + k)].answer];
      answer = found[k];
      answer.index = static_cast<std::int32_t>(members[static_cast<std::size_t>(found[k].index)]);
    }
  }
  for (std::size_t k = 0; k < members.size(); ++k) {
    const auto member = static_cast<std::size_t>(members[k]);
    if (of_targets.squared_distances[k] >= nearest.squared_distances[member]) continue;
    nearest.squared_distances[member] = of_targets.squared_distances[k];
    nearest.both_ways.of_target[member] =
        static_cast<std::int32_t>(visitors[static_cast<std::size_t>(of_targets.indices[k])]);
  }
}

/// Compares the sources [first, first + count) with the places that are nearest to them.
void compare(const Features& source, Index first, Index count, const Features& target,
             const PlacedTargets& placed, double resolution, int num_threads,
             const parallel::Deadline& deadline, Nearest& nearest) {
  const DescriptorMatches visited =
      nearest_places(source.middleCols(first, count), placed.places, kPlacesOfSource, num_threads);
  std::vector<std::vector<Visit>> visits(placed.members.size());
  for (std::size_t k = 0; k < visited.target_indices.size(); ++k) {
    visits[static_cast<std::size_t>(visited.target_indices[k])].push_back(
        {first + visited.source_indices[k], k});
  }
  std::vector<NearestFeature> answers(visited.target_indices.size());
  // a place is compared by one thread, and its members are of no other
  parallel::parallel_for(
      static_cast<Index>(visits.size()), 1, num_threads, [&](Index begin, Index end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
          if (visits[k].empty() || deadline.expired()) continue;
          compare(source, visits[k], target, placed.members[k], resolution, nearest, answers);
        }
      });
  std::vector<NearestFeature>& of_source = nearest.both_ways.of_source;
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const auto i = static_cast<std::size_t>(first + visited.source_indices[k]);
    of_source[i] = merged(of_source[i], answers[k]);
  }
  for (std::size_t k = 0; k < answers.size(); ++k) {
    if (answers[k].index >= 0) continue;
    of_source[static_cast<std::size_t>(first + visited.source_indices[k])] = {};
  }
}

}  // namespace

NearestBothWays nearest_in_places(const Features& source, const Features& target, double resolution,
                                  int num_threads, const parallel::Deadline& deadline) {
  const PlacedTargets placed = place(target, num_threads, deadline);
  const auto num_targets = static_cast<std::size_t>(target.cols());
  Nearest nearest{{std::vector<NearestFeature>(static_cast<std::size_t>(source.cols())),
                   std::vector<std::int32_t>(num_targets, -1)},
                  std::vector<std::int32_t>(num_targets, NearestFeature::kNone)};
  for (Index first = 0; first < source.cols() && !deadline.expired(); first += kBetweenLooks) {
    const Index count = std::min(kBetweenLooks, source.cols() - first);
    compare(source, first, count, target, placed, resolution, num_threads, deadline, nearest);
  }
  return std::move(nearest.both_ways);
}

}  // namespace gmcr::frontend
