#pragma once

#include <cstdint>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Loops over rows of bits, 64 a word, by the instruction set of this machine. The results are
/// whole numbers, so every instruction set gives the same. A call costs a few nanoseconds more than
/// a loop in place, which pays from about 8 words on.

/// Number of set bits.
Index count_bits(const std::uint64_t* bits, Index num_words);

/// Number of bits set in both rows.
Index count_common_bits(const std::uint64_t* a, const std::uint64_t* b, Index num_words);

/// Sum of values[i] over the bits i set in both rows. No sum may overflow.
/// @param values  one a bit; may end with the last set bit.
std::int64_t sum_over_common_bits(const std::uint64_t* a, const std::uint64_t* b, Index num_words,
                                  const std::int64_t* values, Index num_values);

}  // namespace gmcr::kernels
