#include "frontend/points/range_image.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace gmcr::frontend {
namespace {

constexpr Index kMostPoints = 30000;
constexpr int kFinest = 128;        // cells along a side
constexpr int kCoarsest = 16;       // coarser cells see nothing
constexpr std::size_t kInCell = 6;  // points
/// Diagonals of the cloud between two points of a cell: the second one would be hidden.
constexpr double kGap = 0.06;
constexpr double kMostHidden = 0.15;  // of the points, in cells with a gap
/// Cosine to the middle of the cloud of what lies to one side: cameras see 47 degrees off at most.
constexpr double kToOneSide = 0.64;
/// Length of the mean direction above which a cloud does not lie all around.
constexpr double kMostAside = 0.6;

constexpr float kNothing = std::numeric_limits<float>::infinity();

Points rays_to(const PointsRef& points, const Eigen::Vector3d& viewpoint) {
  const Index stride = std::max<Index>(1, (points.cols() + kMostPoints - 1) / kMostPoints);
  Points rays(3, (points.cols() + stride - 1) / stride);
  Index count = 0;
  for (Index i = 0; i < points.cols(); i += stride) {
    const Eigen::Vector3d ray = points.col(i) - viewpoint;
    if (!ray.isZero(0)) rays.col(count++) = ray;
  }
  return rays.leftCols(count);
}

/// The least of each cell and those next to it on the same side.
std::vector<float> least_around(const std::vector<float>& values, std::size_t row) {
  const auto spread = [&](const std::vector<float>& from, std::size_t step, std::size_t line) {
    std::vector<float> least = from;
    for (std::size_t k = 0; k < from.size(); ++k) {
      const std::size_t place = k / step % line;
      if (place > 0) least[k] = std::min(least[k], from[k - step]);
      if (place + 1 < line) least[k] = std::min(least[k], from[k + step]);
    }
    return least;
  };
  return spread(spread(values, 1, row), row, row);
}

}  // namespace

RangeImage::RangeImage(const PointsRef& points, const Eigen::Vector3d& viewpoint)
    : viewpoint_(viewpoint) {
  const Points rays = rays_to(points, viewpoint);
  if (rays.cols() == 0) return;
  is_all_around_ = !lies_aside(rays);
  std::vector<Seen> seen;
  seen.reserve(static_cast<std::size_t>(rays.cols()));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto ray : rays.colwise()) {
    const double range = ray.norm();
    sum += ray / range;
    seen.push_back({*pixel_of(ray), static_cast<float>(range)});
  }
  if (is_all_around_ && sum.norm() > kMostAside * static_cast<double>(rays.cols())) return;
  coarsen(seen);
  if (kFinest >> coarseness_ < kCoarsest) return;
  fill(seen, (rays.rowwise().maxCoeff() - rays.rowwise().minCoeff()).norm());
}

/// Whether one side holds the cloud; then where on it.
bool RangeImage::lies_aside(const Points& rays) {
  const Eigen::Vector3d middle = (rays.rowwise().minCoeff() + rays.rowwise().maxCoeff()) / 2;
  if (middle.isZero(0)) return false;
  const Eigen::Vector3d forward = middle.normalized(), right = forward.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const auto ray : rays.colwise()) {
    const Eigen::Vector3d along = axes * ray;
    if (along.z() < kToOneSide * ray.norm()) return false;
    low = low.cwiseMin(along.head<2>() / along.z());
    high = high.cwiseMax(along.head<2>() / along.z());
  }
  axes_ = axes;
  corner_ = low;
  width_ = std::max((high - low).maxCoeff(), std::numeric_limits<double>::min());
  return true;
}

/// Halves the image until the cells with points have several.
void RangeImage::coarsen(const std::vector<Seen>& seen) {
  std::size_t num_occupied = 0;
  for (coarseness_ = 0; kFinest >> coarseness_ >= kCoarsest; ++coarseness_) {
    const auto row = static_cast<std::size_t>(kFinest >> coarseness_);
    std::vector<char> has_point(6 * row * row);
    for (const Seen& one : seen) has_point[cell_of(one.pixel)] = 1;
    num_occupied = static_cast<std::size_t>(std::count(has_point.begin(), has_point.end(), 1));
    if (seen.size() >= kInCell * num_occupied) return;
  }
}

void RangeImage::fill(const std::vector<Seen>& seen, double diagonal) {
  const auto row = static_cast<std::size_t>(kFinest >> coarseness_);
  const std::size_t num_cells = (is_all_around_ ? 6 : 1) * row * row;
  std::vector<std::size_t> begin(num_cells + 1);
  for (const Seen& one : seen) ++begin[cell_of(one.pixel) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<float> ranges(seen.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const Seen& one : seen) ranges[next[cell_of(one.pixel)]++] = one.range;
  nearest_.assign(num_cells, kNothing);
  std::size_t num_hidden = 0;
  for (std::size_t cell = 0; cell < num_cells; ++cell) {
    const auto first = ranges.begin() + static_cast<std::ptrdiff_t>(begin[cell]);
    const auto last = ranges.begin() + static_cast<std::ptrdiff_t>(begin[cell + 1]);
    if (first == last) continue;
    std::sort(first, last);
    nearest_[cell] = *first;
    bool has_gap = false;
    for (auto range = first + 1; range != last; ++range) {
      has_gap = has_gap || *range - *(range - 1) > kGap * diagonal;
    }
    if (has_gap) num_hidden += static_cast<std::size_t>(last - first);
  }
  nearest_around_ = least_around(nearest_, row);
  is_view_ = static_cast<double>(num_hidden) <= kMostHidden * static_cast<double>(seen.size());
}

std::optional<RangeImage::Pixel> RangeImage::pixel_of(const Eigen::Vector3d& ray) const {
  Eigen::Vector3d along = axes_ * ray;
  std::uint16_t side = 0;
  if (is_all_around_) {
    Index axis;
    along.cwiseAbs().maxCoeff(&axis);
    side = static_cast<std::uint16_t>(2 * axis + (along[axis] < 0));
    along = {along[(axis + 1) % 3], along[(axis + 2) % 3], std::abs(along[axis])};
  }
  if (!(along.z() > 0)) return std::nullopt;
  const Eigen::Vector2d place = (along.head<2>() / along.z() - corner_) / width_;
  if (!(place.minCoeff() >= 0) || !(place.maxCoeff() <= 1)) return std::nullopt;
  const auto number = [](double share) {
    return static_cast<std::uint16_t>(std::min(static_cast<int>(share * kFinest), kFinest - 1));
  };
  return Pixel{side, number(place.x()), number(place.y())};
}

std::size_t RangeImage::cell_of(const Pixel& pixel) const {
  const auto row = static_cast<std::size_t>(kFinest >> coarseness_);
  const auto along = static_cast<std::size_t>(pixel.row >> coarseness_);
  return (pixel.side * row + along) * row + static_cast<std::size_t>(pixel.column >> coarseness_);
}

bool RangeImage::sees_through(const Eigen::Vector3d& ray, double margin) const {
  if (nearest_.empty()) return false;
  const auto pixel = pixel_of(ray);
  if (!pixel) return false;
  const std::size_t cell = cell_of(*pixel);
  const double nearest = nearest_around_[cell];
  return nearest_[cell] != kNothing && nearest > ray.norm() + margin;
}

std::shared_ptr<const RangeImage> view_from(const Eigen::Vector3d& viewpoint,
                                            const PointsRef& points) {
  auto view = std::make_shared<const RangeImage>(points, viewpoint);
  return view->is_view() ? view : nullptr;
}

}  // namespace gmcr::frontend
