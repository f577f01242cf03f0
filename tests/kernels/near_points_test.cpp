#include "kernels/points/near_points.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

using kernels::NearestPoint;
using kernels::NearPoints;
using kernels::PointColumns;
using kernels::PointRun;

constexpr std::int32_t kCount = 200;

struct Scene {
  Eigen::MatrixX3d points;
  std::vector<PointRun> runs;
  Eigen::Vector3d query;
  double squared_radius;

  PointColumns columns() const {
    return {points.col(0).data(), points.col(1).data(), points.col(2).data()};
  }
};

/// Ascending runs with gaps, some empty. On a lattice of few values many distances tie.
Scene scene(std::uint64_t seed, bool is_lattice) {
  testing::RandomGeometry random(seed);
  Scene made;
  made.points.resize(kCount + PointColumns::kPadding, 3);
  for (double& value : made.points.reshaped()) {
    value = random.uniform(-2, 2);
    if (is_lattice) value = std::round(value);
  }
  for (std::int32_t begin = 0; begin < kCount;) {
    const auto end =
        std::min<std::int32_t>(kCount, begin + static_cast<std::int32_t>(random.uniform(0, 20)));
    made.runs.push_back({begin, end});
    begin = end + static_cast<std::int32_t>(random.uniform(0, 4));
  }
  made.query = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  if (is_lattice) made.query = made.query.array().round();
  made.squared_radius = random.uniform(0, 9);
  if (is_lattice) made.squared_radius = std::round(made.squared_radius);
  return made;
}

struct Found {
  std::vector<std::int64_t> indices;
  std::vector<double> squared_distances;
};

template <class Search>
Found found_by(const Search& search, const Scene& in) {
  Found found;
  found.indices.resize(kCount + NearPoints::kSlack);
  found.squared_distances.resize(found.indices.size());
  const Index count = search(in.columns(), in.runs, in.query.data(), in.squared_radius,
                             {found.indices.data(), found.squared_distances.data()});
  found.indices.resize(static_cast<std::size_t>(count));
  found.squared_distances.resize(static_cast<std::size_t>(count));
  return found;
}

TEST(NearPoints, AreThoseOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const Scene in = scene(seed, seed % 2 == 1);
      const Found found = found_by(kernels::near_points, in);
      const Found expected = found_by(kernels::near_points_reference, in);
      ASSERT_EQ(found.indices, expected.indices) << seed;
      ASSERT_EQ(found.squared_distances, expected.squared_distances) << seed;
    }
  });
}

TEST(NearPoints, AreNearerThanTheRadiusAndTheOthersAreNot) {
  const Scene in = scene(3, true);
  const Found found = found_by(kernels::near_points_reference, in);
  ASSERT_FALSE(found.indices.empty());
  for (const PointRun& run : in.runs) {
    for (std::int64_t i = run.begin; i < run.end; ++i) {
      const bool is_near =
          (in.points.row(i).transpose() - in.query).squaredNorm() < in.squared_radius;
      EXPECT_EQ(std::count(found.indices.begin(), found.indices.end(), i), is_near ? 1 : 0);
    }
  }
}

TEST(NearestPoint, IsThatOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    Index num_found = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      const Scene in = scene(seed, seed % 2 == 1);
      const auto nearest =
          kernels::nearest_point(in.columns(), in.runs, in.query.data(), in.squared_radius);
      const auto expected = kernels::nearest_point_reference(in.columns(), in.runs, in.query.data(),
                                                             in.squared_radius);
      ASSERT_EQ(nearest.index, expected.index) << seed;
      ASSERT_EQ(nearest.squared_distance, expected.squared_distance) << seed;
      num_found += nearest.index >= 0;
    }
    EXPECT_GT(num_found, 200);
    EXPECT_LT(num_found, 400);
  });
}

TEST(NearestPoint, IsTheNearestOfAll) {
  const Scene in = scene(4, false);
  const auto found = found_by(kernels::near_points_reference, in);
  ASSERT_FALSE(found.indices.empty());
  const auto least =
      std::min_element(found.squared_distances.begin(), found.squared_distances.end());
  const auto nearest =
      kernels::nearest_point_reference(in.columns(), in.runs, in.query.data(), in.squared_radius);
  EXPECT_EQ(nearest.squared_distance, *least);
  EXPECT_EQ(nearest.index,
            found.indices[static_cast<std::size_t>(least - found.squared_distances.begin())]);
}

}  // namespace
}  // namespace gmcr
