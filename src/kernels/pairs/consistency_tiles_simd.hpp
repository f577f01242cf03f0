#pragma once

#include "kernels/pairs/consistency_tiles.hpp"

namespace gmcr::kernels {

/// The tile of `ConsistencyTiles::tile`, entries of pairs of a point with itself left undefined.
/// @param tile  64 words, one a row.
/// @return bit r is set iff some entry of row r is in doubt.
std::uint64_t consistency_tile_in_single_precision(const SinglePrecisionPairs& pairs,
                                                   Index row_block, Index column_block,
                                                   std::uint64_t* tile);

}  // namespace gmcr::kernels
