#include "kernels/bit_block.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gmcr {
namespace {

TEST(BitBlock, TransposedHasRowsForColumns) {
  std::mt19937_64 generator(1);
  kernels::BitBlock block{};
  for (std::uint64_t& word : block) word = generator();
  kernels::BitBlock transposed = block;
  kernels::transpose(transposed);
  for (std::size_t r = 0; r < 64; ++r) {
    for (std::size_t c = 0; c < 64; ++c) {
      ASSERT_EQ((transposed[r] >> c) & 1u, (block[c] >> r) & 1u) << r << ' ' << c;
    }
  }
}

}  // namespace
}  // namespace gmcr
