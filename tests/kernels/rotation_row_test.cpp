#include "kernels/pairs/rotation_row.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

/// Narrow, wide, empty and full cones; directions that repeat and that are opposite.
kernels::DirectionArrays random_directions(std::uint64_t seed, Index count) {
  testing::RandomGeometry random(seed);
  kernels::DirectionArrays arrays{Eigen::MatrixX3d(count, 3), Eigen::MatrixX3d(count, 3),
                                  Eigen::ArrayXd(count), Eigen::ArrayXd(count)};
  for (Index k = 0; k < count; ++k) {
    arrays.source.row(k) = random.unit().transpose();
    arrays.target.row(k) = random.unit().transpose();
    if (k % 5 == 1) arrays.source.row(k) = arrays.source.row(k - 1);
    if (k % 5 == 2) arrays.target.row(k) = -arrays.target.row(k - 1);
    const double gamma = k % 4 == 0 ? 0 : k % 7 == 0 ? std::numbers::pi : random.uniform(0, 1.2);
    arrays.cos_gamma[k] = std::cos(gamma);
    arrays.sin_gamma[k] = std::sin(gamma);
  }
  return arrays;
}

std::vector<std::uint64_t> row_of(const kernels::DirectionArrays& arrays, Index k) {
  std::vector<std::uint64_t> row(static_cast<std::size_t>((arrays.size() + 63) / 64));
  kernels::rotation_row(arrays, k, row);
  return row;
}

std::vector<std::uint64_t> reference_of(const kernels::DirectionArrays& arrays, Index k) {
  std::vector<std::uint64_t> row(static_cast<std::size_t>((arrays.size() + 63) / 64));
  kernels::rotation_row_reference(arrays, k, row);
  return row;
}

TEST(RotationRow, HasTheBitsOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (Index count = 1; count <= 200; ++count) {
      const auto arrays = random_directions(static_cast<std::uint64_t>(count), count);
      for (Index k = 0; k < count; k += 1 + count / 8) {
        ASSERT_EQ(row_of(arrays, k), reference_of(arrays, k)) << count << ' ' << k;
      }
    }
  });
}

TEST(RotationRow, HasTheBitsOfTheReferenceWithValuesThatAreNoNumbers) {
  auto arrays = random_directions(1, 150);
  arrays.source(10, 1) = std::numeric_limits<double>::quiet_NaN();
  arrays.target(20, 0) = std::numeric_limits<double>::infinity();
  arrays.cos_gamma[30] = std::numeric_limits<double>::quiet_NaN();
  testing::for_each_isa([&] {
    for (Index k = 0; k < 150; ++k) ASSERT_EQ(row_of(arrays, k), reference_of(arrays, k)) << k;
  });
}

TEST(RotationRow, WritesOnlyFromTheFirstWordOn) {
  const auto arrays = random_directions(2, 200);
  std::vector<std::uint64_t> row(4, 7);
  kernels::rotation_row(arrays, 130, row, 2);
  const auto reference = reference_of(arrays, 130);
  EXPECT_EQ(row, (std::vector<std::uint64_t>{7, 7, reference[2], reference[3]}));
}

TEST(RotationRow, IsSymmetric) {
  const auto arrays = random_directions(3, 150);
  for (Index k = 0; k < 150; ++k) {
    for (Index l = 0; l < k; ++l) {
      EXPECT_EQ(kernels::shares_rotation(arrays, k, l), kernels::shares_rotation(arrays, l, k));
    }
  }
}

}  // namespace
}  // namespace gmcr
