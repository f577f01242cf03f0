#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gmcr/descriptors.hpp"
#include "gmcr/invalid_option.hpp"
#include "kernels/features/descriptor_distances.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr {
namespace {

constexpr Index kMatchGrain = 64;

struct Neighbour {
  float distance;  ///< squared, for Euclidean ones
  std::int32_t index;
};

/// The `most` nearest of all, nearest first; of those that tie the smaller index first.
void keep_nearest(const float* distances, Index count, std::size_t most,
                  std::vector<Neighbour>& nearest) {
  nearest.clear();
  for (Index j = 0; j < count; ++j) {
    const float distance = distances[j];
    if (nearest.size() == most && !(distance < nearest.back().distance)) continue;
    if (nearest.size() == most) nearest.pop_back();
    const auto place = std::upper_bound(nearest.begin(), nearest.end(), distance,
                                        [](float a, const Neighbour& b) { return a < b.distance; });
    nearest.insert(place, {distance, static_cast<std::int32_t>(j)});
  }
}

/// The nearest targets of each source.
/// @param compare  compare(i, distances): of source i from all targets.
template <class Compare>
std::vector<std::vector<Neighbour>> nearest_of_all(Index num_sources, Index num_targets,
                                                   std::size_t most, int num_threads,
                                                   const Compare& compare) {
  std::vector<std::vector<Neighbour>> nearest(static_cast<std::size_t>(num_sources));
  parallel::parallel_for(num_sources, kMatchGrain, num_threads, [&](Index begin, Index end) {
    constexpr Index kGroup = kernels::GroupedDescriptors<float>::kGroup;
    std::vector<float> distances(static_cast<std::size_t>(num_targets + kGroup));
    for (Index i = begin; i < end; ++i) {
      compare(i, distances.data());
      keep_nearest(distances.data(), num_targets, most, nearest[static_cast<std::size_t>(i)]);
    }
  });
  return nearest;
}

void validate(Index source_values, Index target_values, const DescriptorMatching& options) {
  if (source_values != target_values) {
    throw std::invalid_argument("descriptors: " + std::to_string(source_values) + " and " +
                                std::to_string(target_values) + " values");
  }
  if (options.k < 1) throw InvalidOption("k", std::to_string(options.k) + " is below 1");
  if (!(options.ratio > 0 && options.ratio <= 1)) {
    std::ostringstream problem;
    problem << options.ratio << " is not in (0, 1]";
    throw InvalidOption("ratio", problem.str());
  }
  if (options.num_threads < 0) {
    throw InvalidOption("num_threads", std::to_string(options.num_threads) + " is negative");
  }
}

/// @throws std::invalid_argument naming the first column that is not finite or too large.
void require_comparable(const DescriptorsRef& descriptors, const char* name) {
  // twice as long as this are the longest differences
  const double longest = std::sqrt(double{std::numeric_limits<float>::max()}) / 4;
  for (Index i = 0; i < descriptors.cols(); ++i) {
    if (descriptors.col(i).cast<double>().norm() <= longest) continue;
    throw std::invalid_argument(std::string(name) + ": descriptor " + std::to_string(i) +
                                " is not finite, or its square is not");
  }
}

/// What is near both ways, as matches.
/// @param ratio  that of the options, squared where `Neighbour::distance` is.
template <class Distance>
DescriptorMatches matches_of(const std::vector<std::vector<Neighbour>>& targets_of_source,
                             const std::vector<std::vector<Neighbour>>& sources_of_target,
                             const DescriptorMatching& options, double ratio,
                             const Distance& distance_of) {
  const auto k = static_cast<std::size_t>(options.k);
  DescriptorMatches matches;
  for (std::size_t i = 0; i < targets_of_source.size(); ++i) {
    const std::vector<Neighbour>& nearest = targets_of_source[i];
    for (std::size_t rank = 0; rank < std::min(k, nearest.size()); ++rank) {
      const auto [distance, j] = nearest[rank];
      if (options.ratio < 1 && nearest.size() > k && distance > ratio * nearest[k].distance) {
        continue;
      }
      if (options.mutual) {
        const std::vector<Neighbour>& back = sources_of_target[static_cast<std::size_t>(j)];
        const bool is_mutual =
            std::any_of(back.begin(), back.end(), [i](const Neighbour& neighbour) {
              return neighbour.index == static_cast<std::int32_t>(i);
            });
        if (!is_mutual) continue;
      }
      matches.source_indices.push_back(static_cast<Index>(i));
      matches.target_indices.push_back(j);
      matches.distances.push_back(distance_of(double{distance}));
    }
  }
  return matches;
}

/// @param compare  compare(queries, i, all, distances): of query i from all of the others.
template <class Descriptors, class Compare, class Distance>
DescriptorMatches match_all(const Descriptors& source, const Descriptors& target,
                            const DescriptorMatching& options, double ratio, const Compare& compare,
                            const Distance& distance_of) {
  const auto k = static_cast<std::size_t>(options.k);
  const auto nearest = [&](const Descriptors& queries, const Descriptors& all, std::size_t most) {
    return nearest_of_all(queries.size(), all.size(), most, options.num_threads,
                          [&](Index i, float* distances) { compare(queries, i, all, distances); });
  };
  const auto forward = nearest(source, target, options.ratio < 1 ? k + 1 : k);
  std::vector<std::vector<Neighbour>> backward;
  if (options.mutual) backward = nearest(target, source, k);
  return matches_of(forward, backward, options, ratio, distance_of);
}

/// Descriptor i as plain values.
template <class Value>
std::vector<Value> values_of(const kernels::GroupedDescriptors<Value>& descriptors, Index i) {
  constexpr Index kGroup = kernels::GroupedDescriptors<Value>::kGroup;
  const Value* first =
      descriptors.values() + kGroup * descriptors.num_values() * (i / kGroup) + i % kGroup;
  std::vector<Value> values(static_cast<std::size_t>(descriptors.num_values()));
  for (std::size_t d = 0; d < values.size(); ++d) values[d] = first[kGroup * static_cast<Index>(d)];
  return values;
}

kernels::GroupedDescriptors<float> grouped(const DescriptorsRef& descriptors) {
  return {descriptors.rows(), descriptors.cols(),
          [&](Index d, Index i) { return descriptors(d, i); }};
}

/// Eight bytes a word, filled up with 0.
kernels::GroupedDescriptors<std::uint64_t> grouped(const BinaryDescriptorsRef& descriptors) {
  return {(descriptors.rows() + 7) / 8, descriptors.cols(), [&](Index word, Index i) {
            std::uint64_t bits = 0;
            for (Index byte = 8 * word; byte < std::min(8 * word + 8, descriptors.rows()); ++byte) {
              bits = bits << 8 | descriptors(byte, i);
            }
            return bits;
          }};
}

}  // namespace

DescriptorMatches match_descriptors(const DescriptorsRef& source, const DescriptorsRef& target,
                                    const DescriptorMatching& options) {
  validate(source.rows(), target.rows(), options);
  require_comparable(source, "source");
  require_comparable(target, "target");
  return match_all(
      grouped(source), grouped(target), options, options.ratio * options.ratio,
      [](const auto& queries, Index i, const auto& all, float* distances) {
        kernels::squared_distances(all, values_of(queries, i).data(), distances);
      },
      [](double squared) { return std::sqrt(squared); });
}

DescriptorMatches match_descriptors(const BinaryDescriptorsRef& source,
                                    const BinaryDescriptorsRef& target,
                                    const DescriptorMatching& options) {
  validate(source.rows(), target.rows(), options);
  return match_all(
      grouped(source), grouped(target), options, options.ratio,
      [](const auto& queries, Index i, const auto& all, float* distances) {
        kernels::hamming_distances(all, values_of(queries, i).data(), distances);
      },
      [](double bits) { return bits; });
}

}  // namespace gmcr
