#include <stdexcept>

#include "gmcr/synthetic.hpp"
#include "synthetic/clouds.hpp"
#include "synthetic/kinds.hpp"

namespace gmcr {
namespace {

Index num_source_points(const SyntheticOptions& options) {
  return options.kind == SyntheticKind::Ball ? options.num_correspondences
                                             : options.num_cloud_points;
}

SyntheticProblem make_kind(const SyntheticOptions& options, const Points& points,
                           synthetic::Random& random) {
  switch (options.kind) {
    case SyntheticKind::Ball:
      return synthetic::make_ball(options, points, random);
    case SyntheticKind::Random:
      return synthetic::make_paper_random(options, points, random);
    case SyntheticKind::Structured:
      return synthetic::make_paper_structured(options, points, random);
  }
  throw std::invalid_argument("kind: unknown");
}

}  // namespace

SyntheticProblem make_synthetic(const SyntheticOptions& options) {
  options.validate();
  synthetic::Random random(options.seed);
  const Points points = synthetic::cube_points(num_source_points(options), random);
  return make_kind(options, points, random);
}

SyntheticProblem make_synthetic(const SyntheticOptions& options, const PointsRef& model) {
  options.validate();
  synthetic::Random random(options.seed);
  const Points points = synthetic::model_points(model, num_source_points(options), random);
  return make_kind(options, points, random);
}

}  // namespace gmcr
