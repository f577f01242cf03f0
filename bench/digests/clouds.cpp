// Raw clouds: bumpy surfaces that overlap in part.

#include <fmt/core.h>

#include "digests/case.hpp"
#include "digests/random.hpp"
#include "digests/settings.hpp"
#include "geometry/elementary.hpp"

namespace gmcr::bench {
namespace {

constexpr double kNoise = 0.005;

struct CloudPair {
  Points source;
  Points target;
  Similarity truth;
};

double height_at(double x, double y) {
  return 0.4 * elementary::sin(2 * x + 0.3) * elementary::cos(1.5 * y) +
         0.2 * elementary::sin(5 * x * y / 3 + y) + 0.15 * x * elementary::cos(3 * y);
}

/// Points on the surface with x from `first_x` to `first_x` + 3.
Points surface(Random& random, Index size, double first_x) {
  Points points(3, size);
  for (Index i = 0; i < size; ++i) {
    const double x = random.uniform(first_x, first_x + 3);
    const double y = random.uniform(-1.5, 1.5);
    points.col(i) = Eigen::Vector3d(x, y, height_at(x, y)) + kNoise * random.point(-1, 1);
  }
  return points;
}

CloudPair draw_pair(Index size, double scale, std::uint64_t seed) {
  Random random(seed);
  CloudPair pair;
  pair.truth = {scale, random.rotation(), random.point(-3, 3)};
  pair.source = surface(random, size, -1.5);
  pair.target = pair.truth.apply(surface(random, size, -1.2));
  return pair;
}

/// The answer, and that for a pose beside its own.
void solve(Digest& digest, const CloudPair& pair, const FrontendOptions& frontend,
           const Options& options) {
  const CloudResult result = register_clouds(pair.source, pair.target, frontend, options);
  add(digest, result);
  Similarity beside = result.registration.target_from_source;
  beside.translation += Eigen::Vector3d(0.01, -0.02, 0.015);
  add(digest, with_pose(result, beside, options));
}

void add_case(Cases& cases, Index size, Scale scale, const FrontendVariant& variant) {
  const std::string name = fmt::format("clouds/{}/{}/{}", name_of(scale), variant.name, size);
  cases.push_back({"clouds", name, [=](Digest& digest, int num_threads) {
                     const double known_scale = scale == Scale::Known ? 1 : 1.3;
                     solve(digest, draw_pair(size, known_scale, seed_of(name)), variant.options,
                           cloud_options(scale, known_scale, num_threads));
                   }});
}

void add_matching(Cases& cases, Index size, const FrontendVariant& variant) {
  const std::string name = fmt::format("clouds/matches/{}/{}", variant.name, size);
  cases.push_back({"clouds", name, [=](Digest& digest, int num_threads) {
                     const CloudPair pair = draw_pair(size, 1, seed_of(name));
                     add(digest, match_clouds(pair.source, pair.target, variant.options,
                                              cloud_options(Scale::Known, 1, num_threads)));
                   }});
}

}  // namespace

void add_clouds(Cases& cases) {
  for (const double voxel_size : {0.0, 0.2}) {
    for (FrontendVariant variant : frontend_variants(voxel_size)) {
      variant.name += voxel_size == 0 ? "-auto" : "-voxels";
      for (const Index size : {0, 3, 100, 1000, 3000}) add_matching(cases, size, variant);
      for (const Index size : {0, 100, 1000, 3000}) {
        add_case(cases, size, Scale::Known, variant);
      }
      if (voxel_size == 0) add_case(cases, 1000, Scale::Range, variant);
    }
  }
}

}  // namespace gmcr::bench
