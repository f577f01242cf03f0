// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/bits/bit_block_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/bits/bit_block.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::CappedTag<std::uint64_t, 8>;
using Vector = hn::Vec<Words>;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(Words()));
constexpr int kVectors = 64 / kLanes;

#if HWY_TARGET != HWY_SCALAR  // which has but one lane
/// Lane r of the result is lane r ^ kSize.
template <int kSize>
HWY_INLINE Vector swap_lanes(Vector v) {
  if constexpr (2 * kSize == kLanes) {
    return hn::ConcatLowerUpper(Words(), v, v);
  } else if constexpr (kSize == 2) {
    return hn::SwapAdjacentBlocks(v);
  } else {
    return hn::Reverse2(Words(), v);
  }
}
#endif

/// Swaps the off-diagonal squares of kSize x kSize bits of each square of twice that side.
template <int kSize>
HWY_INLINE void swap_squares(Vector* rows) {
  // the bits whose column has the bit kSize clear
  constexpr std::uint64_t kLow = ~std::uint64_t{0} / ((std::uint64_t{1} << kSize) + 1);
  const Words words;
  const Vector low = hn::Set(words, kLow);
  if constexpr (kSize >= kLanes) {
    constexpr int kStep = kSize / kLanes;
    for (int v = 0; v < kVectors; ++v) {
      if ((v & kStep) != 0) continue;
      const Vector upper = rows[v], lower = rows[v + kStep];
      const Vector differ = hn::And(hn::Xor(hn::ShiftRight<kSize>(upper), lower), low);
      rows[v] = hn::Xor(upper, hn::ShiftLeft<kSize>(differ));
      rows[v + kStep] = hn::Xor(lower, differ);
    }
  }
#if HWY_TARGET != HWY_SCALAR
  if constexpr (kSize < kLanes) {
    const auto lane = hn::Iota(words, 0);
    const auto is_upper = hn::Eq(hn::And(lane, hn::Set(words, kSize)), hn::Zero(words));
    const Vector kept = hn::IfThenElse(is_upper, low, hn::Not(low));
    for (int v = 0; v < kVectors; ++v) {
      const Vector other = swap_lanes<kSize>(rows[v]);
      const Vector moved =
          hn::IfThenElse(is_upper, hn::ShiftLeft<kSize>(other), hn::ShiftRight<kSize>(other));
      rows[v] = hn::Or(hn::And(rows[v], kept), hn::AndNot(kept, moved));
    }
  }
#endif
}

}  // namespace

void transpose_words(std::uint64_t* block) {
  const Words words;
  Vector rows[kVectors];
  for (int v = 0; v < kVectors; ++v) rows[v] = hn::LoadU(words, block + v * kLanes);
  swap_squares<32>(rows);
  swap_squares<16>(rows);
  swap_squares<8>(rows);
  swap_squares<4>(rows);
  swap_squares<2>(rows);
  swap_squares<1>(rows);
  for (int v = 0; v < kVectors; ++v) hn::StoreU(rows[v], words, block + v * kLanes);
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(transpose_words);

void transpose(BitBlock& block) { HWY_DYNAMIC_DISPATCH(transpose_words)(block.data()); }

}  // namespace gmcr::kernels
#endif
