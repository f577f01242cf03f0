// Several instances of one object among outliers.

#include <fmt/core.h>

#include "digests/case.hpp"
#include "digests/random.hpp"
#include "digests/settings.hpp"

namespace gmcr::bench {
namespace {

constexpr Index kObjectPoints = 25;
constexpr Index kOutliers = 40;
constexpr double kInstanceBound = 0.01;

/// Each instance holds a few points less than the one before.
Problem draw_problem(Index num_instances, std::uint64_t seed) {
  Random random(seed);
  const Points object = random.points(kObjectPoints, -0.5, 0.5);
  Problem problem;
  problem.noise_bound = kInstanceBound;
  problem.source.resize(3, num_instances * kObjectPoints + kOutliers);
  problem.target = random.points(problem.source.cols(), -3, 3);
  Index column = 0;
  for (Index instance = 0; instance < num_instances; ++instance) {
    const Similarity motion{1, random.rotation(), random.point(-2, 2)};
    if (instance == 0) problem.truth = motion;
    for (Index i = 3 * instance; i < kObjectPoints; ++i, ++column) {
      problem.source.col(column) = object.col(i);
      problem.target.col(column) =
          motion * object.col(i) + 0.5 * kInstanceBound * random.point(-1, 1);
    }
  }
  for (; column < problem.source.cols(); ++column) {
    problem.source.col(column) = object.col(random.index(kObjectPoints));
  }
  return problem;
}

void add_case(Cases& cases, Index num_instances, Scale scale, const Variant& variant,
              const InstanceOptions& instances, const std::string& limits) {
  const std::string name =
      fmt::format("instances/{}/{}/{}/{}", name_of(scale), variant.name, num_instances, limits);
  cases.push_back({"instances", name, [=](Digest& digest, int num_threads) {
                     const Problem problem = draw_problem(num_instances, seed_of(name));
                     add(digest, register_instances(
                                     problem.source, problem.target,
                                     options_for(problem, scale, variant, num_threads), instances));
                   }});
}

}  // namespace

void add_instances(Cases& cases) {
  const auto variants = variants_named({"gmcr", "count", "paper", "gravity", "one-to-one",
                                        "hypotheses", "mixed-bounds", "auto-noise"});
  for (const Variant& variant : variants) {
    for (const Scale scale : {Scale::Known, Scale::Range}) {
      for (const Index num_instances : {1, 2, 4}) {
        add_case(cases, num_instances, scale, variant, {}, "standard");
      }
    }
    add_case(cases, 3, Scale::Known, variant, instance_options(2, 3, 0), "two");
    add_case(cases, 3, Scale::Known, variant, instance_options(5, 21, 0.5), "large");
  }
}

}  // namespace gmcr::bench
