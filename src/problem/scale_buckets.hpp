#pragma once

#include <cmath>
#include <numbers>

#include "geometry/elementary.hpp"

namespace gmcr::problem {

/// Scales in buckets: that of the centre c 2^k holds the scales from c 2^k / sqrt(2) to
/// c 2^k sqrt(2). With c = 1 the scales 0.71 to 1.41 have the centre 1, 1.41 to 2.83 the centre 2.
class ScaleBuckets {
 public:
  /// @param centre  of one of the buckets, > 0, finite.
  explicit ScaleBuckets(double centre) : centre_(centre) {}

  /// Centre of the bucket of a scale, >= 0. It does not fall as the scale grows. Scales whose ratio
  /// to the centre is no double, such as 0 and infinity, stay what they are.
  double centre_of(double scale) const {
    const double ratio = scale / centre_;
    if (ratio == 0 || std::isinf(ratio)) return scale;
    int exponent = 0;
    const double mantissa = std::frexp(ratio, &exponent);  // in [0.5, 1)
    return std::ldexp(centre_, mantissa < kSqrtHalf ? exponent - 1 : exponent);
  }

  /// What divides an bucket into `count` even parts: edge 0 is the end of an bucket, by a rounding
  /// below it; edge `count` that of the next one.
  double edge(int k, int count) const {
    const int bucket = static_cast<int>(std::floor(static_cast<double>(k) / count));
    const double share = static_cast<double>(k - bucket * count) / count;
    return std::ldexp(centre_ * kEnd * elementary::exp(share * std::numbers::ln2), bucket);
  }

 private:
  static constexpr double kSqrtHalf = 0.70710678118654752;
  static constexpr double kEnd = kSqrtHalf * (1 - 1e-14);

  double centre_;
};

}  // namespace gmcr::problem
