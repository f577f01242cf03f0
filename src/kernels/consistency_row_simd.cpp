// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/consistency_row_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/consistency_row.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;  // a mask of its lanes fits a byte
using Vector = hn::Vec<Lanes>;

/// One point against the points of one array a coordinate.
struct PointTo {
  const double *xs, *ys, *zs;
  Vector x, y, z;

  PointTo(const Eigen::MatrixX3d& points, Index i)
      : xs(points.col(0).data()),
        ys(points.col(1).data()),
        zs(points.col(2).data()),
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

void consistency_words(const CorrespondenceArrays& arrays, Index i, double scale_min,
                       double scale_max, Index first_word, Index num_words, std::uint64_t* row) {
  const Lanes lanes;
  const auto step = static_cast<Index>(hn::Lanes(lanes));
  const PointTo source(arrays.source, i), target(arrays.target, i);
  const double* bounds = arrays.bounds.data();
  const Vector bound = hn::Set(lanes, bounds[i]), zero = hn::Zero(lanes), four = hn::Set(lanes, 4);
  const Vector max_squared = hn::Set(lanes, scale_max * scale_max);
  const Vector min_squared = hn::Set(lanes, scale_min * scale_min);
  for (Index word = first_word; word < num_words; ++word) {
    std::uint64_t bits = 0;
    for (Index k = 0; k < 64; k += step) {
      const Index j = word * 64 + k;
      const Vector a = source.squared_distances(j), b = target.squared_distances(j);
      const Vector e = hn::Add(bound, hn::LoadU(lanes, bounds + j));
      const Vector ee = hn::Mul(e, e), four_ee = hn::Mul(four, ee);
      const Vector longest = hn::Mul(max_squared, a), shortest = hn::Mul(min_squared, a);
      const Vector over = hn::Sub(hn::Sub(b, longest), ee);
      const Vector under = hn::Sub(hn::Sub(shortest, b), ee);
      const auto not_too_long =
          hn::Or(hn::Le(over, zero), hn::Le(hn::Mul(over, over), hn::Mul(four_ee, longest)));
      const auto not_too_short =
          hn::Or(hn::Le(under, zero), hn::Le(hn::Mul(under, under), hn::Mul(four_ee, b)));
      HWY_ALIGN std::uint8_t mask[8] = {};
      hn::StoreMaskBits(lanes, hn::And(not_too_long, not_too_short), mask);
      bits |= std::uint64_t{mask[0]} << k;
    }
    row[word] = bits;
  }
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(consistency_words);

void consistency_row(const CorrespondenceArrays& arrays, Index i, double scale_min,
                     double scale_max, std::span<std::uint64_t> row, Index first_word) {
  const Index num_full_words = arrays.size() / 64;
  HWY_DYNAMIC_DISPATCH(consistency_words)
  (arrays, i, scale_min, scale_max, first_word, num_full_words, row.data());
  if (num_full_words < static_cast<Index>(row.size())) {
    std::uint64_t bits = 0;
    for (Index j = num_full_words * 64; j < arrays.size(); ++j) {
      const bool consistent = is_consistent(arrays, i, j, scale_min, scale_max);
      bits |= std::uint64_t{consistent} << (j % 64);
    }
    row[static_cast<std::size_t>(num_full_words)] = bits;
  }
  row[static_cast<std::size_t>(i / 64)] &= ~(std::uint64_t{1} << (i % 64));
}

}  // namespace gmcr::kernels
#endif
