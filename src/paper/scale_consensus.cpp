#include "paper/scale_consensus.hpp"

#include <algorithm>
#include <cmath>

#include "estimation/closed_forms/scale.hpp"
#include "paper/interval_sweep.hpp"

namespace gmcr::paper {

std::optional<ScaleConsensus> scale_consensus(const Tims& tims, const ScaleRange& scales) {
  const ScaleMeasurements measurements = measure_scales(tims);
  ScaleConsensus consensus;
  // Eq. (11), L2: TIMs k, l agree iff [s_k - alpha_k, s_k + alpha_k] meets [s_l - alpha_l, ...]
  consensus.tims =
      deepest_point(measurements.lower.max(scales.min), measurements.upper.min(scales.max)).members;
  // Eq. (10) without outliers: min_s sum_k (s - s_k)^2 / alpha_k^2
  const double scale = estimation::estimate_scale(measurements.scale(consensus.tims),
                                                  measurements.alpha(consensus.tims));
  if (!std::isfinite(scale)) return std::nullopt;
  consensus.scale = std::clamp(scale, scales.min, scales.max);
  return consensus;
}

}  // namespace gmcr::paper
