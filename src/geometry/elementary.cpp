#include "geometry/elementary.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gmcr::elementary {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
/// In parts of 33 bits, whose products with whole numbers below 2^20 are exact, and the rest.
constexpr double kHalfPi[] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
constexpr double kLog2[] = {0x1.62e42fefp-1, 0x1.473de6afp-34, 0x1.3c7673007e5edp-69};
/// pi / 2 less its own rounding.
constexpr double kHalfPiRest = 6.123233995736766e-17;

constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// term(0), term(1), ...
template <std::size_t kTerms>
constexpr std::array<double, kTerms> series(double (*term)(int)) {
  std::array<double, kTerms> terms{};
  for (std::size_t i = 0; i < kTerms; ++i) terms[i] = term(static_cast<int>(i));
  return terms;
}

// Taylor's, to below the rounding of the sum over the arguments that are left after reduction.
constexpr auto kSine = series<8>([](int i) { return (i % 2 ? 1 : -1) / factorial(2 * i + 3); });
constexpr auto kCosine = series<7>([](int i) { return (i % 2 ? -1 : 1) / factorial(2 * i + 4); });
constexpr auto kArcTangent = series<6>([](int i) { return (i % 2 ? 1.0 : -1.0) / (2 * i + 3); });
constexpr auto kExponential = series<12>([](int i) { return 1 / factorial(i + 2); });
constexpr auto kLogarithm = series<11>([](int i) { return 2.0 / (2 * i + 3); });

template <std::size_t kTerms>
double polynomial(const std::array<double, kTerms>& terms, double x) {
  double sum = terms[kTerms - 1];
  for (std::size_t i = kTerms - 1; i-- > 0;) sum = terms[i] + x * sum;
  return sum;
}

/// A number as rounded, and what rounding took from it.
struct Split {
  double high, low;
};

/// x less k, a whole number, times the sum of the parts.
Split less_multiple(double x, double k, const double (&parts)[3]) {
  const double first = x - k * parts[0];
  const double high = first - k * parts[1];
  return {high, ((first - high) - k * parts[1]) - k * parts[2]};
}

/// |x| up to pi / 4.
double sine_of_small(Split x) {
  const double z = x.high * x.high;
  return x.high + (x.high * z * polynomial(kSine, z) + x.low * (1 - z / 2));
}

double cosine_of_small(Split x) {
  const double z = x.high * x.high, first = 1 - z / 2;
  return first + (((1 - first) - z / 2) + (z * z * polynomial(kCosine, z) - x.high * x.low));
}

/// sin(x + quarters pi / 2).
double sine(double x, double quarters) {
  const double k = std::floor(x * (2 / std::numbers::pi) + 0.5);
  const Split rest = less_multiple(x, k, kHalfPi);
  const double turns = (k + quarters) / 4;
  const double quarter = 4 * (turns - std::floor(turns));
  if (quarter == 0) return sine_of_small(rest);
  if (quarter == 1) return cosine_of_small(rest);
  if (quarter == 2) return -sine_of_small(rest);
  if (quarter == 3) return -cosine_of_small(rest);
  return kNaN;
}

/// Arc tangent of t in [0, 1], by that of the nearest eighth.
double arc_tangent(double t) {
  constexpr double kOfEighths[] = {0,
                                   0.12435499454676144,
                                   0.24497866312686414,
                                   0.35877067027057225,
                                   0.4636476090008061,
                                   0.5585993153435624,
                                   0.6435011087932844,
                                   0.7188299996216245,
                                   std::numbers::pi / 4};
  const double eighths = std::floor(8 * t + 0.5), near = eighths / 8;
  const double u = (t - near) / (1 + t * near);
  const double z = u * u;
  return kOfEighths[static_cast<int>(eighths)] + (u + u * z * polynomial(kArcTangent, z));
}

/// log(1 + f) + e log(2) for 1 + f within a factor of 1.5 of 1, e whole.
double logarithm(double f, double e) {
  const double s = f / (2 + f), z = s * s, half_square = f * f / 2;
  const double rest =
      half_square - (s * (half_square + z * polynomial(kLogarithm, z)) + e * kLog2[1]);
  return e * kLog2[0] - (rest - f);
}

/// x = 2^e (1 + f), the latter between the roots of 1/2 and 2; x > 0, finite.
struct Binary {
  double f, e;
};

Binary binary(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < std::numbers::sqrt2 / 2) {
    mantissa *= 2;
    --exponent;
  }
  return {mantissa - 1, static_cast<double>(exponent)};
}

/// Whether the logarithm of x is one of the numbers that no formula gives.
bool has_plain_logarithm(double x) { return !(x > 0 && x < kInfinity); }

double plain_logarithm(double x) { return x == 0 ? -kInfinity : x > 0 ? x : kNaN; }

}  // namespace

double sin(double x) { return x == 0 ? x : sine(x, 0); }

double cos(double x) { return sine(x, 1); }

double asin(double x) { return atan2(x, std::sqrt((1 - x) * (1 + x))); }

double atan2(double y, double x) {
  const double up = std::abs(y), across = std::abs(x);
  if (std::isnan(up) || std::isnan(across)) return kNaN;
  const bool is_steep = up > across;
  double t = is_steep ? across / up : up / across;
  if (up == across) t = up == 0 ? 0 : 1;  // two infinities among them
  double angle = arc_tangent(t);
  if (is_steep) angle = std::numbers::pi / 2 - (angle - kHalfPiRest);
  if (std::signbit(x)) angle = std::numbers::pi - (angle - 2 * kHalfPiRest);
  return std::copysign(angle, y);
}

double exp(double x) {
  constexpr double kLargest = 710, kLeast = -746;  // beyond them: infinity and 0
  if (std::isnan(x)) return kNaN;
  if (x > kLargest) return kInfinity;
  if (x < kLeast) return 0;
  const double k = std::floor(x * std::numbers::log2e + 0.5);
  const Split rest = less_multiple(x, k, kLog2);
  const double square = rest.high * rest.high;
  const double power = 1 + (rest.high + (rest.low + square * polynomial(kExponential, rest.high)));
  return std::ldexp(power, static_cast<int>(k));
}

double log(double x) {
  if (has_plain_logarithm(x)) return plain_logarithm(x);
  const auto [f, e] = binary(x);
  return logarithm(f, e);
}

double log2(double x) {
  if (has_plain_logarithm(x)) return plain_logarithm(x);
  const auto [f, e] = binary(x);
  return e + logarithm(f, 0) * std::numbers::log2e;
}

double log10(double x) { return log(x) * std::numbers::log10e; }

double log1p(double x) {
  constexpr double kLeast = -0.29, kLargest = 0.41;  // what `logarithm` takes
  if (x == 0) return x;
  return x > kLeast && x < kLargest ? logarithm(x, 0) : log(1 + x);
}

double pow(double base, double exponent) {
  if (exponent == 0) return 1;
  return exp(exponent * log(base));
}

double cbrt(double x) {
  const double size = std::abs(x);
  if (has_plain_logarithm(size)) return x;
  const double root = exp(log(size) / 3);
  return std::copysign(root - (root - size / (root * root)) / 3, x);
}

double log_factorial(double n) {
  constexpr double kFew = 20;
  if (!(n >= 0)) return kNaN;
  double product = 1;
  while (n < kFew) product *= ++n;
  // Stirling's series
  const double z = 1 / (n * n);
  const double tail = (1.0 / 12 - z * (1.0 / 360 - z * (1.0 / 1260 - z / 1680))) / n;
  return n * log(n) - n + log(2 * std::numbers::pi * n) / 2 + tail - log(product);
}

}  // namespace gmcr::elementary
