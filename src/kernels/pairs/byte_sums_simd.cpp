// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/pairs/byte_sums_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/pairs/byte_sums.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Bytes = hn::CappedTag<std::uint8_t, kByteSlack + 1>;

void add_rows(const std::uint8_t* const* rows, Index num_rows, Index first, Index length,
              std::uint8_t* sums) {
  const Bytes bytes;
  const auto step = static_cast<Index>(hn::Lanes(bytes));
  for (Index k = 0; k < length; k += step) {
    auto sum = hn::Zero(bytes);
    for (Index r = 0; r < num_rows; ++r) {
      sum = hn::Add(sum, hn::LoadU(bytes, rows[r] + first + k));
    }
    if (k + step <= length) {
      hn::StoreU(sum, bytes, sums + k);
      continue;
    }
    HWY_ALIGN std::uint8_t last[kByteSlack + 1];
    hn::Store(sum, bytes, last);
    for (Index i = 0; k + i < length; ++i) sums[k + i] = last[i];
  }
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(add_rows);

void sum_bytes(const std::uint8_t* const* rows, Index num_rows, Index first, Index length,
               std::uint8_t* sums) {
  HWY_DYNAMIC_DISPATCH(add_rows)(rows, num_rows, first, length, sums);
}

}  // namespace gmcr::kernels
#endif
