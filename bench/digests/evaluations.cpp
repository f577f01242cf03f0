// Consensus and uncertainty of given poses, near the truth and far from it.

#include <fmt/core.h>

#include <Eigen/Geometry>

#include "digests/case.hpp"
#include "digests/random.hpp"
#include "digests/settings.hpp"
#include "digests/synthetic.hpp"

namespace gmcr::bench {
namespace {

/// The truth, moved by about `extent` metres.
Similarity moved(const Similarity& truth, double extent, Random& random) {
  const Eigen::Vector3d axis = random.point(-1, 1);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(extent * random.uniform(0, 1), axis.normalized()).toRotationMatrix();
  return {truth.scale, turn * truth.rotation, truth.translation + extent * random.point(-1, 1)};
}

void evaluate(Digest& digest, const Problem& problem, const Similarity& pose,
              const Options& options) {
  const Consensus consensus = evaluate_consensus(pose, problem.source, problem.target, options);
  add(digest, consensus);
  add(digest,
      evaluate_uncertainty(pose, problem.source, problem.target, consensus.inliers, options));
}

void add_case(Cases& cases, const Draw& draw, Scale scale, const Variant& variant, double extent) {
  const std::string name =
      fmt::format("evaluations/{}/{}/{}/{}", name_of(scale), variant.name, name_of(draw), extent);
  cases.push_back({"evaluations", name, [=](Digest& digest, int num_threads) {
                     Random random(seed_of(name));
                     const Problem problem = draw_problem(draw, seed_of(name));
                     evaluate(digest, problem, moved(problem.truth, extent, random),
                              options_for(problem, scale, variant, num_threads));
                   }});
}

}  // namespace

void add_evaluations(Cases& cases) {
  const auto variants = variants_named({"gmcr", "count", "mixed-bounds", "threshold"});
  const Draw draws[] = {{SyntheticKind::Ball, 5, 0},
                        {SyntheticKind::Ball, 100, 0.5},
                        {SyntheticKind::Random, 80, 0.8},
                        {SyntheticKind::Structured, 90, 0.6},
                        {SyntheticKind::Ball, 1000, 0.7}};
  for (const Variant& variant : variants) {
    for (const Scale scale : {Scale::Known, Scale::Range, Scale::Free}) {
      for (const Draw& draw : draws) {
        for (const double extent : {0.0, 0.003, 0.02, 2.0}) {
          add_case(cases, draw, scale, variant, extent);
        }
      }
    }
  }
}

}  // namespace gmcr::bench
