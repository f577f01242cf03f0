// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/bits/bit_columns_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/bits/bit_columns.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::CappedTag<std::uint64_t, 8>;

template <int kShift>
HWY_INLINE hn::Vec<Words> move(hn::Vec<Words> bits, const std::uint64_t* moved) {
  const auto t = hn::And(bits, hn::LoadU(Words(), moved));
  return hn::Or(hn::Xor(bits, t), hn::ShiftRight<kShift>(t));
}

void copy_columns(const std::uint64_t* row, const std::uint64_t* moves, const std::uint8_t* counts,
                  Index num_words, std::uint64_t* columns) {
  const Words words;
  const auto step = static_cast<Index>(hn::Lanes(words));
  std::uint64_t pending = 0;  // columns that do not fill a word yet
  int num_pending = 0;
  const auto append = [&](std::uint64_t bits, int count) HWY_ATTR {
    pending |= bits << num_pending;
    num_pending += count;
    if (num_pending < 64) return;
    *columns++ = pending;
    num_pending -= 64;
    pending = num_pending > 0 ? bits >> (count - num_pending) : 0;
  };
  Index w = 0;
  for (; w + step <= num_words; w += step) {
    auto bits = hn::And(hn::LoadU(words, row + w), hn::LoadU(words, moves + w));
    bits = move<1>(bits, moves + num_words + w);
    bits = move<2>(bits, moves + 2 * num_words + w);
    bits = move<4>(bits, moves + 3 * num_words + w);
    bits = move<8>(bits, moves + 4 * num_words + w);
    bits = move<16>(bits, moves + 5 * num_words + w);
    bits = move<32>(bits, moves + 6 * num_words + w);
    HWY_ALIGN std::uint64_t packed[8];
    hn::Store(bits, words, packed);
    for (Index k = 0; k < step; ++k) append(packed[k], counts[w + k]);
  }
  for (; w < num_words; ++w) {
    std::uint64_t bits = row[w] & moves[w];
    for (int i = 0; i < 6; ++i) {
      const std::uint64_t t = bits & moves[(i + 1) * num_words + w];
      bits = (bits ^ t) | (t >> (1 << i));
    }
    append(bits, counts[w]);
  }
  if (num_pending > 0) *columns = pending;
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(copy_columns);

void BitColumns::copy(const std::uint64_t* row, std::uint64_t* columns) const {
  HWY_DYNAMIC_DISPATCH(copy_columns)
  (row, moves_.data(), counts_.data(), num_words_, columns);
}

}  // namespace gmcr::kernels
#endif
