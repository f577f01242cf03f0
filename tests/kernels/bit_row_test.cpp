#include "kernels/bits/bit_row.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "kernels/for_each_isa.hpp"

namespace gmcr {
namespace {

using Row = std::vector<std::uint64_t>;

/// Words that are empty, full, sparse and dense.
Row random_row(std::uint64_t seed, Index num_words) {
  std::mt19937_64 generator(seed);
  Row row(static_cast<std::size_t>(num_words));
  for (std::uint64_t& word : row) {
    word = generator();
    const auto kind = generator() % 5;
    if (kind == 0) word = 0;
    if (kind == 1) word = ~std::uint64_t{0};
    if (kind == 2) word &= generator() & generator() & generator();
  }
  return row;
}

bool bit(const Row& row, Index i) {
  return (row[static_cast<std::size_t>(i / 64)] >> (i % 64)) & 1u;
}

TEST(BitRow, CountsAreThoseOfSingleBitsOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (Index words = 0; words <= 200; ++words) {
      const Row a = random_row(static_cast<std::uint64_t>(words), words);
      const Row b = random_row(static_cast<std::uint64_t>(words) + 1000, words);
      Index count = 0, common = 0;
      for (Index i = 0; i < 64 * words; ++i) {
        count += bit(a, i);
        common += bit(a, i) && bit(b, i);
      }
      ASSERT_EQ(kernels::count_bits(a.data(), words), count) << words;
      ASSERT_EQ(kernels::count_common_bits(a.data(), b.data(), words), common) << words;
    }
  });
}

TEST(BitRow, SumsAreThoseOfSingleBitsOnEveryInstructionSet) {
  testing::for_each_isa([] {
    std::mt19937_64 generator(3);
    for (Index words = 0; words <= 70; ++words) {
      Row a = random_row(static_cast<std::uint64_t>(words) + 7, words);
      const Row b = random_row(static_cast<std::uint64_t>(words) + 2000, words);
      // as many values as the last word has bits in use
      const Index num_values = words == 0 ? 0 : 64 * words - static_cast<Index>(generator() % 64);
      if (words > 0) a.back() &= ~std::uint64_t{0} >> (64 * words - num_values);
      std::vector<std::int64_t> values(static_cast<std::size_t>(num_values));
      for (std::int64_t& value : values) value = static_cast<std::int64_t>(generator()) >> 16;
      std::int64_t sum = 0;
      for (Index i = 0; i < num_values; ++i) {
        if (bit(a, i) && bit(b, i)) sum += values[static_cast<std::size_t>(i)];
      }
      ASSERT_EQ(kernels::sum_over_common_bits(a.data(), b.data(), words, values.data(), num_values),
                sum)
          << words;
    }
  });
}

}  // namespace
}  // namespace gmcr
