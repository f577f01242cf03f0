#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gmcr::kernels {

/// 64 x 64 bits: bit c of word r is the entry in row r and column c.
using BitBlock = std::array<std::uint64_t, 64>;

/// Transposes in place, by the instruction set of this machine.
void transpose(BitBlock& block);

/// The same, a word at a time: the specification.
void transpose_reference(BitBlock& block);

}  // namespace gmcr::kernels
