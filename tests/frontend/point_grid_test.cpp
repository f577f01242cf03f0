#include "frontend/points/point_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "frontend/alignment/surface_cloud.hpp"
#include "frontend/points/cell_order.hpp"
#include "frontend/shapes.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

using testing::random_points;

std::array<double, 3> cell_of(const Points& points, Index i, double edge) {
  const Eigen::Vector3d origin = points.rowwise().minCoeff();
  const Eigen::Vector3d cell = ((points.col(i) - origin) / edge).array().floor();
  return {cell.x(), cell.y(), cell.z()};
}

/// Checks that cells ascend, and that the points of each are its points, ascending.
void expect_ordered(const Points& points, double edge) {
  const CellOrder order = order_by_cell(points, points.rowwise().minCoeff(), edge);
  ASSERT_EQ(order.points.size(), static_cast<std::size_t>(points.cols()));
  ASSERT_EQ(order.starts.size(), static_cast<std::size_t>(order.num_cells()) + 1);
  std::array<double, 3> before{-1, -1, -1};
  for (Index k = 0; k < order.num_cells(); ++k) {
    const std::array<double, 3> cell{order.cells(0, k), order.cells(1, k), order.cells(2, k)};
    EXPECT_LT(before, cell);
    before = cell;
    const auto begin = static_cast<std::size_t>(order.starts[static_cast<std::size_t>(k)]);
    const auto end = static_cast<std::size_t>(order.starts[static_cast<std::size_t>(k) + 1]);
    ASSERT_LT(begin, end);
    for (std::size_t at = begin; at < end; ++at) {
      EXPECT_EQ(cell_of(points, order.points[at], edge), cell);
      if (at > begin) {
        EXPECT_LT(order.points[at - 1], order.points[at]);
      }
    }
  }
}

TEST(CellOrder, IsThatOfTheCells) {
  for (const double edge : {0.01, 0.1, 0.3, 5.0}) expect_ordered(random_points(1000, 1), edge);
}

TEST(CellOrder, HoldsWhere64BitsDoNotNumberTheCells) {
  Points points = random_points(200, 2);
  points.col(50) = Eigen::Vector3d(1e8, 1e8, 1e8);
  points.col(51) = Eigen::Vector3d(1e8, 0, 0);
  expect_ordered(points, 1e-3);
}

/// Ascending.
std::vector<Index> points_of(const PointGrid& grid, std::span<const kernels::PointRun> runs) {
  std::vector<Index> points;
  for (const kernels::PointRun& run : runs) {
    for (std::int32_t slot = run.begin; slot < run.end; ++slot) points.push_back(grid.point(slot));
  }
  std::sort(points.begin(), points.end());
  return points;
}

TEST(PointGrid, RunsHoldWhatIsWithinReach) {
  const double reach = 0.15;
  for (const double far : {0.0, 1e12}) {  // with a stray point there are too many cells for a box
    Points points = random_points(500, 3);
    points.col(9) = Eigen::Vector3d(far, 0, 0);
    const PointGrid grid(points, reach);
    const Points queries = random_points(300, 4);
    PointGrid::Runs room;
    for (Index q = 0; q < queries.cols(); ++q) {
      const Eigen::Vector3d query = 1.2 * queries.col(q);  // some beyond the points
      const std::vector<Index> in_runs = points_of(grid, grid.runs_about(query.data(), room));
      EXPECT_EQ(std::adjacent_find(in_runs.begin(), in_runs.end()), in_runs.end());
      for (Index i = 0; i < points.cols(); ++i) {
        if ((points.col(i) - query).norm() > reach) continue;
        EXPECT_TRUE(std::binary_search(in_runs.begin(), in_runs.end(), i));
      }
    }
  }
}

TEST(PointGrid, OfPositionsFarFromAllPointsHasNoRuns) {
  const Points points = random_points(500, 3);
  const PointGrid grid(points, 0.15);
  PointGrid::Runs room;
  for (const double far : {-1e3, -2.0, 2.0, 1e3, 1e300}) {
    for (Index axis = 0; axis < 3; ++axis) {
      Eigen::Vector3d query = points.col(0);
      query[axis] = far;
      EXPECT_TRUE(points_of(grid, grid.runs_about(query.data(), room)).empty());
      EXPECT_TRUE(points_of(grid, grid.runs_within(query.data(), 0.15, room)).empty());
    }
  }
}

