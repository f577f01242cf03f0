#include "kernels/bits/bit_block.hpp"

namespace gmcr::kernels {

void transpose_reference(BitBlock& block) {
  // swaps the off-diagonal quarters, then those of each quarter, and so on
  std::uint64_t low_half = 0x00000000ffffffff;
  for (std::size_t size = 32; size != 0; size /= 2, low_half ^= low_half << size) {
    for (std::size_t base = 0; base < 64; base += 2 * size) {
      for (std::size_t r = base; r < base + size; ++r) {
        const std::uint64_t differ = ((block[r] >> size) ^ block[r + size]) & low_half;
        block[r] ^= differ << size;
        block[r + size] ^= differ;
      }
    }
  }
}

}  // namespace gmcr::kernels
