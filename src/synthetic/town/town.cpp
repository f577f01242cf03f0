#include "synthetic/town/town.hpp"

#include <cmath>
#include <numbers>

#include "geometry/elementary.hpp"

namespace gmcr::synthetic {
namespace {

constexpr double kStreet = 6;     // metres: half the width between the pavements
constexpr double kPavement = 2;   // metres
constexpr double kBeyond = 1.5;   // metres: how far a scanner drives beside the middle line
constexpr double kPoleStep = 28;  // metres

/// What the houses of a row are like, metres.
struct House {
  double width, depth, height, setback, gap, turn;
  double porch;   ///< width of what stands out in front, 0: nothing
  double garage;  ///< width of what stands beside, 0: nothing
  bool has_tree;
};

House draw_house(Random& random) {
  House house{};
  house.width = random.uniform(7, 13);
  house.depth = random.uniform(7, 11);
  house.height = random.uniform(4, 10);
  house.setback = random.uniform(0.5, 5);
  house.gap = random.uniform(2, 7);
  house.turn = random.uniform(-0.07, 0.07);
  house.porch = random.uniform() < 0.5 ? random.uniform(1.5, 4) : 0;
  house.garage = random.uniform() < 0.5 ? random.uniform(1, 2) : 0;
  house.has_tree = random.uniform() < 0.4;
  return house;
}

/// One side of a block: houses between two corners, that look to one side.
struct Row {
  Eigen::Vector2d start, along, outward;
  double length;
};

void add_house(Town& town, const House& house, const Row& row, double at) {
  const auto place = [&](double along, double back) -> Eigen::Vector2d {
    return row.start + along * row.along - back * row.outward;
  };
  const double c = elementary::cos(house.turn), s = elementary::sin(house.turn);
  const Eigen::Vector2d direction = c * row.along + s * row.outward;
  const double middle = at + house.width / 2;
  town.boxes.push_back({place(middle, house.setback + house.depth / 2),
                        direction,
                        {house.width / 2, house.depth / 2},
                        0,
                        house.height});
  if (house.porch > 0) {
    town.boxes.push_back({place(at + house.width / 3, house.setback - 0.2),
                          direction,
                          {house.porch / 2, 0.8},
                          0,
                          2.8});
  }
  if (house.garage > 0) {
    town.boxes.push_back({place(at + house.width + house.garage / 2, house.setback + 4),
                          direction,
                          {house.garage / 2, 2.5},
                          0,
                          2.6});
  }
  if (house.has_tree) {
    const Eigen::Vector2d foot = place(at + house.width + house.gap / 2, 0.4);
    town.cylinders.push_back({foot, 0.25, 0, 3});
    town.cylinders.push_back({foot, 1 + house.depth / 10, 2.5, 3 + house.height / 2});
  }
}

void add_row(Town& town, const Row& row, bool is_repeated, Random& random) {
  House house = draw_house(random);
  if (is_repeated) house.turn = 0;
  for (double at = 1; at + house.width < row.length;) {
    add_house(town, house, row, at);
    at += house.width + house.gap;
    if (!is_repeated) house = draw_house(random);
  }
}

void add_block(Town& town, const Eigen::Vector2d& low, double size, const TownOptions& options,
               Random& random) {
  const double edge = kStreet + kPavement;
  const double inner = size - 2 * edge, side = 14;  // metres: rows at the sides leave the corners
  const Eigen::Vector2d x(1, 0), y(0, 1), first = low.array() + edge;
  const Row rows[] = {{first, x, -y, inner},
                      {first + inner * y, x, y, inner},
                      {first + side * y, y, -x, inner - 2 * side},
                      {first + inner * x + side * y, y, x, inner - 2 * side}};
  for (const Row& row : rows) {
    const bool is_repeated = random.uniform() < options.repeated_share;
    add_row(town, row, is_repeated, random);
  }
}

void add_poles(Town& town, Random& random) {
  for (const auto& [from, to] : town.streets) {
    const double length = (to - from).norm();
    const Eigen::Vector2d along = (to - from) / length, beside(-along.y(), along.x());
    double at = random.uniform(0, kPoleStep);
    while (at < length) {
      town.cylinders.push_back({from + at * along + (kStreet + 0.5) * beside, 0.12, 0, 7});
      at += kPoleStep;
    }
  }
}

void add_cars(Town& town, Random& random) {
  for (const auto& [from, to] : town.streets) {
    const double length = (to - from).norm();
    const Eigen::Vector2d along = (to - from) / length, beside(-along.y(), along.x());
    double at = random.uniform(0, 15);
    while (at < length) {
      const double side = random.uniform() < 0.5 ? -1 : 1;
      town.boxes.push_back(
          {from + at * along + side * (kStreet - 1.2) * beside, along, {2.2, 0.9}, 0.2, 1.5});
      at += random.uniform(6, 30);
    }
  }
}

}  // namespace

Town make_town(const TownOptions& options) {
  Random random(options.seed), cars(options.cars_seed ^ 0x9e3779b97f4a7c15U);
  Town town;
  town.extent = options.extent;
  const auto num_blocks = std::max(1L, std::lround(options.extent / options.block));
  const double size = options.extent / static_cast<double>(num_blocks);
  for (long k = 0; k <= num_blocks; ++k) {
    const double at = size * static_cast<double>(k);
    town.streets.push_back({{0, at}, {options.extent, at}});
    town.streets.push_back({{at, 0}, {at, options.extent}});
  }
  // a row of houses beyond the outermost streets, so that these have two sides
  for (long i = -1; i <= num_blocks; ++i) {
    for (long j = -1; j <= num_blocks; ++j) {
      const Eigen::Vector2d corner(size * static_cast<double>(i), size * static_cast<double>(j));
      add_block(town, corner, size, options, random);
    }
  }
  add_poles(town, random);
  add_cars(town, cars);
  return town;
}

std::vector<TownPlace> drive(const Town& town, double step) {
  std::vector<TownPlace> places;
  for (const auto& [from, to] : town.streets) {
    const double length = (to - from).norm();
    const Eigen::Vector2d along = (to - from) / length;
    double at = 0;
    while (at <= length) {
      places.push_back({from + at * along, elementary::atan2(along.y(), along.x())});
      at += step;
    }
  }
  return places;
}

TownPlace random_place(const Town& town, Random& random) {
  const auto& [from, to] =
      town.streets[static_cast<std::size_t>(random.index(static_cast<Index>(town.streets.size())))];
  const Eigen::Vector2d along = (to - from).normalized(), beside(-along.y(), along.x());
  const double at = random.uniform(0, (to - from).norm());
  return {from + at * along + random.uniform(-kBeyond, kBeyond) * beside,
          random.uniform(-std::numbers::pi, std::numbers::pi)};
}

}  // namespace gmcr::synthetic
