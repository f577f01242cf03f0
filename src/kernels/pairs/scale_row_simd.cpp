// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/pairs/scale_row_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/pairs/scale_row.hpp"
#include "kernels/pairs/scale_row_bounds.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::ScalableTag<double>;
using Vector = hn::Vec<Lanes>;
using Words = hn::RebindToUnsigned<Lanes>;
using WordVector = hn::Vec<Words>;

/// One coordinate of all points and, in each lane, of one of them.
struct Axis {
  const double* all;
  Vector one;

  Axis(const double* values, Index i) : all(values), one(hn::Set(Lanes(), values[i])) {}
  HWY_INLINE Vector squared_difference(Index j) const {
    const Vector difference = hn::Sub(hn::LoadU(Lanes(), all + j), one);
    return hn::Mul(difference, difference);
  }
};

HWY_INLINE Vector distances(const Axis& x, const Axis& y, const Axis& z, Index j) {
  const Vector xy = hn::Add(x.squared_difference(j), y.squared_difference(j));
  return hn::Sqrt(hn::Add(xy, z.squared_difference(j)));
}

HWY_INLINE WordVector edges_below(const ScaleCells& cells, Vector scale) {
  const Words words;
  const hn::RebindToSigned<Words> indices;
  const WordVector bits = hn::BitCast(words, scale);
  const WordVector cell =
      hn::Sub(hn::ShiftRight<ScaleCells::kShift>(bits), hn::Set(words, cells.first));
  const WordVector entry = hn::GatherIndex(words, cells.entries, hn::BitCast(indices, cell));
  return hn::ShiftRight<ScaleCells::kShift>(
      hn::Add(entry, hn::And(bits, hn::Set(words, ScaleCells::kRest))));
}

/// @param n  number of correspondences, at least the lanes of a vector.
/// @param spans  n packed values.
void scale_spans(const double* const* source, const double* const* target, const double* bounds,
                 Index n, const ScaleCells& cells, Index i, Index begin, std::uint32_t* spans) {
  const Lanes lanes;
  const Words words;
  const hn::Rebind<std::uint32_t, Words> halves;
  const auto step = static_cast<Index>(hn::Lanes(lanes));
  const Axis ax(source[0], i), ay(source[1], i), az(source[2], i);
  const Axis bx(target[0], i), by(target[1], i), bz(target[2], i);
  const Vector bound = hn::Set(lanes, bounds[i]), one = hn::Set(lanes, 1);
  const Vector min = hn::Set(lanes, cells.min), max = hn::Set(lanes, cells.max);
  const Vector rounding = hn::Set(lanes, kScaleRounding), coincident = hn::Set(lanes, kCoincident);
  for (Index next = begin; next < n; next += step) {
    const Index j = next + step <= n ? next : n - step;  // the last vector may redo some
    const Vector a = distances(ax, ay, az, j), b = distances(bx, by, bz, j);
    const Vector e = hn::Add(bound, hn::LoadU(lanes, bounds + j));
    const Vector inverse = hn::Div(one, a);
    const Vector middle = hn::Mul(b, inverse), half = hn::Mul(e, inverse);
    const Vector reach = hn::Add(middle, half), slack = hn::Mul(rounding, reach);
    const Vector lower = hn::Sub(hn::Sub(middle, half), slack), upper = hn::Add(reach, slack);

    const auto coincide = hn::Lt(a, coincident);
    const auto always = hn::And(coincide, hn::Le(b, hn::Add(e, hn::Mul(max, a))));
    const auto sometimes = hn::AndNot(coincide, hn::And(hn::Le(lower, max), hn::Ge(upper, min)));
    // what is no number, or out of the range, is replaced before the table is read
    const auto from_inside = hn::And(sometimes, hn::Gt(lower, min));
    const auto to_inside = hn::And(sometimes, hn::Lt(upper, max));
    const WordVector first = edges_below(cells, hn::IfThenElse(from_inside, lower, min));
    const WordVector last = edges_below(cells, hn::IfThenElse(to_inside, upper, max));
    const WordVector end = hn::Add(last, hn::Set(words, 1));
    const auto meets = hn::RebindMask(words, hn::Or(always, sometimes));
    const WordVector span = hn::IfThenElseZero(meets, hn::Or(first, hn::ShiftLeft<16>(end)));
    hn::StoreU(hn::TruncateTo(halves, span), halves, spans + j);
  }
}

Index num_lanes() { return static_cast<Index>(hn::Lanes(Lanes())); }

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(scale_spans);
HWY_EXPORT(num_lanes);

void scale_row(const geometry::CorrespondenceArrays& arrays, const ScaleCells& cells, Index i,
               Index begin, std::span<BinSpan> spans) {
  const Index n = arrays.size();
  if (begin >= n) return;
  if (n < HWY_DYNAMIC_DISPATCH(num_lanes)()) {
    for (Index j = begin; j < n; ++j) {
      spans[static_cast<std::size_t>(j)] = agreeing_bins(arrays, cells, i, j);
    }
    return;
  }
  const double* source[] = {arrays.source.col(0).data(), arrays.source.col(1).data(),
                            arrays.source.col(2).data()};
  const double* target[] = {arrays.target.col(0).data(), arrays.target.col(1).data(),
                            arrays.target.col(2).data()};
  HWY_DYNAMIC_DISPATCH(scale_spans)
  (source, target, arrays.bounds.data(), n, cells, i, begin, &spans.front().packed);
}

}  // namespace gmcr::kernels
#endif
