// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/points/residuals_simd.cpp"
#include "kernels/points/residuals_simd.hpp"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;  // a mask of its lanes fits a byte
using Vector = hn::Vec<Lanes>;

/// One coordinate of the residual.
struct Axis {
  const double* target;
  Vector mx, my, mz, t;

  HWY_INLINE Axis(const PosePoints& points, int axis)
      : target(points.target[axis]),
        mx(hn::Set(Lanes(), points.matrix[3 * axis])),
        my(hn::Set(Lanes(), points.matrix[3 * axis + 1])),
        mz(hn::Set(Lanes(), points.matrix[3 * axis + 2])),
        t(hn::Set(Lanes(), points.translation[axis])) {}

  /// No fused multiply-add: the bits of the reference.
  HWY_INLINE Vector squared(Index i, Vector x, Vector y, Vector z) const {
    const Vector turned = hn::Add(hn::Add(hn::Mul(mx, x), hn::Mul(my, y)), hn::Mul(mz, z));
    const Vector d = hn::Sub(hn::LoadU(Lanes(), target + i), hn::Add(turned, t));
    return hn::Mul(d, d);
  }
};

struct Residuals {
  const double *xs, *ys, *zs;
  Axis u, v, w;

  HWY_INLINE explicit Residuals(const PosePoints& points)
      : xs(points.source[0]),
        ys(points.source[1]),
        zs(points.source[2]),
        u(points, 0),
        v(points, 1),
        w(points, 2) {}

  HWY_INLINE Vector squared(Index i) const {
    const Vector x = hn::LoadU(Lanes(), xs + i), y = hn::LoadU(Lanes(), ys + i);
    const Vector z = hn::LoadU(Lanes(), zs + i);
    return hn::Add(hn::Add(u.squared(i, x, y, z), v.squared(i, x, y, z)), w.squared(i, x, y, z));
  }
};

}  // namespace

void residual_blocks(const PosePoints& points, Index num_blocks, double* squared) {
  const Lanes lanes;
  const Residuals residuals(points);
  for (Index i = 0; i < 64 * num_blocks; i += static_cast<Index>(hn::Lanes(lanes))) {
    hn::StoreU(residuals.squared(i), lanes, squared + i);
  }
}

std::uint64_t agreeing_block(const PosePoints& points, Index begin, const double* squared_bounds,
                             double factor, double* squared) {
  const Lanes lanes;
  const Residuals residuals(points);
  const Vector factors = hn::Set(lanes, factor);
  std::uint64_t bits = 0;
  for (Index k = 0; k < 64; k += static_cast<Index>(hn::Lanes(lanes))) {
    const Vector values = residuals.squared(begin + k);
    const Vector most = hn::Mul(factors, hn::LoadU(lanes, squared_bounds + begin + k));
    HWY_ALIGN std::uint8_t mask[8] = {};
    hn::StoreMaskBits(lanes, hn::Le(values, most), mask);
    if (mask[0] != 0) hn::StoreU(values, lanes, squared + k);
    bits |= std::uint64_t{mask[0]} << k;
  }
  return bits;
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(residual_blocks);
HWY_EXPORT(agreeing_block);

void squared_residuals_of_blocks(const PosePoints& points, Index num_blocks, double* squared) {
  HWY_DYNAMIC_DISPATCH(residual_blocks)(points, num_blocks, squared);
}

std::uint64_t agreeing_of_block(const PosePoints& points, Index begin, const double* squared_bounds,
                                double factor, double* squared) {
  return HWY_DYNAMIC_DISPATCH(agreeing_block)(points, begin, squared_bounds, factor, squared);
}

}  // namespace gmcr::kernels
#endif
