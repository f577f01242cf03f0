#include "frontend/map/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/elementary.hpp"
#include "kernels/pairs/byte_sums.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kCell = 2 * StructureGrid::kCell;  // voxels
constexpr Index kMargin = StructureGrid::kMargin / 2;
constexpr Index kNumHeadings = 120;
constexpr double kTurn = 2 * std::numbers::pi / static_cast<double>(kNumHeadings);
constexpr std::size_t kMostPoints = 250;   // whose sums fit a byte
constexpr std::size_t kMostFound = 20000;  // places that are sorted
constexpr Index kApart = 2;                // cells and headings between distinct places

/// Smallest score that about so many places reach.
int least_of_best(const std::vector<std::uint8_t>& scores, std::size_t count) {
  std::array<std::size_t, 256> histogram{};
  for (const std::uint8_t score : scores) ++histogram[score];
  int least = 255;
  for (std::size_t sum = histogram[255]; least > 1; --least) {
    sum += histogram[static_cast<std::size_t>(least) - 1];
    if (sum > count) break;
  }
  return least;
}

/// The points turned about the sensor.
std::vector<OutlinePoint> turned(const std::vector<OutlinePoint>& points, double heading) {
  const double c = elementary::cos(heading), s = elementary::sin(heading);
  std::vector<OutlinePoint> all;
  all.reserve(points.size());
  for (const OutlinePoint& point : points) {
    all.push_back({c * point.x - s * point.y, s * point.x + c * point.y, point.band});
  }
  return all;
}

/// At most so many of the points, by a fixed stride.
std::vector<OutlinePoint> thinned(const std::vector<OutlinePoint>& points, std::size_t most) {
  if (points.size() <= most) return points;
  std::vector<OutlinePoint> kept;
  for (std::size_t k = 0; k < most; ++k) kept.push_back(points[k * points.size() / most]);
  return kept;
}

}  // namespace

PlaceSearch::PlaceSearch(const StructureGrid& grid)
    : width_(grid.width() / 2), height_(grid.height() / 2), origin_(grid.origin()) {
  const auto num_cells = static_cast<std::size_t>(width_ * height_);
  for (auto& plane : met_) plane.assign(num_cells, 0);
  ground_.resize(num_cells);
  std::vector<char> is_ground(num_cells, 0);
  for (Index cell = 0; cell < width_ * height_; ++cell) {
    const auto at = static_cast<std::size_t>(cell);
    std::uint8_t bits = 0;
    const Index corner = 2 * (cell / width_) * grid.width() + 2 * (cell % width_);
    for (const Index part :
         {corner, corner + 1, corner + grid.width(), corner + grid.width() + 1}) {
      bits |= grid.near(part);
      is_ground[at] |= grid.is_ground(part);
    }
    for (std::size_t band = 0; band < met_.size(); ++band) met_[band][at] = bits >> band & 1;
    ground_[at] = grid.ground(corner);
  }
  find_positions(grid, is_ground);
}

void PlaceSearch::find_positions(const StructureGrid& grid, const std::vector<char>& is_ground) {
  if (grid.width() == 0) return;
  for (Index row = kMargin - 1; row <= height_ - kMargin; ++row) {
    for (Index column = kMargin - 1; column <= width_ - kMargin; ++column) {
      const Index cell = row * width_ + column;
      // the ground below the sensor itself may not have been seen
      const Index beside[] = {cell, cell - 1, cell + 1, cell - width_, cell + width_};
      const bool is_position = std::any_of(std::begin(beside), std::end(beside), [&](Index one) {
        return is_ground[static_cast<std::size_t>(one)] != 0;
      });
      if (is_position) positions_.push_back(cell);
    }
  }
}

double PlaceSearch::half_step() { return kCell / 2; }
double PlaceSearch::half_turn() { return kTurn / 2; }

