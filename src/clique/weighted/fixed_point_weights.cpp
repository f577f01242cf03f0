#include "clique/weighted/fixed_point_weights.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace gmcr::clique {
namespace {

constexpr int kLogMaxTotal = 61;  // of the sum before weights round up
constexpr std::int64_t kMaxUnits = std::int64_t{1} << 62;
// Multiples of this many units add up without rounding in double: its 53 bits hold any sum.
constexpr std::int64_t kExactMultiple = std::int64_t{1}
                                        << (kLogMaxTotal - std::numeric_limits<double>::digits);

double checked_sum(std::span<const double> weights) {
  double sum = 0;
  for (std::size_t v = 0; v < weights.size(); ++v) {
    if (!(weights[v] >= 0) || std::isinf(weights[v])) {
      throw std::invalid_argument("weights: " + std::to_string(weights[v]) + " of vertex " +
                                  std::to_string(v) + " is no finite number >= 0");
    }
    sum += weights[v];
  }
  if (std::isinf(sum)) throw std::invalid_argument("weights: their sum is not finite");
  return sum;
}

}  // namespace

FixedPointWeights::FixedPointWeights(std::span<const double> weights) {
  int log_sum = 0;
  std::frexp(checked_sum(weights), &log_sum);
  exponent_ = kLogMaxTotal - log_sum;
  bool exact = true;
  units_.reserve(weights.size());
  for (const double weight : weights) {
    const double scaled = std::ldexp(weight, exponent_);
    auto units = static_cast<std::int64_t>(scaled);
    // What underflows is more than nothing.
    if (static_cast<double>(units) < scaled || (units == 0 && weight > 0)) {
      ++units;
      exact = false;
    }
    exact = exact && units % kExactMultiple == 0;
    total_ += units;
    units_.push_back(units);
  }
  rounding_ = WeightRounding(exact);
}

std::int64_t FixedPointWeights::units_of(double weight) const {
  const double scaled = std::ldexp(weight, exponent_);
  return scaled < static_cast<double>(kMaxUnits) ? static_cast<std::int64_t>(scaled) : kMaxUnits;
}

double FixedPointWeights::weight_of(std::int64_t units) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  auto scaled = static_cast<double>(units);
  if (static_cast<std::int64_t>(scaled) < units) scaled = std::nextafter(scaled, kInfinity);
  const double weight = std::ldexp(scaled, -exponent_);
  return std::ldexp(weight, exponent_) < scaled ? std::nextafter(weight, kInfinity) : weight;
}

}  // namespace gmcr::clique
