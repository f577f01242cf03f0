#include "gmcr/registration.hpp"
#include "problem/input.hpp"
#include "registration/estimated_noise.hpp"
#include "registration/solve.hpp"

namespace gmcr {

Result register_correspondences(const PointsRef& source, const PointsRef& target,
                                const Options& options) {
  problem::validate_input(source, target, options);
  return registration::with_noise_bound(source, target, options, registration::solve);
}

}  // namespace gmcr
