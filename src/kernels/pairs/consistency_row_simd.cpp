// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/pairs/consistency_row_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/pairs/consistency_row.hpp"

#ifndef GMCR_KERNELS_CONSISTENCY_ROW_SIMD_POINTERS  // once for all instruction sets
#define GMCR_KERNELS_CONSISTENCY_ROW_SIMD_POINTERS
namespace gmcr::kernels {

/// `geometry::CorrespondenceArrays` as plain data: code of one instruction set instantiates no
/// template that code of another could be linked to.
struct CorrespondencePointers {
  const double *source[3], *target[3], *bounds;
  Index size;
};

}  // namespace gmcr::kernels
#endif

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;  // a mask of its lanes fits a byte
using Vector = hn::Vec<Lanes>;

/// One point against the points of one array a coordinate.
struct PointTo {
  const double *xs, *ys, *zs;
  Vector x, y, z;

  HWY_INLINE PointTo(const double* const* points, Index i)
      : xs(points[0]),
        ys(points[1]),
        zs(points[2]),
        x(hn::Set(Lanes(), xs[i])),
        y(hn::Set(Lanes(), ys[i])),
        z(hn::Set(Lanes(), zs[i])) {}

  /// Squared distances to the points from j on. No fused multiply-add: the bits of the reference.
  HWY_INLINE Vector squared_distances(Index j) const {
    const Vector dx = hn::Sub(hn::LoadU(Lanes(), xs + j), x);
    const Vector dy = hn::Sub(hn::LoadU(Lanes(), ys + j), y);
    const Vector dz = hn::Sub(hn::LoadU(Lanes(), zs + j), z);
    return hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
  }
};

/// Lanes where sqrt(longer) <= sqrt(shorter) + e, with longer - shorter = difference.
HWY_INLINE hn::Mask<Lanes> is_within(Vector difference, Vector shorter, Vector ee) {
  const Vector over = hn::Sub(difference, ee);
  const Vector room = hn::Mul(hn::Mul(hn::Set(Lanes(), 4), ee), shorter);
  return hn::Or(hn::Le(over, hn::Zero(Lanes())), hn::Le(hn::Mul(over, over), room));
}

/// Lanes where points at squared distances a and b agree.
template <bool kOneScale>
HWY_INLINE hn::Mask<Lanes> agree(Vector a, Vector b, Vector ee, Vector min_squared,
                                 Vector max_squared) {
  const Vector longest = hn::Mul(max_squared, a);
  if constexpr (kOneScale) {
    // of the two tests below, the one whose difference is not negative
    const Vector shorter = hn::IfThenElse(hn::Lt(b, longest), b, longest);
    return is_within(hn::Abs(hn::Sub(b, longest)), shorter, ee);
  } else {
    const Vector shortest = hn::Mul(min_squared, a);
    return hn::And(is_within(hn::Sub(b, longest), longest, ee),
                   is_within(hn::Sub(shortest, b), b, ee));
  }
}

template <bool kOneScale>
HWY_INLINE void words(const CorrespondencePointers& arrays, Index i, double scale_min,
                      double scale_max, Index first_word, Index num_words, std::uint64_t* row) {
  const Lanes lanes;
  const auto step = static_cast<Index>(hn::Lanes(lanes));
  const PointTo source(arrays.source, i), target(arrays.target, i);
  const double* bounds = arrays.bounds;
  const Vector bound = hn::Set(lanes, bounds[i]);
  const Vector max_squared = hn::Set(lanes, scale_max * scale_max);
  const Vector min_squared = hn::Set(lanes, scale_min * scale_min);
  for (Index word = first_word; word < num_words; ++word) {
    std::uint64_t bits = 0;
    for (Index k = 0; k < 64; k += step) {
      const Index j = word * 64 + k;
      const Vector a = source.squared_distances(j), b = target.squared_distances(j);
      const Vector e = hn::Add(bound, hn::LoadU(lanes, bounds + j));
      const auto agrees = agree<kOneScale>(a, b, hn::Mul(e, e), min_squared, max_squared);
      HWY_ALIGN std::uint8_t mask[8] = {};
      hn::StoreMaskBits(lanes, agrees, mask);
      bits |= std::uint64_t{mask[0]} << k;
    }
    row[word - first_word] = bits;
  }
}

void consistency_words(const CorrespondencePointers& arrays, Index i, double scale_min,
                       double scale_max, Index first_word, Index num_words, std::uint64_t* row) {
  if (scale_min == scale_max) {
    words<true>(arrays, i, scale_min, scale_max, first_word, num_words, row);
  } else {
    words<false>(arrays, i, scale_min, scale_max, first_word, num_words, row);
  }
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(consistency_words);

namespace {

CorrespondencePointers pointers_of(const geometry::CorrespondenceArrays& arrays) {
  const auto &a = arrays.source, &b = arrays.target;
  return {{a.col(0).data(), a.col(1).data(), a.col(2).data()},
          {b.col(0).data(), b.col(1).data(), b.col(2).data()},
          arrays.bounds.data(),
          arrays.size()};
}

std::uint64_t last_word(const geometry::CorrespondenceArrays& arrays, Index i, double scale_min,
                        double scale_max) {
  std::uint64_t bits = 0;
  for (Index j = arrays.size() / 64 * 64; j < arrays.size(); ++j) {
    const bool consistent = is_consistent(arrays, i, j, scale_min, scale_max);
    bits |= std::uint64_t{consistent} << (j % 64);
  }
  return bits;
}

}  // namespace

std::uint64_t consistency_word(const geometry::CorrespondenceArrays& arrays, Index i,
                               double scale_min, double scale_max, Index word) {
  if (word == arrays.size() / 64) return last_word(arrays, i, scale_min, scale_max);
  std::uint64_t bits = 0;
  HWY_DYNAMIC_DISPATCH(consistency_words)
  (pointers_of(arrays), i, scale_min, scale_max, word, word + 1, &bits);
  return bits;
}

void consistency_row(const geometry::CorrespondenceArrays& arrays, Index i, double scale_min,
                     double scale_max, std::span<std::uint64_t> row, Index first_word) {
  const Index num_full_words = arrays.size() / 64;
  HWY_DYNAMIC_DISPATCH(consistency_words)
  (pointers_of(arrays), i, scale_min, scale_max, first_word, num_full_words,
   row.data() + first_word);
  if (num_full_words < static_cast<Index>(row.size())) {
    row[static_cast<std::size_t>(num_full_words)] = last_word(arrays, i, scale_min, scale_max);
  }
  row[static_cast<std::size_t>(i / 64)] &= ~(std::uint64_t{1} << (i % 64));
}

}  // namespace gmcr::kernels
#endif
