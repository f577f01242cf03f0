#include "geometry/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace gmcr {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Function {
  const char* name;
  std::function<double(double)> ours;
  std::function<long double(long double)> exact;
  double least, largest;
  bool of_all_sizes = false;  ///< arguments are e to the power of a uniform number, not uniform
  double most_ulps = 4;
};

void PrintTo(const Function& function, std::ostream* out) { *out << function.name; }

/// Error in units in the last place of the exact value.
double ulps(double ours, long double exact) {
  const auto rounded = std::abs(static_cast<double>(exact));
  const double unit = std::nextafter(rounded, kInfinity) - rounded;
  return static_cast<double>(std::abs(static_cast<long double>(ours) - exact)) / unit;
}

class Elementary : public ::testing::TestWithParam<Function> {};

TEST_P(Elementary, FunctionsAreExactToAFewUnits) {
  const Function& function = GetParam();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> between(function.least, function.largest);
  for (int i = 0; i < 100'000; ++i) {
    const double drawn = between(random), x = function.of_all_sizes ? std::exp(drawn) : drawn;
    ASSERT_LE(ulps(function.ours(x), function.exact(x)), function.most_ulps) << x;
  }
}

INSTANTIATE_TEST_SUITE_P(
    OfTheLibrary, Elementary,
    ::testing::Values(
        Function{"sin", elementary::sin, [](auto x) { return std::sin(x); }, -10, 10, false, 1},
        Function{"sin, small", elementary::sin, [](auto x) { return std::sin(x); }, -40, 0, true,
                 1},
        Function{"sin, large", elementary::sin, [](auto x) { return std::sin(x); }, -1e5, 1e5,
                 false, 1},
        Function{"cos", elementary::cos, [](auto x) { return std::cos(x); }, -10, 10, false, 1},
        Function{"asin", elementary::asin, [](auto x) { return std::asin(x); }, -1, 1},
        Function{"atan2, right", [](double y) { return elementary::atan2(y, 1); },
                 [](auto y) { return std::atan(y); }, -40, 40, true},
        Function{"atan2, left", [](double y) { return elementary::atan2(-y, -1); },
                 [](auto y) { return std::atan2(-y, -1.0L); }, -40, 40, true},
        Function{"exp", elementary::exp, [](auto x) { return std::exp(x); }, -700, 700, false, 1},
        Function{"log", elementary::log, [](auto x) { return std::log(x); }, -700, 700, true, 1},
        Function{"log near 1", elementary::log, [](auto x) { return std::log(x); }, 0.5, 2, false,
                 1},
        Function{"log2", elementary::log2, [](auto x) { return std::log2(x); }, -700, 700, true},
        Function{"log10", elementary::log10, [](auto x) { return std::log10(x); }, -700, 700, true},
        Function{"log1p", elementary::log1p, [](auto x) { return std::log1p(x); }, -0.99, 3},
        Function{"log1p, small", elementary::log1p, [](auto x) { return std::log1p(x); }, -60, 0,
                 true},
        Function{"pow", [](double x) { return elementary::pow(x, 0.3); },
                 [](auto x) { return std::pow(x, static_cast<long double>(0.3)); }, -5, 5, true},
        Function{"cbrt", elementary::cbrt, [](auto x) { return std::cbrt(x); }, -700, 700, true,
                 1}));

TEST(Elementary, FunctionsOfNumbersThatNoFormulaGives) {
  EXPECT_EQ(elementary::exp(-kInfinity), 0);
  EXPECT_EQ(elementary::exp(kInfinity), kInfinity);
  EXPECT_EQ(elementary::exp(0), 1);
  EXPECT_EQ(elementary::log(0), -kInfinity);
  EXPECT_EQ(elementary::log1p(-1), -kInfinity);
  EXPECT_EQ(elementary::log10(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(elementary::log(-1)));
  EXPECT_TRUE(std::isnan(elementary::log2(kNaN)));
  EXPECT_TRUE(std::isnan(elementary::sin(kInfinity)));
  EXPECT_TRUE(std::isnan(elementary::asin(1.5)));
  EXPECT_TRUE(std::isnan(elementary::log_factorial(-1)));
  EXPECT_EQ(elementary::pow(0, 2), 0);
  EXPECT_EQ(elementary::pow(0, 0), 1);
  EXPECT_EQ(elementary::cbrt(0), 0);
  EXPECT_EQ(elementary::cbrt(-kInfinity), -kInfinity);
  for (int k = -1074; k < 1024; ++k) EXPECT_EQ(elementary::log2(std::ldexp(1.0, k)), k);
}

TEST(Elementary, FunctionsThatAreOddKeepTheSignOfZero) {
  for (const double zero : {0.0, -0.0}) {
    for (const double value :
         {elementary::sin(zero), elementary::asin(zero), elementary::log1p(zero),
          elementary::cbrt(zero), elementary::atan2(zero, 1)}) {
      EXPECT_EQ(value, 0);
      EXPECT_EQ(std::signbit(value), std::signbit(zero));
    }
  }
}

TEST(Elementary, ArcTangentOfAllQuadrantsIsThatOfTheLibrary) {
  for (const double y : {0.0, 1e-300, 1.0, 1e300, kInfinity}) {
    for (const double x : {-kInfinity, -1e300, -1.0, -1e-300, 0.0, 1e-300, 1.0, 1e300, kInfinity}) {
      EXPECT_LE(ulps(elementary::atan2(y, x), std::atan2(y, x)), 1) << y << " " << x;
      EXPECT_EQ(elementary::atan2(-y, x), -elementary::atan2(y, x)) << y << " " << x;
    }
  }
}

TEST(Elementary, LogOfAFactorialIsTheSumOfLogs) {
  long double sum = 0;
  for (int n = 1; n <= 3000; ++n) {
    sum += std::log(static_cast<long double>(n));
    ASSERT_NEAR(elementary::log_factorial(n), static_cast<double>(sum),
                1e-14 + 1e-15 * static_cast<double>(sum))
        << n;
  }
  EXPECT_NEAR(elementary::log_factorial(0), 0, 1e-14);
  EXPECT_NEAR(elementary::log_factorial(0.5), std::log(std::sqrt(std::numbers::pi) / 2), 1e-14);
}

}  // namespace
}  // namespace gmcr
