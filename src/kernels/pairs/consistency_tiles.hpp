#pragma once

#include <vector>

#include "kernels/bits/bit_block.hpp"
#include "kernels/pairs/consistency_row.hpp"

namespace gmcr::kernels {

/// 64 correspondences in single precision. Points are x, y, z, times the root of 2 and relative to
/// the middle of their cloud, and half the squared norm of that.
struct alignas(64) PairBlock {
  float source[4][64], target[4][64], bounds[64];
};

/// What the single precision pass reads; the unit is four times the largest bound. Plain data: code
/// of every instruction set reads it.
struct SinglePrecisionPairs {
  const PairBlock* blocks;  ///< none where single precision will not do
  float squared_ratio;      ///< (scale_min / scale_max)^2
  float doubt;              ///< a test whose value is this near 0 is done again in double precision
  bool has_equal_bounds;
  bool has_one_scale;
};

/// The consistency graph of correspondences, 64 x 64 entries at a time.
///
/// The same bits as `consistency_row_reference` on every instruction set. Where the bounds are not
/// too small for it (`is_single_precision`), pairs are tested in single precision on coordinates
/// from the middle of each cloud, and again in double precision where a bound on the error of that
/// leaves doubt.
class ConsistencyTiles {
 public:
  /// Keeps a reference to `arrays`. Cost O(N).
  ConsistencyTiles(const geometry::CorrespondenceArrays& arrays, double scale_min,
                   double scale_max);
  ConsistencyTiles(const ConsistencyTiles&) = delete;
  ConsistencyTiles& operator=(const ConsistencyTiles&) = delete;

  /// Blocks of 64 correspondences, the last one perhaps with fewer.
  Index num_blocks() const { return (arrays_.size() + 63) / 64; }

  /// Bit c of word r says whether correspondences 64 row_block + r and 64 column_block + c are two
  /// that agree; 0 past the last correspondence.
  BitBlock tile(Index row_block, Index column_block) const;

  bool is_single_precision() const { return pairs_.blocks != nullptr; }

 private:
  void prepare_single_precision();

  const geometry::CorrespondenceArrays& arrays_;
  double scale_min_, scale_max_;
  std::vector<PairBlock> blocks_;
  SinglePrecisionPairs pairs_;  ///< points into `blocks_`
};

}  // namespace gmcr::kernels
