#include "kernels/features/pair_angles.hpp"

#include <algorithm>
#include <cmath>

namespace gmcr::kernels {
namespace {

/// Bin of a value of [-1, 1].
Index bin_of(double value) {
  constexpr double kHalf = static_cast<double>(kAngleBins) / 2;
  return static_cast<Index>(
      std::min(std::max((value + 1) * kHalf, 0.0), static_cast<double>(kAngleBins - 1)));
}

/// Bin of the direction (x, y): 5 about the axis of x, more to the left of it, less to its right.
Index theta_bin(double x, double y) {
  Index passed = 0;
  for (const ThetaEdge& edge : kThetaEdges) passed += std::abs(y) * edge.cosine > x * edge.sine;
  return kAngleBins / 2 + (std::signbit(y) ? -passed : passed);
}

}  // namespace

void count_pair_angles_reference(const OrientedPoints& points, Index i,
                                 const std::int32_t* neighbours, Index count,
                                 std::int32_t* counts) {
  const double ax = points.normal_x[i], ay = points.normal_y[i], az = points.normal_z[i];
  for (Index k = 0; k < count; ++k) {
    const std::int32_t j = neighbours[k];
    double dx = points.x[j] - points.x[i];
    double dy = points.y[j] - points.y[i];
    double dz = points.z[j] - points.z[i];
    const double bx = points.normal_x[j], by = points.normal_y[j], bz = points.normal_z[j];
    const double distance = std::sqrt((dx * dx + dy * dy) + dz * dz);
    const double along_a = (ax * dx + ay * dy) + az * dz;
    const double along_b = (bx * dx + by * dy) + bz * dz;
    const bool is_at_a = std::abs(along_a) >= std::abs(along_b) - kCosineTie * distance;
    const double ux = is_at_a ? ax : bx, uy = is_at_a ? ay : by, uz = is_at_a ? az : bz;
    const double ox = is_at_a ? bx : ax, oy = is_at_a ? by : ay, oz = is_at_a ? bz : az;
    if (!is_at_a) dx = -dx, dy = -dy, dz = -dz;
    // v = offset x u, w = u x v, both times the sine of the angle between offset and u
    const double vx = dy * uz - dz * uy, vy = dz * ux - dx * uz, vz = dx * uy - dy * ux;
    const double wx = uy * vz - uz * vy, wy = uz * vx - ux * vz, wz = ux * vy - uy * vx;
    const double sine = std::sqrt((vx * vx + vy * vy) + vz * vz);
    const double facing = (bx * bx + by * by) + bz * bz;
    std::int32_t* rows[] = {counts, counts + kAngleRow, counts + 2 * kAngleRow};
    if (!(sine > 0 && facing > 0)) {
      for (std::int32_t* row : rows) ++row[kAngleBins];
      continue;
    }
    const double x = (ux * ox + uy * oy) + uz * oz;
    const double y = (wx * ox + wy * oy) + wz * oz;
    const double cos_alpha = ((vx * ox + vy * oy) + vz * oz) / sine;
    const double cos_phi = (is_at_a ? along_a : -along_b) / distance;
    ++rows[0][theta_bin(x * sine, y)];
    ++rows[1][bin_of(cos_alpha)];
    ++rows[2][bin_of(cos_phi)];
  }
}

void add_histograms_reference(const float* histograms, const std::int32_t* indices,
                              const float* weights, Index count, float* sum) {
  std::fill(sum, sum + kHistogramStride, 0.0f);
  for (Index k = 0; k < count; ++k) {
    const float* histogram = histograms + kHistogramStride * static_cast<Index>(indices[k]);
    for (Index bin = 0; bin < kHistogramStride; ++bin) sum[bin] += weights[k] * histogram[bin];
  }
}

}  // namespace gmcr::kernels
