#include "kernels/pairs/consistency_tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

using geometry::CorrespondenceArrays;
using kernels::ConsistencyTiles;

/// A third of the correspondences are inliers of the identity, others random; some are duplicates.
geometry::CorrespondenceArrays mixed_arrays(std::uint64_t seed, Index count, double size,
                                            double bound) {
  testing::RandomGeometry random(seed);
  geometry::CorrespondenceArrays arrays{random.in_cube(count, size).transpose(),
                                        random.in_cube(count, size).transpose(),
                                        Eigen::ArrayXd::Constant(count, bound)};
  for (Index i = 0; i < count; i += 3) {
    arrays.target.row(i) = arrays.source.row(i) + random.in_ball(bound).transpose();
  }
  for (Index i = 10; i < count; i += 11) {
    arrays.source.row(i) = arrays.source.row(i - 1);
    arrays.target.row(i) = arrays.target.row(i - 1) + random.in_ball(2 * bound).transpose();
  }
  return arrays;
}

/// All coordinates are multiples of 1 / 1024, and many pairs are off by exactly their bound.
geometry::CorrespondenceArrays edge_arrays(std::uint64_t seed, Index count, double offset = 0) {
  testing::RandomGeometry random(seed);
  geometry::CorrespondenceArrays arrays{Eigen::MatrixX3d(count, 3), Eigen::MatrixX3d(count, 3),
                                        Eigen::ArrayXd::Constant(count, 1.0 / 32)};
  for (Index i = 0; i < count; ++i) {
    // along one axis, so that lengths are exact as well
    const double x = static_cast<double>(random.index(2048)) / 1024;
    const double moved = static_cast<double>(random.index(5)) / 64 - 1.0 / 32;
    arrays.source.row(i) << offset + x, -offset, offset;
    arrays.target.row(i) << 2 * offset, offset + x + moved, 0.5 * offset;
  }
  return arrays;
}

/// Compares all tiles with the reference on every instruction set.
void expect_reference_bits(const geometry::CorrespondenceArrays& arrays, double scale_min,
                           double scale_max, bool single_precision) {
  const Index count = arrays.size(), num_blocks = (count + 63) / 64;
  std::vector<std::vector<std::uint64_t>> reference(static_cast<std::size_t>(num_blocks * 64));
  for (auto& row : reference) row.resize(static_cast<std::size_t>(num_blocks));
  for (Index i = 0; i < count; ++i) {
    kernels::consistency_row_reference(arrays, i, scale_min, scale_max,
                                       reference[static_cast<std::size_t>(i)]);
  }
  const ConsistencyTiles tiles(arrays, scale_min, scale_max);
  EXPECT_EQ(tiles.is_single_precision(), single_precision);
  ASSERT_EQ(tiles.num_blocks(), num_blocks);
  testing::for_each_isa([&] {
    for (Index row = 0; row < num_blocks; ++row) {
      for (Index column = 0; column < num_blocks; ++column) {
        const kernels::BitBlock tile = tiles.tile(row, column);
        for (std::size_t r = 0; r < 64; ++r) {
          ASSERT_EQ(
              tile[r],
              reference[static_cast<std::size_t>(row) * 64 + r][static_cast<std::size_t>(column)])
              << row << ' ' << column << ' ' << r;
        }
      }
    }
  });
}

TEST(ConsistencyTiles, HaveTheBitsOfTheReferenceAtEverySizeAroundABlock) {
  for (const Index count : {0, 1, 63, 64, 65, 255, 256, 257, 319, 320, 321}) {
    const auto arrays = mixed_arrays(static_cast<std::uint64_t>(count), count, 1, 0.01);
    expect_reference_bits(arrays, 1, 1, count >= 256);
    expect_reference_bits(arrays, 0.8, 1.1, count >= 256);
  }
}

TEST(ConsistencyTiles, HaveTheBitsOfTheReferenceWithManyBounds) {
  testing::RandomGeometry random(1);
  auto arrays = mixed_arrays(2, 400, 1, 0.01);
  for (double& bound : arrays.bounds) bound = random.uniform(0.001, 0.3);
  expect_reference_bits(arrays, 1, 1, true);
  expect_reference_bits(arrays, 0.5, 2, true);
  expect_reference_bits(arrays, 0, 1, true);
}

