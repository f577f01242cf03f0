#include "kernels/pairs/consistency_row.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "gmcr/isa.hpp"
#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

geometry::CorrespondenceArrays random_arrays(std::uint64_t seed, Index count) {
  testing::RandomGeometry random(seed);
  geometry::CorrespondenceArrays arrays{random.in_cube(count).transpose(),
                                        random.in_cube(count, 0.7).transpose(),
                                        Eigen::ArrayXd(count)};
  for (double& bound : arrays.bounds) bound = random.uniform(0, 0.2);
  // pairs that agree exactly at the bound, and coincident points
  for (Index i = 8; i + 8 < count; i += 8) {
    arrays.source.row(i) = arrays.source.row(i - 8);
    arrays.target.row(i) = arrays.target.row(i - 8);
    arrays.target(i, 0) += arrays.bounds[i] + arrays.bounds[i - 8];
  }
  return arrays;
}

TEST(ConsistencyRow, GivesTheBitsOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (const Index count : {1, 2, 63, 64, 65, 127, 128, 129, 511, 512, 513}) {
      const auto arrays = random_arrays(static_cast<std::uint64_t>(count), count);
      const auto words = static_cast<std::size_t>((count + 63) / 64);
      std::vector<std::uint64_t> row(words), reference(words);
      for (const auto& [low, high] : {std::pair{1.0, 1.0}, std::pair{0.5, 2.0}}) {
        for (Index i = 0; i < count; i += 1 + count / 20) {
          kernels::consistency_row(arrays, i, low, high, row);
          kernels::consistency_row_reference(arrays, i, low, high, reference);
          ASSERT_EQ(row, reference) << count << ' ' << i;
        }
      }
    }
  });
}

TEST(IsConsistent, IsL1ButForRounding) {
  const auto arrays = random_arrays(7, 200);
  int in_doubt = 0;
  for (Index i = 0; i < 200; ++i) {
    for (Index j = 0; j < i; ++j) {
      const double a = (arrays.source.row(j) - arrays.source.row(i)).norm();
      const double b = (arrays.target.row(j) - arrays.target.row(i)).norm();
      const double e = arrays.bounds[i] + arrays.bounds[j];
      for (const auto& [low, high] : {std::pair{1.0, 1.0}, std::pair{0.7, 0.9}}) {
        const double room = std::min(high * a + e - b, b + e - low * a);
        in_doubt += std::abs(room) < 1e-14;
        if (std::abs(room) < 1e-14) continue;
        EXPECT_EQ(kernels::is_consistent(arrays, i, j, low, high), room > 0);
        EXPECT_EQ(kernels::is_consistent(arrays, i, j, low, high),
                  kernels::is_consistent(arrays, j, i, low, high));
      }
    }
  }
  EXPECT_LT(in_doubt, 200);
}

TEST(InstructionSets, AreNamedBestFirst) {
  const std::vector<std::string> names = supported_isas();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(active_isa(), names.front());
}

}  // namespace
}  // namespace gmcr
