// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/pairs/rotation_row_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/pairs/rotation_row.hpp"

#ifndef GMCR_KERNELS_ROTATION_ROW_SIMD_POINTERS  // once for all instruction sets
#define GMCR_KERNELS_ROTATION_ROW_SIMD_POINTERS
namespace gmcr::kernels {

/// `DirectionArrays` as plain data: code of one instruction set instantiates no template that code
/// of another could be linked to.
struct DirectionPointers {
  const double *source[3], *target[3], *cos_gamma, *sin_gamma;
};

}  // namespace gmcr::kernels
#endif

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;  // a mask of its lanes fits a byte
using Vector = hn::Vec<Lanes>;

/// One direction against those of the arrays.
struct Direction {
  const double *xs, *ys, *zs;
  Vector x, y, z;

  HWY_INLINE Direction(const double* const* directions, Index k)
      : xs(directions[0]),
        ys(directions[1]),
        zs(directions[2]),
        x(hn::Set(Lanes(), xs[k])),
        y(hn::Set(Lanes(), ys[k])),
        z(hn::Set(Lanes(), zs[k])) {}

  /// Cosines of the angles to those from l on. No fused multiply-add: the bits of the reference.
  HWY_INLINE Vector cosines(Index l) const {
    const Lanes lanes;
    return hn::Add(
        hn::Add(hn::Mul(x, hn::LoadU(lanes, xs + l)), hn::Mul(y, hn::LoadU(lanes, ys + l))),
        hn::Mul(z, hn::LoadU(lanes, zs + l)));
  }
};

HWY_INLINE Vector sine(Vector cosine) {
  const Vector zero = hn::Zero(Lanes());
  const Vector squared = hn::Sub(hn::Set(Lanes(), 1), hn::Mul(cosine, cosine));
  return hn::Sqrt(hn::IfThenElse(hn::Lt(zero, squared), squared, zero));
}

}  // namespace

void rotation_words(const DirectionPointers& arrays, Index k, Index first_word, Index num_words,
                    std::uint64_t* row) {
  const Lanes lanes;
  const Vector zero = hn::Zero(lanes), slack = hn::Set(lanes, kCosineSlack);
  const Direction source(arrays.source, k), target(arrays.target, k);
  const double *cosines = arrays.cos_gamma, *sines = arrays.sin_gamma;
  const Vector cos_k = hn::Set(lanes, cosines[k]), sin_k = hn::Set(lanes, sines[k]);
  const auto k_is_open = hn::Or(hn::Gt(sin_k, zero), hn::Lt(cos_k, zero));
  for (Index word = first_word; word < num_words; ++word) {
    std::uint64_t bits = 0;
    for (Index lane = 0; lane < 64; lane += static_cast<Index>(hn::Lanes(lanes))) {
      const Index l = 64 * word + lane;
      const Vector cos_l = hn::LoadU(lanes, cosines + l), sin_l = hn::LoadU(lanes, sines + l);
      const Vector sum_sine = hn::Add(hn::Mul(sin_k, cos_l), hn::Mul(cos_k, sin_l));
      const auto is_open = hn::Or(k_is_open, hn::Or(hn::Gt(sin_l, zero), hn::Lt(cos_l, zero)));
      const auto wide = hn::And(hn::Le(sum_sine, zero), is_open);
      const Vector cos_a = source.cosines(l), cos_b = target.cosines(l);
      // Eq. (15), L3
      const Vector cos_difference =
          hn::Add(hn::Mul(cos_a, cos_b), hn::Mul(sine(cos_a), sine(cos_b)));
      const Vector least = hn::Sub(hn::Mul(cos_k, cos_l), hn::Mul(sin_k, sin_l));
      const auto agrees = hn::Or(wide, hn::Ge(hn::Add(cos_difference, slack), least));
      HWY_ALIGN std::uint8_t mask[8] = {};
      hn::StoreMaskBits(lanes, agrees, mask);
      bits |= std::uint64_t{mask[0]} << lane;
    }
    row[word] = bits;
  }
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(rotation_words);

void rotation_row(const DirectionArrays& arrays, Index k, std::span<std::uint64_t> row,
                  Index first_word) {
  const Index num_full_words = arrays.size() / 64;
  const auto &a = arrays.source, &b = arrays.target;
  const DirectionPointers pointers{{a.col(0).data(), a.col(1).data(), a.col(2).data()},
                                   {b.col(0).data(), b.col(1).data(), b.col(2).data()},
                                   arrays.cos_gamma.data(),
                                   arrays.sin_gamma.data()};
  HWY_DYNAMIC_DISPATCH(rotation_words)(pointers, k, first_word, num_full_words, row.data());
  if (num_full_words < static_cast<Index>(row.size())) {
    std::uint64_t bits = 0;
    for (Index l = num_full_words * 64; l < arrays.size(); ++l) {
      bits |= std::uint64_t{shares_rotation(arrays, k, l)} << (l % 64);
    }
    row[static_cast<std::size_t>(num_full_words)] = bits;
  }
  row[static_cast<std::size_t>(k / 64)] &= ~(std::uint64_t{1} << (k % 64));
}

}  // namespace gmcr::kernels
#endif