TEST(ConsistencyTiles, HaveTheBitsOfTheReferenceForEveryRatioOfNoiseToExtent) {
  for (const double bound : {100.0, 1.0, 0.1, 1e-2, 1e-3, 2e-4}) {
    expect_reference_bits(mixed_arrays(3, 400, 1, bound), 1, 1, true);
    expect_reference_bits(mixed_arrays(3, 400, 1, bound), 0.9, 1.3, true);
  }
  for (const double bound : {0.0, 1e-12, 1e-6}) {
    expect_reference_bits(mixed_arrays(3, 300, 1, bound), 1, 1, false);
    expect_reference_bits(mixed_arrays(3, 300, 1, bound), 0.9, 1.3, false);
  }
}

TEST(ConsistencyTiles, DecideEdgesOnTheBoundaryAsTheReferenceDoes) {
  const auto arrays = edge_arrays(4, 700);
  expect_reference_bits(arrays, 1, 1, true);
  expect_reference_bits(arrays, 0.5, 1, true);
  int on_boundary = 0;
  for (Index i = 0; i < 20; ++i) {
    for (Index j = i + 1; j < 700; ++j) {
      const double a = std::abs(arrays.source(i, 0) - arrays.source(j, 0));
      const double b = std::abs(arrays.target(i, 1) - arrays.target(j, 1));
      if (std::abs(a - b) != 1.0 / 16) continue;
      ++on_boundary;
      EXPECT_TRUE(kernels::is_consistent(arrays, i, j, 1, 1));
    }
  }
  EXPECT_GT(on_boundary, 500);
}

TEST(ConsistencyTiles, LoseNothingFarFromTheOrigin) {
  const auto near = edge_arrays(5, 400), far = edge_arrays(5, 400, 1e6);
  const ConsistencyTiles near_tiles(near, 1, 1), far_tiles(far, 1, 1);
  EXPECT_TRUE(near_tiles.is_single_precision());
  EXPECT_TRUE(far_tiles.is_single_precision());
  for (Index row = 0; row < near_tiles.num_blocks(); ++row) {
    for (Index column = 0; column < near_tiles.num_blocks(); ++column) {
      EXPECT_EQ(near_tiles.tile(row, column), far_tiles.tile(row, column));
    }
  }
  // too far for the digits that are left
  expect_reference_bits(edge_arrays(5, 300, 0x1p25), 1, 1, false);
}

TEST(ConsistencyTiles, HaveTheBitsOfTheReferenceInAnyUnit) {
  for (const double unit : {1e-6, 1e-3, 1e3, 1e6, 1e20}) {
    auto arrays = mixed_arrays(6, 300, 1, 0.01);
    arrays.source *= unit;
    arrays.target *= unit;
    arrays.bounds *= unit;
    expect_reference_bits(arrays, 1, 1, true);
    // source and target in units of their own
    arrays.source /= unit;
    expect_reference_bits(arrays, unit, unit, true);
    expect_reference_bits(arrays, 0.9 * unit, 1.2 * unit, true);
  }
  for (const double unit : {1e-100, 1e-60, 1e60, 1e100, 1e160}) {
    auto arrays = mixed_arrays(6, 300, 1, 0.01);
    arrays.source *= unit;
    arrays.target *= unit;
    arrays.bounds *= unit;
    expect_reference_bits(arrays, 1, 1, false);
  }
}

TEST(ConsistencyTiles, HaveTheBitsOfTheReferenceWithValuesThatAreNoNumbers) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double value : {kNan, kInfinity, -kInfinity}) {
    for (int place = 0; place < 3; ++place) {
      auto arrays = mixed_arrays(7, 300, 1, 0.01);
      (place == 0   ? arrays.source(77, 1)
       : place == 1 ? arrays.target(5, 2)
                    : arrays.bounds[299]) = value;
      expect_reference_bits(arrays, 1, 1, false);
      expect_reference_bits(arrays, 0.5, 2, false);
    }
  }
  expect_reference_bits(mixed_arrays(8, 300, 1, 0.01), 0.5, kInfinity, false);
}

TEST(ConsistencyTiles, OfCoincidentPointsHaveTheBitsOfTheReference) {
  auto arrays = mixed_arrays(9, 300, 1, 0.01);
  arrays.source.setConstant(0.25);
  expect_reference_bits(arrays, 1, 1, true);
  arrays.target.setConstant(-3);
  expect_reference_bits(arrays, 1, 1, false);
}

}  // namespace
}  // namespace gmcr
