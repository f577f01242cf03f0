#include "kernels/bits/bit_columns.hpp"

#include <bit>

namespace gmcr::kernels {
namespace {

constexpr Index kNumMoves = 6;

/// Bit i of the result: whether bits 0 to i of x have odd parity.
std::uint64_t parity_up_to(std::uint64_t x) {
  for (int shift = 1; shift < 64; shift *= 2) x ^= x << shift;
  return x;
}

}  // namespace

void BitColumns::reset(const std::uint64_t* mask, Index num_words) {
  num_words_ = num_words;
  num_columns_ = 0;
  moves_.assign(static_cast<std::size_t>((kNumMoves + 1) * num_words), 0);
  counts_.resize(static_cast<std::size_t>(num_words));
  for (Index w = 0; w < num_words; ++w) {
    std::uint64_t kept = mask[w];
    counts_[static_cast<std::size_t>(w)] = static_cast<std::uint8_t>(std::popcount(kept));
    num_columns_ += std::popcount(kept);
    moves_[static_cast<std::size_t>(w)] = kept;
    // bits that a dropped bit below shifts down, by the parity of how many there are
    std::uint64_t dropped_below = ~kept << 1;
    for (Index i = 0; i < kNumMoves; ++i) {
      const std::uint64_t odd = parity_up_to(dropped_below);
      const std::uint64_t moved = odd & kept;
      moves_[static_cast<std::size_t>((i + 1) * num_words + w)] = moved;
      kept = (kept ^ moved) | (moved >> (std::uint64_t{1} << i));
      dropped_below &= ~odd;
    }
  }
}

}  // namespace gmcr::kernels
