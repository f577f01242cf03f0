#include "geometry/units.hpp"

#include <gtest/gtest.h>

namespace gmcr::geometry {
namespace {

TEST(UnitsOfRatio, NamesBothUnits) {
  EXPECT_EQ(units_of_ratio(1000), "the source seems to be in meters and the target in millimeters");
  EXPECT_EQ(units_of_ratio(0.001),
            "the source seems to be in millimeters and the target in meters");
  EXPECT_EQ(units_of_ratio(25.4), "the source seems to be in inches and the target in millimeters");
  EXPECT_EQ(units_of_ratio(0.3048), "the source seems to be in feet and the target in meters");
  EXPECT_EQ(units_of_ratio(110), "the source seems to be in meters and the target in centimeters");
}

TEST(UnitsOfRatio, SaysNothingOfOtherRatios) {
  for (const double ratio : {0.0, 1.0, 2.0, 10.0, 60.0, 300.0, 1e6}) {
    EXPECT_EQ(units_of_ratio(ratio), "") << ratio;
  }
}

}  // namespace
}  // namespace gmcr::geometry
