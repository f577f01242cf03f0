#pragma once

#include "gmcr/types.hpp"

namespace gmcr::problem {

/// What a bound speaks of.
enum class Measure { Inliers, Evidence };

/// Whether a sum of weights is more than another, beyond its rounding.
inline bool exceeds(double sum, double other) { return sum > other * (1 + 1e-12); }

/// A number for each measure, such as proven upper bounds.
struct PerMeasure {
  double inliers = 0;
  double evidence = 0;

  double& of(Measure measure) { return measure == Measure::Inliers ? inliers : evidence; }
  double of(Measure measure) const { return measure == Measure::Inliers ? inliers : evidence; }
};

}  // namespace gmcr::problem
