#pragma once

#include "gmcr/registration.hpp"
#include "random_geometry.hpp"

namespace gmcr::testing {

/// Correspondences under a known transform; the first `num_inliers` follow it, the others are
/// random.
struct Problem {
  Points source, target;
  Similarity truth;
  double noise_bound = 0.01;

  Options options() const {
    Options o;
    o.noise_bound = noise_bound;
    o.scale = truth.scale;
    return o;
  }
  Options options_with_unknown_scale() const {
    Options o;
    o.noise_bound = noise_bound;
    o.scale_mode = ScaleMode::Estimated;
    return o;
  }
};

inline Problem random_problem(std::uint64_t seed, Index num_inliers, Index num_outliers,
                              double scale = 1) {
  RandomGeometry random(seed);
  Problem problem;
  const Index count = num_inliers + num_outliers;
  problem.truth = random.similarity(scale, scale, 1);
  problem.source = random.in_cube(count);
  problem.target = problem.truth.apply(problem.source);
  for (Index i = 0; i < num_inliers; ++i) {
    problem.target.col(i) += random.in_ball(problem.noise_bound);
  }
  for (Index i = num_inliers; i < count; ++i) {
    problem.target.col(i) = problem.truth.translation + random.in_ball(scale);
  }
  return problem;
}

}  // namespace gmcr::testing
