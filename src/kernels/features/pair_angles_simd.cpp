// Compiled once for each instruction set; the machine picks one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/features/pair_angles_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/features/pair_angles.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr Index kMostLanes = 8;
constexpr Index kRows = 4;  // lanes take turns, since a count waits for the one before it

using Lanes = hn::CappedTag<double, kMostLanes>;
using Indices = hn::RebindToSigned<Lanes>;
using Bins = hn::Rebind<std::int32_t, Lanes>;
using Vector = hn::Vec<Lanes>;
using Mask = hn::Mask<Lanes>;

struct Direction {
  Vector x, y, z;

  HWY_INLINE Vector dot(const Direction& other) const {
    return hn::Add(hn::Add(hn::Mul(x, other.x), hn::Mul(y, other.y)), hn::Mul(z, other.z));
  }
  HWY_INLINE Direction cross(const Direction& other) const {
    return {hn::Sub(hn::Mul(y, other.z), hn::Mul(z, other.y)),
            hn::Sub(hn::Mul(z, other.x), hn::Mul(x, other.z)),
            hn::Sub(hn::Mul(x, other.y), hn::Mul(y, other.x))};
  }
};

HWY_INLINE Direction choose(Mask mask, const Direction& yes, const Direction& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}

HWY_INLINE Direction of_one(const double* x, const double* y, const double* z, Index i) {
  return {hn::Set(Lanes(), x[i]), hn::Set(Lanes(), y[i]), hn::Set(Lanes(), z[i])};
}

HWY_INLINE Direction gathered(const double* x, const double* y, const double* z,
                              hn::Vec<Indices> indices) {
  const Lanes lanes;
  return {hn::GatherIndex(lanes, x, indices), hn::GatherIndex(lanes, y, indices),
          hn::GatherIndex(lanes, z, indices)};
}

HWY_INLINE Vector bin_of(Vector value) {
  const Lanes lanes;
  const Vector bin = hn::Mul(hn::Add(value, hn::Set(lanes, 1.0)),
                             hn::Set(lanes, static_cast<double>(kAngleBins) / 2));
  return hn::Min(hn::Max(bin, hn::Zero(lanes)),
                 hn::Set(lanes, static_cast<double>(kAngleBins - 1)));
}

HWY_INLINE Vector theta_bin(Vector x, Vector y) {
  const Lanes lanes;
  constexpr int kMiddle = kAngleBins / 2;
  const Vector away = hn::Abs(y), one = hn::Set(lanes, 1.0);
  Vector passed = hn::Zero(lanes);
  for (const ThetaEdge& edge : kThetaEdges) {
    const Mask is_passed =
        hn::Gt(hn::Mul(away, hn::Set(lanes, edge.cosine)), hn::Mul(x, hn::Set(lanes, edge.sine)));
    passed = hn::Add(passed, hn::IfThenElseZero(is_passed, one));
  }
  return hn::Add(hn::Set(lanes, double{kMiddle}), hn::CopySignToAbs(passed, y));
}

}  // namespace

