#include "synthetic/town/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gmcr::synthetic {
namespace {

constexpr double kCell = 4;      // metres
constexpr double kMargin = 100;  // metres beyond the streets
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Stretch of a ray inside a slab.
struct Stretch {
  double from, to;

  void cut(double start, double step, double low, double high) {
    if (step == 0) {
      if (start < low || start > high) to = -1;
      return;
    }
    const double a = (low - start) / step, b = (high - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  double entry() const { return from > 0 && from <= to ? from : kNever; }
};

double meet_box(const TownBox& box, const Eigen::Vector3d& origin, const Eigen::Vector3d& ray,
                double farthest) {
  const Eigen::Vector2d along = box.direction, across(-along.y(), along.x());
  const Eigen::Vector2d start = origin.head<2>() - box.centre;
  Stretch stretch{0, farthest};
  stretch.cut(start.dot(along), ray.head<2>().dot(along), -box.half.x(), box.half.x());
  stretch.cut(start.dot(across), ray.head<2>().dot(across), -box.half.y(), box.half.y());
  stretch.cut(origin.z(), ray.z(), box.low, box.high);
  return stretch.entry();
}

double meet_cylinder(const TownCylinder& cylinder, const Eigen::Vector3d& origin,
                     const Eigen::Vector3d& ray, double farthest) {
  const Eigen::Vector2d start = origin.head<2>() - cylinder.centre, step = ray.head<2>();
  const double a = step.squaredNorm(), b = start.dot(step);
  const double root = b * b - a * (start.squaredNorm() - cylinder.radius * cylinder.radius);
  if (root < 0 || a == 0) return kNever;
  Stretch stretch{(-b - std::sqrt(root)) / a, std::min(farthest, (-b + std::sqrt(root)) / a)};
  stretch.cut(origin.z(), ray.z(), cylinder.low, cylinder.high);
  return stretch.entry();
}

}  // namespace

RayCaster::RayCaster(const Town& town)
    : boxes_(town.boxes), cylinders_(town.cylinders), origin_(-kMargin, -kMargin) {
  size_ = static_cast<Index>((town.extent + 2 * kMargin) / kCell) + 1;
  cells_.resize(static_cast<std::size_t>(size_ * size_));
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const TownBox& box = boxes_[k];
    const double reach = box.half.norm();
    add(k, box.centre.array() - reach, box.centre.array() + reach);
  }
  for (std::size_t k = 0; k < cylinders_.size(); ++k) {
    const TownCylinder& cylinder = cylinders_[k];
    add(boxes_.size() + k, cylinder.centre.array() - cylinder.radius,
        cylinder.centre.array() + cylinder.radius);
  }
}

void RayCaster::add(std::size_t shape, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  const auto cell = [&](double value) {
    return std::clamp<Index>(static_cast<Index>(std::floor(value / kCell)), 0, size_ - 1);
  };
  const Eigen::Vector2d from = low - origin_, to = high - origin_;
  for (Index y = cell(from.y()); y <= cell(to.y()); ++y) {
    for (Index x = cell(from.x()); x <= cell(to.x()); ++x) {
      cells_[static_cast<std::size_t>(y * size_ + x)].push_back(static_cast<std::uint32_t>(shape));
    }
  }
}

double RayCaster::meet(std::size_t shape, const Eigen::Vector3d& origin,
                       const Eigen::Vector3d& direction, double farthest) const {
  if (shape < boxes_.size()) return meet_box(boxes_[shape], origin, direction, farthest);
  return meet_cylinder(cylinders_[shape - boxes_.size()], origin, direction, farthest);
}

double RayCaster::distance(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                           double range) const {
  double best = range;
  if (direction.z() < 0) best = std::min(best, -origin.z() / direction.z());
  const Eigen::Vector2d start = (origin.head<2>() - origin_) / kCell;
  Index cell[2], step[2];
  double next[2], delta[2];  // metres along the ray, to the next cell of each axis
  for (int axis = 0; axis < 2; ++axis) {
    const double speed = direction[axis] / kCell;
    cell[axis] = static_cast<Index>(std::floor(start[axis]));
    step[axis] = speed < 0 ? -1 : 1;
    delta[axis] = speed == 0 ? kNever : std::abs(1 / speed);
    const double edge = static_cast<double>(cell[axis] + (speed < 0 ? 0 : 1));
    next[axis] = speed == 0 ? kNever : (edge - start[axis]) / speed;
  }
  for (double entered = 0; entered < best;) {
    if (cell[0] < 0 || cell[1] < 0 || cell[0] >= size_ || cell[1] >= size_) break;
    for (const std::uint32_t shape : cells_[static_cast<std::size_t>(cell[1] * size_ + cell[0])]) {
      best = std::min(best, meet(shape, origin, direction, best));
    }
    const int axis = next[0] < next[1] ? 0 : 1;
    entered = next[axis];
    next[axis] += delta[axis];
    cell[axis] += step[axis];
  }
  return best;
}

}  // namespace gmcr::synthetic
