// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/pairs/consistency_tiles_simd.cpp"
#include "kernels/pairs/consistency_tiles_simd.hpp"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, 16>;  // a mask of its lanes fits two bytes
using Vector = hn::Vec<Lanes>;

/// Points of one cloud, a vector of them or one of them in all lanes.
struct PointVectors {
  Vector x, y, z, squared_norm;
};

struct Pairs {
  PointVectors source, target;
  Vector bound;
};

/// Columns k, k + 1, ... of a block.
HWY_INLINE PointVectors columns(const float (&points)[4][64], Index k) {
  const Lanes lanes;
  return {hn::Load(lanes, points[0] + k), hn::Load(lanes, points[1] + k),
          hn::Load(lanes, points[2] + k), hn::Load(lanes, points[3] + k)};
}

/// Row r of a block in all lanes.
HWY_INLINE PointVectors row(const float (&points)[4][64], Index r) {
  const Lanes lanes;
  return {hn::Set(lanes, points[0][r]), hn::Set(lanes, points[1][r]), hn::Set(lanes, points[2][r]),
          hn::Set(lanes, points[3][r])};
}

HWY_INLINE Pairs columns(const PairBlock& block, Index k) {
  return {columns(block.source, k), columns(block.target, k), hn::Load(Lanes(), block.bounds + k)};
}

HWY_INLINE Pairs row(const PairBlock& block, Index r) {
  return {row(block.source, r), row(block.target, r), hn::Set(Lanes(), block.bounds[r])};
}

/// |p|^2 + |q|^2 - 2 p.q, of coordinates times the root of 2. Fused or not: what rounding can
/// change is decided again in double precision.
HWY_INLINE Vector squared_distances(const PointVectors& p, const PointVectors& q) {
  const Vector norms = hn::Add(p.squared_norm, q.squared_norm);
  return hn::NegMulAdd(p.z, q.z, hn::NegMulAdd(p.y, q.y, hn::NegMulAdd(p.x, q.x, norms)));
}

/// At most 0 iff sqrt(longer) <= sqrt(shorter) + e, where longer - shorter = difference.
HWY_INLINE Vector excess(Vector difference, Vector ee, Vector four_ee_shorter) {
  const Vector over = hn::Sub(difference, ee);
  return hn::MulSub(over, hn::Abs(over), four_ee_shorter);
}

template <bool kEqualBounds, bool kOneScale>
class Test {
 public:
  HWY_INLINE explicit Test(const SinglePrecisionPairs& pairs)
      : quarter_(hn::Set(Lanes(), 0.25F)), ratio_(hn::Set(Lanes(), pairs.squared_ratio)) {}

  /// Negative where the pair agrees.
  HWY_INLINE Vector value(const Pairs& p, const Pairs& q) const {
    const Vector a = squared_distances(p.source, q.source);
    const Vector b = squared_distances(p.target, q.target);
    Vector ee = quarter_, two_e = quarter_;
    if constexpr (!kEqualBounds) {
      const Vector e = hn::Add(p.bound, q.bound);
      ee = hn::Mul(e, e);
      two_e = hn::Add(e, e);
    }
    if constexpr (kOneScale) {
      return excess(hn::Abs(hn::Sub(a, b)), ee, times_four_ee(hn::Min(a, b), two_e));
    } else {
      const Vector shortest = hn::Mul(ratio_, a);
      return hn::Max(excess(hn::Sub(b, a), ee, times_four_ee(a, two_e)),
                     excess(hn::Sub(shortest, b), ee, times_four_ee(b, two_e)));
    }
  }

 private:
  static HWY_INLINE Vector times_four_ee(Vector squared_length, Vector two_e) {
    if constexpr (kEqualBounds) return squared_length;  // twice the bound of a pair is the unit
    return hn::Mul(hn::Mul(two_e, two_e), squared_length);
  }

  Vector quarter_, ratio_;
};

/// How near 0 the values of a row come, as bits: whole numbers are compared where there is room.
class Nearest {
 public:
  HWY_INLINE Nearest() : bits_(hn::Set(Bits(), 0x7f000000)) {}
  HWY_INLINE void add(Vector value) { bits_ = hn::Min(bits_, hn::BitCast(Bits(), hn::Abs(value))); }
  HWY_INLINE bool is_within(float doubt) const {
    return !hn::AllTrue(Lanes(), hn::Gt(hn::BitCast(Lanes(), bits_), hn::Set(Lanes(), doubt)));
  }

 private:
  using Bits = hn::RebindToSigned<Lanes>;
  hn::Vec<Bits> bits_;
};

/// Entries k, k + 1, ... of a row of bits.
HWY_INLINE void store(Vector value, Index k, std::uint64_t* bits) {
  HWY_ALIGN std::uint8_t mask[8] = {};
  const auto agrees = hn::Lt(value, hn::Zero(Lanes()));
  if (hn::Lanes(Lanes()) >= 8) {  // whole bytes
    hn::StoreMaskBits(Lanes(), agrees, reinterpret_cast<std::uint8_t*>(bits) + k / 8);
  } else {
    hn::StoreMaskBits(Lanes(), agrees, mask);
    *bits = (k == 0 ? 0 : *bits) | std::uint64_t{mask[0]} << k;
  }
}

template <bool kEqualBounds, bool kOneScale>
HWY_INLINE std::uint64_t tile_of(const SinglePrecisionPairs& pairs, Index row_block,
                                 Index column_block, std::uint64_t* tile) {
  const Test<kEqualBounds, kOneScale> test(pairs);
  const PairBlock &rows = pairs.blocks[row_block], &others = pairs.blocks[column_block];
  std::uint64_t doubtful = 0;
  for (Index r = 0; r < 64; r += 2) {  // two rows share the loads of the columns
    const Pairs first = row(rows, r), second = row(rows, r + 1);
    Nearest nearest_first, nearest_second;
    for (Index k = 0; k < 64; k += static_cast<Index>(hn::Lanes(Lanes()))) {
      const Pairs column = columns(others, k);
      const Vector a = test.value(first, column), b = test.value(second, column);
      nearest_first.add(a);
      nearest_second.add(b);
      store(a, k, tile + r);
      store(b, k, tile + r + 1);
    }
    doubtful |= std::uint64_t{nearest_first.is_within(pairs.doubt)} << r;
    doubtful |= std::uint64_t{nearest_second.is_within(pairs.doubt)} << (r + 1);
  }
  return doubtful;
}

}  // namespace

std::uint64_t single_tile(const SinglePrecisionPairs& pairs, Index row_block, Index column_block,
                          std::uint64_t* tile) {
  if (pairs.has_equal_bounds) {
    return pairs.has_one_scale ? tile_of<true, true>(pairs, row_block, column_block, tile)
                               : tile_of<true, false>(pairs, row_block, column_block, tile);
  }
  return pairs.has_one_scale ? tile_of<false, true>(pairs, row_block, column_block, tile)
                             : tile_of<false, false>(pairs, row_block, column_block, tile);
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(single_tile);

std::uint64_t consistency_tile_in_single_precision(const SinglePrecisionPairs& pairs,
                                                   Index row_block, Index column_block,
                                                   std::uint64_t* tile) {
  return HWY_DYNAMIC_DISPATCH(single_tile)(pairs, row_block, column_block, tile);
}

}  // namespace gmcr::kernels
#endif