void count_angles(const OrientedPoints& points, Index i, const std::int32_t* neighbours,
                  Index count, std::int32_t* counts) {
  const Lanes lanes;
  const Indices index_lanes;
  const Bins bin_lanes;
  const auto num_lanes = static_cast<Index>(hn::Lanes(lanes));
  const Direction position = of_one(points.x, points.y, points.z, i);
  const Direction a = of_one(points.normal_x, points.normal_y, points.normal_z, i);
  const Vector tie = hn::Set(lanes, kCosineTie), none = hn::Set(lanes, double{kAngleBins});
  std::int32_t rows[kRows][kPairAngles * kAngleRow] = {};
  for (Index k = 0; k < count; k += num_lanes) {
    std::int32_t chosen[kMostLanes];
    const Index num_pairs = count - k < num_lanes ? count - k : num_lanes;
    for (Index lane = 0; lane < num_lanes; ++lane) {
      chosen[lane] = lane < num_pairs ? neighbours[k + lane] : static_cast<std::int32_t>(i);
    }
    const auto indices = hn::PromoteTo(index_lanes, hn::LoadU(bin_lanes, chosen));
    const Direction other_position = gathered(points.x, points.y, points.z, indices);
    const Direction b = gathered(points.normal_x, points.normal_y, points.normal_z, indices);
    const Direction offset{hn::Sub(other_position.x, position.x),
                           hn::Sub(other_position.y, position.y),
                           hn::Sub(other_position.z, position.z)};
    const Vector distance = hn::Sqrt(offset.dot(offset));
    const Vector along_a = a.dot(offset), along_b = b.dot(offset);
    const Mask is_at_a =
        hn::Ge(hn::Abs(along_a), hn::Sub(hn::Abs(along_b), hn::Mul(tie, distance)));
    const Direction u = choose(is_at_a, a, b), other = choose(is_at_a, b, a);
    const Direction from{hn::IfThenElse(is_at_a, offset.x, hn::Neg(offset.x)),
                         hn::IfThenElse(is_at_a, offset.y, hn::Neg(offset.y)),
                         hn::IfThenElse(is_at_a, offset.z, hn::Neg(offset.z))};
    const Direction v = from.cross(u);
    const Direction w = u.cross(v);
    const Vector sine = hn::Sqrt(v.dot(v));
    const Vector zero = hn::Zero(lanes);
    const Mask has_angles = hn::And(hn::Gt(sine, zero), hn::Gt(b.dot(b), zero));
    const Vector cos_alpha = hn::Div(v.dot(other), sine);
    const Vector cos_phi = hn::Div(hn::IfThenElse(is_at_a, along_a, hn::Neg(along_b)), distance);
    const Vector bins[] = {theta_bin(hn::Mul(u.dot(other), sine), w.dot(other)), bin_of(cos_alpha),
                           bin_of(cos_phi)};
    std::int32_t numbers[kPairAngles][kMostLanes];
    for (Index angle = 0; angle < kPairAngles; ++angle) {
      const Vector bin = hn::IfThenElse(has_angles, bins[angle], none);
      hn::StoreU(hn::DemoteTo(bin_lanes, bin), bin_lanes, numbers[angle]);
    }
    for (Index lane = 0; lane < num_pairs; ++lane) {
      std::int32_t* row = rows[lane % kRows];
      for (Index angle = 0; angle < kPairAngles; ++angle) {
        ++row[kAngleRow * angle + numbers[angle][lane]];
      }
    }
  }
  for (const auto& row : rows) {
    for (Index bin = 0; bin < kPairAngles * kAngleRow; ++bin) counts[bin] += row[bin];
  }
}

void sum_histograms(const float* histograms, const std::int32_t* indices, const float* weights,
                    Index count, float* sum) {
  using Floats = hn::CappedTag<float, 16>;
  const Floats lanes;
  constexpr auto kNumLanes = static_cast<Index>(hn::MaxLanes(Floats()));
  constexpr Index kVectors = kHistogramStride / kNumLanes;
  hn::Vec<Floats> sums[kVectors];
  for (Index v = 0; v < kVectors; ++v) sums[v] = hn::Zero(lanes);
  for (Index k = 0; k < count; ++k) {
    const float* histogram = histograms + kHistogramStride * static_cast<Index>(indices[k]);
    const auto weight = hn::Set(lanes, weights[k]);
    for (Index v = 0; v < kVectors; ++v) {  // no fused multiply-add: the bits of the reference
      sums[v] = hn::Add(sums[v], hn::Mul(weight, hn::LoadU(lanes, histogram + kNumLanes * v)));
    }
  }
  for (Index v = 0; v < kVectors; ++v) hn::StoreU(sums[v], lanes, sum + kNumLanes * v);
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(count_angles);
HWY_EXPORT(sum_histograms);

void count_pair_angles(const OrientedPoints& points, Index i, const std::int32_t* neighbours,
                       Index count, std::int32_t* counts) {
  HWY_DYNAMIC_DISPATCH(count_angles)(points, i, neighbours, count, counts);
}

void add_histograms(const float* histograms, const std::int32_t* indices, const float* weights,
                    Index count, float* sum) {
  HWY_DYNAMIC_DISPATCH(sum_histograms)(histograms, indices, weights, count, sum);
}

}  // namespace gmcr::kernels
#endif
