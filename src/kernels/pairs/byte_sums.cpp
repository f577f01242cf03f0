#include "kernels/pairs/byte_sums.hpp"

namespace gmcr::kernels {

void sum_bytes_reference(const std::uint8_t* const* rows, Index num_rows, Index first, Index length,
                         std::uint8_t* sums) {
  for (Index k = 0; k < length; ++k) {
    unsigned sum = 0;
    for (Index r = 0; r < num_rows; ++r) sum += rows[r][first + k];
    sums[k] = static_cast<std::uint8_t>(sum);
  }
}

}  // namespace gmcr::kernels
