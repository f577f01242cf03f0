#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// A descriptor a column, of any dimension.
using DescriptorsRef = Eigen::Ref<const Eigen::MatrixXf, 0, Eigen::OuterStride<>>;

/// Bits of a descriptor in the bytes of a column.
using BinaryDescriptorsRef =
    Eigen::Ref<const Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>, 0,
               Eigen::OuterStride<>>;

/// Which pairs of descriptors match.
struct DescriptorMatching {
  int k = 1;           ///< nearest targets of a source that may match it, >= 1
  bool mutual = true;  ///< keep a match only where the source is among the k nearest of the target
  /// Keep a match only where its distance is at most this share of that to the (k + 1)-th nearest
  /// target, in (0, 1]; 1 keeps all, and where there is no such target all are kept.
  double ratio = 1;
  int num_threads = 0;  ///< >= 0; 0 uses every core. The result does not depend on it.
};

/// Pairs of columns: source ascending, for each source nearest first.
struct DescriptorMatches {
  std::vector<Index> source_indices;  ///< columns of the source
  std::vector<Index> target_indices;  ///< columns of the target, one a source index
  std::vector<double> distances;      ///< Euclidean, or the number of bits that differ
};

/// Nearest neighbours of descriptors by Euclidean distance, such as learned features: matches for
/// `register_correspondences`.
///
/// All are compared with all. Squared distances are summed in single precision, value after value,
/// so that the result is the same on every machine; of those that tie the smallest index is nearer.
/// @param source, target  D x N and D x M, the same D, any of them may be 0; values are finite, and
///   their squared distances too.
/// @throws std::invalid_argument on a bad shape, value or option.
/// Cost O(N M D), twice where mutual. Memory O((N + M)(D + k)). Deterministic for any thread count.
DescriptorMatches match_descriptors(const DescriptorsRef& source, const DescriptorsRef& target,
                                    const DescriptorMatching& options = {});

/// The same for binary descriptors, by Hamming distance.
/// @param source, target  B x N and B x M bytes, the same B.
DescriptorMatches match_descriptors(const BinaryDescriptorsRef& source,
                                    const BinaryDescriptorsRef& target,
                                    const DescriptorMatching& options = {});

}  // namespace gmcr