Place PlaceSearch::place_of(const Found& found) const {
  Place place;
  const Index column = found.cell % width_, row = found.cell / width_;
  place.x = origin_.x() + kCell * (static_cast<double>(column) + 0.5);
  place.y = origin_.y() + kCell * (static_cast<double>(row) + 0.5);
  place.ground = static_cast<double>(ground_[static_cast<std::size_t>(found.cell)]);
  place.heading = kTurn * static_cast<double>(found.heading);
  return place;
}

std::vector<PlaceSearch::Run> PlaceSearch::admitted_runs(const PlaceLimits& limits) const {
  std::vector<Run> runs;
  Index number = 0;
  for (const Index cell : positions_) {
    const Place place = place_of({0, 0, cell});
    if (limits.position && !limits.position(place.x, place.y)) continue;
    if (!runs.empty() && cell == runs.back().cell + runs.back().length) {
      ++runs.back().length;
    } else {
      runs.push_back({cell, 1, number});
    }
    ++number;
  }
  return runs;
}

void PlaceSearch::count_met(const std::vector<OutlinePoint>& points, double heading,
                            const std::vector<Run>& runs, std::uint8_t* sums) const {
  std::vector<const std::uint8_t*> planes;  // moved so that the place of the sensor is the index
  for (const OutlinePoint& point : turned(points, heading)) {
    const auto x = static_cast<Index>(std::lround(point.x / kCell));
    const auto y = static_cast<Index>(std::lround(point.y / kCell));
    planes.push_back(met_[static_cast<std::size_t>(point.band)].data() + y * width_ + x);
  }
  for (const Run& run : runs) {
    kernels::sum_bytes(planes.data(), static_cast<Index>(planes.size()), run.cell, run.length,
                       sums + run.number);
  }
}

std::vector<PlaceSearch::Found> PlaceSearch::distinct(std::vector<Found> found,
                                                      std::size_t most) const {
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.score > b.score; });
  std::vector<Found> kept;
  for (const Found& one : found) {
    if (kept.size() == most) break;
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const Found& other) {
      const Index turn = std::abs(one.heading - other.heading);
      return std::abs(one.cell / width_ - other.cell / width_) <= kApart &&
             std::abs(one.cell % width_ - other.cell % width_) <= kApart &&
             std::min(turn, kNumHeadings - turn) <= kApart;
    });
    if (is_new) kept.push_back(one);
  }
  return kept;
}

std::vector<Place> PlaceSearch::best(const ScanOutline& outline, std::size_t most,
                                     const PlaceLimits& limits, int num_threads,
                                     const parallel::Deadline& deadline) const {
  const std::vector<Run> runs = admitted_runs(limits);
  std::vector<Index> headings;
  for (Index h = 0; h < kNumHeadings; ++h) {
    if (!limits.heading || limits.heading(kTurn * static_cast<double>(h))) headings.push_back(h);
  }
  if (runs.empty() || headings.empty() || outline.structure.empty()) return {};
  const Index num_positions = runs.back().number + runs.back().length;
  const auto num_headings = static_cast<Index>(headings.size());
  const std::vector<OutlinePoint> points = thinned(outline.structure, kMostPoints);
  std::vector<std::uint8_t> scores(static_cast<std::size_t>(num_headings * num_positions), 0);
  parallel::parallel_for(num_headings, 1, num_threads, [&](Index begin, Index end) {
    for (Index h = begin; h < end && !deadline.expired(); ++h) {
      count_met(points, kTurn * static_cast<double>(headings[static_cast<std::size_t>(h)]), runs,
                scores.data() + h * num_positions);
    }
  });
  const int least = least_of_best(scores, kMostFound);
  std::vector<Found> found;
  for (Index h = 0; h < num_headings; ++h) {
    const std::uint8_t* const of_heading = scores.data() + h * num_positions;
    for (const Run& run : runs) {
      for (Index k = 0; k < run.length; ++k) {
        const int score = of_heading[run.number + k];
        if (score < least) continue;
        found.push_back({score, headings[static_cast<std::size_t>(h)], run.cell + k});
      }
    }
  }
  std::vector<Place> places;
  for (const Found& one : distinct(std::move(found), most)) places.push_back(place_of(one));
  return places;
}

}  // namespace gmcr::frontend
