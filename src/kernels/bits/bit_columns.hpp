#pragma once

#include <cstdint>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Copies some columns of rows of bits, those of a mask, to the front of shorter rows.
///
/// What moves each bit of a word to its place, six shifts under masks (Warren, Hacker's Delight,
/// compress), is found once for the mask and done to several words of a row at a time.
class BitColumns {
 public:
  /// @param mask  64 columns a word; bit i says whether column i is one of them.
  /// Cost O(num_words).
  void reset(const std::uint64_t* mask, Index num_words);

  Index num_columns() const { return num_columns_; }

  /// Writes the columns of `row`, in order.
  /// @param columns  (num_columns() + 63) / 64 words; bits past the last column are 0.
  /// Cost O(num_words) of the mask. The same bits on every instruction set.
  void copy(const std::uint64_t* row, std::uint64_t* columns) const;

 private:
  Index num_words_ = 0, num_columns_ = 0;
  std::vector<std::uint64_t> moves_;  ///< mask, then the bits that move by 1, 2, 4, ..., 32
  std::vector<std::uint8_t> counts_;  ///< columns of each word
};

}  // namespace gmcr::kernels
