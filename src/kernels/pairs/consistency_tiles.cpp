#include "kernels/pairs/consistency_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/pairs/consistency_tiles_simd.hpp"

namespace gmcr::kernels {
namespace {

constexpr Index kBlock = 64;
constexpr Index kLeastSize = 256;         // below, preparing takes longer than it saves
constexpr double kUnit = 0x1p-24;         // rounding of single precision
constexpr double kLeastBound = 0x1p-13;   // of a pair, relative to the cloud: below, most is doubt
constexpr double kLargestBound = 0x1p10;  // the same: far from overflow
constexpr double kFarthest = 0x1p23;      // from the origin, relative to the cloud
constexpr double kSmallest = 0x1p-100, kLargest = 0x1p100;  // whose fourth powers do not overflow
constexpr float kFar = 1e10F;  // no real point is as far as those that pad

struct Ball {
  Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
  double radius = 0;
};

/// Ball around the middle of the bounding box; its radius is NaN or infinite where a point is.
Ball ball_around(const Eigen::MatrixX3d& points) {
  Ball ball;
  ball.middle = 0.5 * points.colwise().minCoeff() + 0.5 * points.colwise().maxCoeff();
  ball.radius = std::sqrt(
      (points.rowwise() - ball.middle).rowwise().squaredNorm().maxCoeff<Eigen::PropagateNaN>());
  return ball;
}

/// How near 0 the value h of a test in single precision has to be for its sign to be in doubt.
///
/// With u the rounding of single precision, D >= the norm of all (scaled) points and e the bound of
/// a pair: coordinates are off by u D, so squared lengths by 8 u D^2, and computing them as
/// |p|^2 + |q|^2 - 2 p.q adds 18 u D^2; eta is their sum with some room. The value of a test is
///   h = o |o| - 4 e^2 m,  o = (longer^2 - shorter^2) - e^2,  m = shorter^2,
/// and o is off by delta = 2 eta + 10 u e^2. o |o| is monotone, and h = 0 where o = 2 e sqrt(m),
/// which is at most rho = 4 e D: a wrong sign needs |h| <= 2 rho delta + delta^2 + 4 e^2 eta, and
/// the roundings of h itself.
double largest_error(double largest, double bound) {
  const double eta = 36 * kUnit * largest * largest;
  const double delta = 2 * eta + 10 * kUnit * bound * bound;
  const double rho = 4 * bound * largest;
  return 1.125 * (2 * rho * delta + delta * delta + 4 * bound * bound * eta +
                  16 * kUnit * (rho + delta) * (rho + delta));
}

/// The points of block number `block`, scaled, rounded and then put into `out`.
/// @param far  squared norm of those that pad the last block.
void write_points(const Eigen::MatrixX3d& points, const Ball& ball, double scale, float far,
                  Index block, float (&out)[4][kBlock]) {
  const Index begin = block * kBlock, end = std::min(begin + kBlock, points.rows());
  std::fill(&out[0][0], &out[3][0], 0.0F);
  std::fill(out[3], out[3] + kBlock, far);
  for (Index i = begin; i < end; ++i) {
    double twice_squared = 0;
    for (Index axis = 0; axis < 3; ++axis) {
      const auto value = static_cast<float>((points(i, axis) - ball.middle[axis]) * scale);
      out[axis][i - begin] = value;
      twice_squared += static_cast<double>(value) * value;
    }
    out[3][i - begin] = static_cast<float>(0.5 * twice_squared);
  }
}

}  // namespace

ConsistencyTiles::ConsistencyTiles(const geometry::CorrespondenceArrays& arrays, double scale_min,
                                   double scale_max)
    : arrays_(arrays), scale_min_(scale_min), scale_max_(scale_max), pairs_{} {
  if (arrays.size() >= kLeastSize) prepare_single_precision();
}

void ConsistencyTiles::prepare_single_precision() {
  const Ball source = ball_around(arrays_.source), target = ball_around(arrays_.target);
  const double largest = std::max(scale_max_ * source.radius, target.radius);
  const double least_bound = 2 * arrays_.bounds.minCoeff();
  const double largest_bound = 2 * arrays_.bounds.maxCoeff<Eigen::PropagateNaN>();
  const double farthest = std::max(scale_max_ * source.middle.norm(), target.middle.norm());
  // every comparison with a NaN is false
  const bool has_scales = 0 <= scale_min_ && scale_min_ <= scale_max_;
  if (!(has_scales && kSmallest <= scale_max_ && scale_max_ <= kLargest)) return;
  if (!(std::isfinite(source.radius) && std::isfinite(target.radius))) return;
  if (!(kSmallest <= largest && largest <= kLargest)) return;
  if (!(kLeastBound * largest <= least_bound && largest_bound <= kLargestBound * largest)) return;
  if (!(farthest <= kFarthest * largest)) return;

  const double unit = 2 * largest_bound;
  blocks_.resize(static_cast<std::size_t>(num_blocks()));
  for (Index k = 0; k < num_blocks(); ++k) {
    PairBlock& block = blocks_[static_cast<std::size_t>(k)];
    const double factor = std::numbers::sqrt2 / unit;
    write_points(arrays_.source, source, factor * scale_max_, 0, k, block.source);
    write_points(arrays_.target, target, factor, kFar, k, block.target);
    const Index count = std::min(kBlock, arrays_.size() - k * kBlock);
    for (Index i = 0; i < count; ++i) {
      block.bounds[i] = static_cast<float>(arrays_.bounds[k * kBlock + i] / unit);
    }
  }
  pairs_.blocks = blocks_.data();
  const double ratio = scale_min_ / scale_max_;
  pairs_.squared_ratio = static_cast<float>(ratio * ratio);
  pairs_.doubt = static_cast<float>(largest_error(largest / unit, 0.5));
  pairs_.has_equal_bounds = least_bound == largest_bound;
  pairs_.has_one_scale = scale_min_ == scale_max_;
}

BitBlock ConsistencyTiles::tile(Index row_block, Index column_block) const {
  BitBlock block{};
  const Index first_row = row_block * kBlock;
  const Index num_rows = std::min(kBlock, arrays_.size() - first_row);
  std::uint64_t doubtful = ~std::uint64_t{0};  // rows
  if (is_single_precision()) {
    doubtful = consistency_tile_in_single_precision(pairs_, row_block, column_block, block.data());
  }
  for (Index r = 0; r < num_rows; ++r) {
    std::uint64_t& word = block[static_cast<std::size_t>(r)];
    if ((doubtful >> r) & 1u) {
      word = consistency_word(arrays_, first_row + r, scale_min_, scale_max_, column_block);
    }
    if (row_block == column_block) word &= ~(std::uint64_t{1} << r);
  }
  return block;
}

}  // namespace gmcr::kernels
