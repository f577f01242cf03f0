#pragma once

#include <cstdint>

#include "gmcr/types.hpp"

namespace gmcr::kernels {

/// Bytes that a sum may read past the last one of a row that it is asked for.
inline constexpr Index kByteSlack = 31;

/// Sums of rows of bytes: sums[k] = rows[0][first + k] + rows[1][first + k] + ..., modulo 256.
/// @param rows  `num_rows` of them; each has `kByteSlack` bytes past the last one that is summed.
/// @param sums  `length` values.
/// The same values on every instruction set. Cost O(num_rows * length).
void sum_bytes(const std::uint8_t* const* rows, Index num_rows, Index first, Index length,
               std::uint8_t* sums);

/// The same, one byte after the other: the specification.
void sum_bytes_reference(const std::uint8_t* const* rows, Index num_rows, Index first, Index length,
                         std::uint8_t* sums);

}  // namespace gmcr::kernels
