// Compiled once for each instruction set; the machine picks one at run time.
#define HWY_WANT_AVX3_DL 1  // hardware popcounts of whole vectors
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/bits/bit_row_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/bits/bit_row.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Words = hn::ScalableTag<std::uint64_t>;
using Values = hn::CappedTag<std::int64_t, 8>;  // a mask of its lanes fits a byte

struct Row {
  const std::uint64_t* a;
  HWY_INLINE hn::Vec<Words> vector(Index i) const { return hn::LoadU(Words(), a + i); }
  HWY_INLINE std::uint64_t word(Index i) const { return a[i]; }
};

struct CommonRow {
  const std::uint64_t *a, *b;
  HWY_INLINE hn::Vec<Words> vector(Index i) const {
    return hn::And(hn::LoadU(Words(), a + i), hn::LoadU(Words(), b + i));
  }
  HWY_INLINE std::uint64_t word(Index i) const { return a[i] & b[i]; }
};

template <typename AnyRow>
HWY_INLINE Index count(const AnyRow& row, Index num_words) {
  const Words words;
  const auto step = static_cast<Index>(hn::Lanes(words));
  auto counts = hn::Zero(words);
  Index i = 0;
  for (; i + step <= num_words; i += step) {
    counts = hn::Add(counts, hn::PopulationCount(row.vector(i)));
  }
  auto total = static_cast<Index>(hn::GetLane(hn::SumOfLanes(words, counts)));
  for (; i < num_words; ++i) total += __builtin_popcountll(row.word(i));
  return total;
}

Index count_bits(const std::uint64_t* bits, Index num_words) { return count(Row{bits}, num_words); }

Index count_common_bits(const std::uint64_t* a, const std::uint64_t* b, Index num_words) {
  return count(CommonRow{a, b}, num_words);
}

std::int64_t sum_over_common_bits(const std::uint64_t* a, const std::uint64_t* b, Index num_words,
                                  const std::int64_t* values, Index num_values) {
  const Values lanes;
  const auto step = static_cast<Index>(hn::Lanes(lanes));
  const auto dense = static_cast<int>(24 / step);  // bits of a word from which vectors are faster
  auto sums = hn::Zero(lanes);
  std::int64_t rest = 0;
  for (Index i = 0; i < num_words; ++i) {
    std::uint64_t word = a[i] & b[i];
    const std::int64_t* first = values + 64 * i;
    if (__builtin_popcountll(word) < dense || 64 * (i + 1) > num_values) {
      for (; word != 0; word &= word - 1) rest += first[__builtin_ctzll(word)];
      continue;
    }
    for (Index k = 0; k < 64; k += step) {
      HWY_ALIGN std::uint8_t bits[8] = {static_cast<std::uint8_t>(word >> k)};
      const auto mask = hn::LoadMaskBits(lanes, bits);
      sums = hn::Add(sums, hn::IfThenElseZero(mask, hn::LoadU(lanes, first + k)));
    }
  }
  return rest + hn::GetLane(hn::SumOfLanes(lanes, sums));
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(count_bits);
HWY_EXPORT(count_common_bits);
HWY_EXPORT(sum_over_common_bits);

Index count_bits(const std::uint64_t* bits, Index num_words) {
  return HWY_DYNAMIC_DISPATCH(count_bits)(bits, num_words);
}

Index count_common_bits(const std::uint64_t* a, const std::uint64_t* b, Index num_words) {
  return HWY_DYNAMIC_DISPATCH(count_common_bits)(a, b, num_words);
}

std::int64_t sum_over_common_bits(const std::uint64_t* a, const std::uint64_t* b, Index num_words,
                                  const std::int64_t* values, Index num_values) {
  return HWY_DYNAMIC_DISPATCH(sum_over_common_bits)(a, b, num_words, values, num_values);
}

}  // namespace gmcr::kernels
#endif
