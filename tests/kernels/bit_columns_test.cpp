#include "kernels/bits/bit_columns.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "kernels/for_each_isa.hpp"

namespace gmcr::kernels {
namespace {

using Words = std::vector<std::uint64_t>;

/// Words whose bits are set with a probability of 2^-sparsity.
Words random_words(std::size_t count, int sparsity, std::mt19937_64& generator) {
  Words words(count, ~std::uint64_t{0});
  for (std::uint64_t& word : words) {
    for (int i = 0; i < sparsity; ++i) word &= generator();
  }
  return words;
}

bool bit(const Words& words, std::size_t i) { return (words[i / 64] >> (i % 64)) & 1u; }

/// Bit by bit: the specification.
Words columns_of(const Words& row, const Words& mask) {
  Words columns;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 64 * mask.size(); ++i) {
    if (!bit(mask, i)) continue;
    if (count % 64 == 0) columns.push_back(0);
    columns.back() |= std::uint64_t{bit(row, i)} << (count++ % 64);
  }
  return columns;
}

TEST(BitColumns, AreThoseOfTheMaskInOrderOnEveryInstructionSet) {
  std::mt19937_64 generator(5);
  for (const std::size_t num_words : {0u, 1u, 2u, 3u, 7u, 8u, 9u, 16u, 33u}) {
    for (int sparsity = 0; sparsity < 7; ++sparsity) {
      const Words mask = random_words(num_words, sparsity, generator);
      const Words row = random_words(num_words, sparsity % 3, generator);
      const Words expected = columns_of(row, mask);
      testing::for_each_isa([&] {
        BitColumns columns;
        columns.reset(mask.data(), static_cast<Index>(num_words));
        Words found(expected.size(), ~std::uint64_t{0});
        columns.copy(row.data(), found.data());
        EXPECT_EQ(found, expected) << num_words << " words, sparsity " << sparsity;
        EXPECT_EQ((columns.num_columns() + 63) / 64, static_cast<Index>(expected.size()));
      });
    }
  }
}

TEST(BitColumns, OfNoColumnWriteNothing) {
  const Words nothing(4, 0), row(4, ~std::uint64_t{0});
  BitColumns columns;
  columns.reset(nothing.data(), 4);
  EXPECT_EQ(columns.num_columns(), 0);
  std::uint64_t untouched = 7;
  columns.copy(row.data(), &untouched);
  EXPECT_EQ(untouched, 7u);
}

TEST(BitColumns, ASecondMaskReplacesTheFirst) {
  const Words first{0xff}, second{0xf0}, row{0xa5};
  BitColumns columns;
  columns.reset(first.data(), 1);
  columns.reset(second.data(), 1);
  std::uint64_t found = 0;
  columns.copy(row.data(), &found);
  EXPECT_EQ(found, 0xau);
}

}  // namespace
}  // namespace gmcr::kernels
