#include "kernels/bits/bit_block.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/for_each_isa.hpp"

namespace gmcr {
namespace {

TEST(BitBlock, TransposedHasRowsForColumnsOnEveryInstructionSet) {
  std::mt19937_64 generator(1);
  kernels::BitBlock block{};
  for (std::uint64_t& word : block) word = generator();
  kernels::BitBlock reference = block;
  kernels::transpose_reference(reference);
  for (std::size_t r = 0; r < 64; ++r) {
    for (std::size_t c = 0; c < 64; ++c) {
      ASSERT_EQ((reference[r] >> c) & 1u, (block[c] >> r) & 1u) << r << ' ' << c;
    }
  }
  testing::for_each_isa([&] {
    kernels::BitBlock transposed = block;
    kernels::transpose(transposed);
    EXPECT_EQ(transposed, reference);
  });
}

}  // namespace
}  // namespace gmcr
