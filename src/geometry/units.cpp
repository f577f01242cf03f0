#include "geometry/units.hpp"

#include <cmath>

#include "geometry/elementary.hpp"

namespace gmcr::geometry {
namespace {

struct Units {
  double ratio;
  const char *large, *small;
};

constexpr Units kUnits[] = {{1000, "meters", "millimeters"},
                            {100, "meters", "centimeters"},
                            {39.3701, "meters", "inches"},
                            {25.4, "inches", "millimeters"},
                            {3.28084, "meters", "feet"}};
// The sizes of clouds that overlap in part differ by themselves.
constexpr double kAlike = 1.2;

std::string sentence(const char* source, const char* target) {
  return std::string("the source seems to be in ") + source + " and the target in " + target;
}

}  // namespace

std::string units_of_ratio(double ratio) {
  const auto is_near = [&](double other) {
    return std::abs(elementary::log(ratio / other)) < elementary::log(kAlike);
  };
  for (const auto& [factor, large, small] : kUnits) {
    if (is_near(factor)) return sentence(large, small);
    if (is_near(1 / factor)) return sentence(small, large);
  }
  return {};
}

}  // namespace gmcr::geometry