TEST(PointGrid, RunsThatARadiusMeetsHoldWhatIsWithinIt) {
  const double reach = 0.15;
  for (const double far : {0.0, 1e3}) {  // a stray point puts the cells far from the first one
    Points points = random_points(500, 3);
    points.col(9) = Eigen::Vector3d(-far, -far, -far);
    const PointGrid grid(points, reach);
    const Points queries = random_points(300, 4);
    std::size_t num_left_out = 0;
    for (const double radius : {reach, 0.5 * reach, 0.01 * reach}) {
      for (Index q = 0; q < queries.cols(); ++q) {
        const Eigen::Vector3d query = 1.2 * queries.col(q);
        PointGrid::Runs room;
        const auto within = grid.runs_within(query.data(), radius, room);
        const std::vector<Index> in_runs = points_of(grid, within);
        PointGrid::Runs all;
        num_left_out += points_of(grid, grid.runs_about(query.data(), all)).size() - in_runs.size();
        for (Index i = 0; i < points.cols(); ++i) {
          if ((points.col(i) - query).norm() > radius) continue;
          EXPECT_TRUE(std::binary_search(in_runs.begin(), in_runs.end(), i));
        }
      }
    }
    EXPECT_GT(num_left_out, 100u);
  }
}

TEST(SurfaceCloud, FindsTheNearestPointAtAnyRadius) {
  const Points points = random_points(400, 5);
  SurfaceCloud cloud(points, Eigen::Vector3d::Zero(), 0.02);
  const Points queries = random_points(100, 6);
  for (const double radius : {0.03, 0.06, 0.2, 3.0}) {
    const std::vector<Index> found = cloud.nearest(queries, radius, 2);
    for (Index q = 0; q < queries.cols(); ++q) {
      Index nearest = -1;
      const double distance =
          (points.colwise() - queries.col(q)).colwise().norm().minCoeff(&nearest);
      EXPECT_EQ(found[static_cast<std::size_t>(q)], distance <= radius ? nearest : -1);
    }
  }
}

TEST(SurfaceCloud, TellsSeveralThreadsAtOnceWhatItTellsOne) {
  const Points points = random_points(3000, 8), queries = random_points(200, 9);
  const std::vector<double> radii{0.05, 0.1, 0.3, 1.0};  // each wider grid is made when asked for
  std::vector<Index> all(3000);
  std::iota(all.begin(), all.end(), Index{0});
  SurfaceCloud alone(points, Eigen::Vector3d::Zero(), 0.02);
  std::vector<std::vector<Index>> expected;
  for (const double radius : radii) expected.push_back(alone.nearest(queries, radius, 1));
  alone.require_normals(all, 1);
  for (int repetition = 0; repetition < 5; ++repetition) {
    SurfaceCloud shared(points, Eigen::Vector3d::Zero(), 0.02);
    std::vector<std::vector<Index>> found(40);
    parallel::parallel_for(std::ssize(found), 1, 8, [&](Index i, Index) {
      const auto k = static_cast<std::size_t>(i);
      found[k] = shared.nearest(queries, radii[(radii.size() - 1) - k % radii.size()], 1);
      shared.require_normals(all, 1);
    });
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k], expected[(radii.size() - 1) - k % radii.size()]);
    }
    for (const Index i : all) EXPECT_EQ(shared.normal(i), alone.normal(i));
  }
}

TEST(SurfaceCloud, HasNormalsWhereNeighboursAreFar) {
  // a plane whose points thin out with the distance
  Points points = random_points(600, 7);
  for (Index i = 0; i < points.cols(); ++i) points.col(i) *= std::pow(1.02, static_cast<double>(i));
  points.row(2).setZero();
  SurfaceCloud cloud(points, Eigen::Vector3d::Zero(), 0.05);
  std::vector<Index> all(600);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
  cloud.require_normals(all, 2);
  for (const Index i : all) EXPECT_NEAR(std::abs(cloud.normal(i).z()), 1, 1e-9) << i;
}

TEST(SurfaceCloud, OfFewPointsHasNormalsFromAll) {
  Points points(3, 4);
  points << 0, 1, 0, 50, 0, 0, 1, 50, 0, 0, 0, 0;
  SurfaceCloud four(points, Eigen::Vector3d::Zero(), 0.1);
  four.require_normals({0, 3}, 1);
  EXPECT_NEAR(std::abs(four.normal(0).z()), 1, 1e-12);
  EXPECT_NEAR(std::abs(four.normal(3).z()), 1, 1e-12);
  SurfaceCloud two(points.leftCols(2), Eigen::Vector3d::Zero(), 0.1);
  two.require_normals({0, 1}, 1);
  EXPECT_TRUE(two.normal(0).isZero(0));
}

}  // namespace
}  // namespace gmcr::frontend
