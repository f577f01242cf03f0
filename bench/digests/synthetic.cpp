#include "digests/synthetic.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "digests/random.hpp"

namespace gmcr::bench {
namespace {

constexpr double kRates[] = {0, 0.3, 0.6, 0.8, 0.9, 0.95, 0.98};
constexpr SyntheticKind kKinds[] = {SyntheticKind::Ball, SyntheticKind::Random,
                                    SyntheticKind::Structured};

SyntheticOptions benchmark_options(SyntheticKind kind) {
  if (kind == SyntheticKind::Random) return paper_random_options();
  if (kind == SyntheticKind::Structured) return paper_structured_options();
  SyntheticOptions options;
  options.scale_range = {0.5, 2};
  return options;
}

NoiseShape noise_of(std::uint64_t seed) {
  constexpr NoiseShape kShapes[] = {NoiseShape::Ball, NoiseShape::Gaussian};
  return kShapes[seed % 2];
}

SyntheticOptions options_of(const Draw& draw, std::uint64_t seed) {
  SyntheticOptions options = benchmark_options(draw.kind);
  options.num_correspondences = draw.size;
  options.num_cloud_points = std::max(options.num_cloud_points, draw.size);
  options.outlier_rate = draw.outlier_rate;
  options.seed = seed;
  if (draw.kind == SyntheticKind::Ball) options.noise_shape = noise_of(seed);
  return options;
}

/// Whether it takes a moment: the paper's method searches graphs of all its measurements, exactly,
/// and an estimated noise bound costs many solves.
bool is_quick(const Variant& variant, const Draw& draw, Scale scale) {
  const bool is_known = scale == Scale::Known;
  if (variant.name.starts_with("paper")) {
    return draw.size <= (is_known ? 90 : 40) ||
           (is_known && draw.size <= 400 && draw.outlier_rate >= 0.9);
  }
  return is_known || draw.size <= 90 || !variant.name.starts_with("auto-noise");
}

/// Every rate, the kinds in turn from `first_kind` on.
std::vector<Draw> draws_of(Index size, std::size_t first_kind) {
  std::vector<Draw> draws;
  for (const double rate : kRates) draws.push_back({kKinds[first_kind++ % 3], size, rate});
  return draws;
}

}  // namespace

std::string name_of(const Draw& draw) {
  constexpr const char* kNames[] = {"ball", "random", "structured"};
  return fmt::format("{}-{}-{}", kNames[static_cast<int>(draw.kind)], draw.size, draw.outlier_rate);
}

Problem draw_problem(const Draw& draw, std::uint64_t seed) {
  const SyntheticProblem problem = make_synthetic(options_of(draw, seed));
  return {problem.source, problem.target, problem.target_from_source, problem.noise_bound};
}

void add_registration(Cases& cases, const std::string& group, const Draw& draw, Scale scale,
                      const Variant& variant) {
  const std::string name =
      fmt::format("{}/{}/{}/{}", group, name_of(scale), variant.name, name_of(draw));
  cases.push_back(
      {group, name, [=](Digest& digest, int num_threads) {
         const Problem problem = draw_problem(draw, seed_of(name));
         add(digest, register_correspondences(problem.source, problem.target,
                                              options_for(problem, scale, variant, num_threads)));
       }});
}

void add_known_scale(Cases& cases) {
  std::size_t kind = 0;
  for (const Variant& variant : all_variants()) {
    for (const Index size : {12, 40, 90, 200, 400}) {
      for (const Draw& draw : draws_of(size, kind++)) {
        if (!is_quick(variant, draw, Scale::Known)) continue;
        add_registration(cases, "known", draw, Scale::Known, variant);
      }
    }
    for (const double rate : {0.5, 0.9, 0.95, 0.98}) {
      const Draw draw{SyntheticKind::Ball, 1000, rate};
      if (!is_quick(variant, draw, Scale::Known)) continue;
      add_registration(cases, "known-1000", draw, Scale::Known, variant);
    }
  }
  for (const Variant& variant : variants_named({"gmcr", "count", "gravity", "hypotheses"})) {
    for (const Index size : {2000, 5000}) {
      add_registration(cases, "known-large", {SyntheticKind::Ball, size, 0.95}, Scale::Known,
                       variant);
    }
  }
}

void add_unknown_scale(Cases& cases) {
  std::size_t kind = 0;
  for (const Variant& variant : all_variants()) {
    for (const Scale scale : {Scale::Range, Scale::Free}) {
      for (const Index size : {12, 40, 90, 200}) {
        for (const Draw& draw : draws_of(size, kind++)) {
          if (!is_quick(variant, draw, scale)) continue;
          add_registration(cases, "unknown", draw, scale, variant);
        }
      }
    }
  }
  for (const Variant& variant : variants_named({"gmcr", "count", "gravity"})) {
    for (const double rate : {0.5, 0.9}) {
      add_registration(cases, "unknown-large", {SyntheticKind::Ball, 1000, rate}, Scale::Free,
                       variant);
    }
  }
}

void add_drawn(Cases& cases) {
  for (const Index size : {0, 1, 50, 300}) {
    for (const Draw& draw : draws_of(size, static_cast<std::size_t>(size))) {
      const std::string name = "drawn/" + name_of(draw);
      cases.push_back({"drawn", name, [=](Digest& digest, int) {
                         Random random(seed_of(name));
                         SyntheticOptions options = options_of(draw, seed_of(name));
                         add(digest, make_synthetic(options, random.points(1600, -3, 5)));
                       }});
    }
  }
}

void add_certified(Cases& cases) {
  std::size_t kind = 0;
  for (const Variant& variant : certifying_variants()) {
    for (const Scale scale : {Scale::Known, Scale::Range, Scale::Free}) {
      for (const Index size : {12, 40, 60}) {
        for (const Draw& draw : draws_of(size, kind++)) {
          add_registration(cases, "certified", draw, scale, variant);
        }
      }
    }
  }
}

}  // namespace gmcr::bench
