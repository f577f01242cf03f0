// Input that leaves the transform open, or almost, and coordinates far from 1.

#include <fmt/core.h>

#include "digests/case.hpp"
#include "digests/random.hpp"
#include "digests/settings.hpp"

namespace gmcr::bench {
namespace {

constexpr double kBound = 0.01;

/// A source, and what becomes of the frames afterwards.
struct Shape {
  std::string name;
  std::function<Points(Random&)> draw;
  double unit = 1;    ///< of both frames, metres
  double offset = 0;  ///< of both frames, metres
  double outlier_rate = 0.3;
};

Points on_line(Random& random, Index size) {
  const Eigen::Vector3d direction = random.point(-1, 1);
  Points points(3, size);
  for (Index i = 0; i < size; ++i) points.col(i) = random.uniform(-0.5, 0.5) * direction;
  return points;
}

Points in_plane(Random& random, Index size) {
  const Eigen::Matrix3d turn = random.rotation();
  Points points = random.points(size, -0.5, 0.5);
  points.row(2).setZero();
  return turn * points;
}

/// Each of a few points many times.
Points repeated(Random& random, Index size, Index num_distinct) {
  const Points distinct = random.points(num_distinct, -0.5, 0.5);
  Points points(3, size);
  for (Index i = 0; i < size; ++i) points.col(i) = distinct.col(i % num_distinct);
  return points;
}

/// A grid, which many turns and shifts map onto itself.
Points on_grid(Random&, Index side) {
  Points points(3, side * side * side);
  for (Index i = 0; i < points.cols(); ++i) {
    points.col(i) = 0.2 * Eigen::Vector3d(i % side, i / side % side, i / side / side);
  }
  return points;
}

Points in_cube(Random& random, Index size) { return random.points(size, -0.5, 0.5); }

/// A line and one point beside it.
Points almost_on_line(Random& random, Index size) {
  Points points = on_line(random, size);
  points.col(0) = random.point(-0.5, 0.5);
  return points;
}

std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes;
  for (Index size = 0; size <= 5; ++size) {
    shapes.push_back(
        {fmt::format("only-{}", size), [=](Random& r) { return in_cube(r, size); }, 1, 0, 0});
  }
  const auto add = [&](const std::string& name, auto draw, double unit = 1, double offset = 0) {
    shapes.push_back({name, draw, unit, offset});
  };
  add("line", [](Random& r) { return on_line(r, 40); });
  add("almost-line", [](Random& r) { return almost_on_line(r, 40); });
  add("plane", [](Random& r) { return in_plane(r, 60); });
  add("one-point", [](Random& r) { return repeated(r, 30, 1); });
  add("two-points", [](Random& r) { return repeated(r, 40, 2); });
  add("five-points", [](Random& r) { return repeated(r, 60, 5); });
  add("twenty-points", [](Random& r) { return repeated(r, 60, 20); });
  add("grid", [](Random& r) { return on_grid(r, 4); });
  add(
      "far", [](Random& r) { return in_cube(r, 60); }, 1, 1e6);
  add(
      "millimetres", [](Random& r) { return in_cube(r, 60); }, 1e-3);
  add(
      "in-millimetres", [](Random& r) { return in_cube(r, 60); }, 1e3);
  add(
      "kilometres-far", [](Random& r) { return in_cube(r, 60); }, 1e3, 1e6);
  return shapes;
}

Similarity draw_motion(Random& random, const Shape& shape) {
  const Eigen::Vector3d translation = shape.unit * random.point(-1, 1);
  return {random.uniform(0.5, 2), random.rotation(), translation};
}

Problem draw_problem(const Shape& shape, bool is_exact, std::uint64_t seed) {
  Random random(seed);
  Problem problem;
  problem.noise_bound = shape.unit * kBound;
  problem.source = shape.unit * shape.draw(random);
  problem.truth = draw_motion(random, shape);
  problem.target = problem.truth.apply(problem.source);
  for (Index i = 0; i < problem.source.cols(); ++i) {
    if (random.uniform(0, 1) < shape.outlier_rate) {
      problem.target.col(i) = shape.unit * random.point(-2, 2);
    } else if (!is_exact) {
      problem.target.col(i) += 0.5 * problem.noise_bound * random.point(-1, 1);
    }
  }
  const Eigen::Vector3d offset = Eigen::Vector3d(1, -2, 0.5) * shape.offset;
  problem.source.colwise() += offset;
  problem.target.colwise() -= offset;
  const Similarity from_origin{1, Eigen::Matrix3d::Identity(), -offset};
  problem.truth = from_origin * problem.truth * from_origin;
  return problem;
}

void add_case(Cases& cases, const Shape& shape, bool is_exact, Scale scale,
              const Variant& variant) {
  const std::string name = fmt::format("degenerate/{}/{}/{}/{}", name_of(scale), variant.name,
                                       shape.name, is_exact ? "exact" : "noisy");
  cases.push_back(
      {"degenerate", name, [=](Digest& digest, int num_threads) {
         const Problem problem = draw_problem(shape, is_exact, seed_of(name));
         add(digest, register_correspondences(problem.source, problem.target,
                                              options_for(problem, scale, variant, num_threads)));
       }});
}

}  // namespace

void add_degenerate(Cases& cases) {
  const auto variants = variants_named({"gmcr", "count", "paper", "all-priors", "one-to-one",
                                        "hypotheses", "mixed-bounds", "auto-noise"});
  for (const Variant& variant : variants) {
    for (const Scale scale : {Scale::Known, Scale::Range, Scale::Free}) {
      for (const Shape& shape : all_shapes()) {
        const bool is_exact = seed_of(variant.name + shape.name) % 2 == 0;
        add_case(cases, shape, is_exact, scale, variant);
      }
    }
  }
}

}  // namespace gmcr::bench
