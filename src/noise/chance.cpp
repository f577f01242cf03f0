#include "noise/chance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/elementary.hpp"
#include "problem/selection.hpp"

namespace gmcr::noise {
namespace {

constexpr std::size_t kFew = 10;  // values that tell a share

// Pairs that are looked at: enough for a share of 1 in 50, and more where that costs little.
constexpr Index kLeastSample = 500;
constexpr Index kMostSample = 10'000;
constexpr Index kCorrespondencesAPair = 2;
constexpr std::size_t kPerLength = 4;

/// Two different numbers below a count.
struct Couple {
  Index first, second;
};

/// Number k of a sequence of couples without a pattern, the same every time.
Couple couple(std::uint64_t k, Index count) {
  constexpr int kHalf = 32;
  const std::uint64_t bits = problem::mixed(k);
  const auto below = [](std::uint64_t half, Index end) {
    return static_cast<Index>((half * static_cast<std::uint64_t>(end)) >> kHalf);
  };
  const Index first = below(bits >> kHalf, count);
  const Index second = first + 1 + below(bits & ((std::uint64_t{1} << kHalf) - 1), count - 1);
  return {first, second < count ? second : second - count};
}

double log10_choose(double n, double k) {
  return (elementary::log_factorial(n) - elementary::log_factorial(k) -
          elementary::log_factorial(n - k)) *
         std::numbers::log10e;
}

/// log10 of P(X >= k), X ~ Binomial(n, p), from above: its first term, and the others as a
/// geometric series.
double log10_tail(double k, double n, double p) {
  if (k <= n * p) return 0;
  const double first =
      log10_choose(n, k) + k * elementary::log10(p) + (n - k) * elementary::log10(1 - p);
  const double ratio = (n - k) * p / ((k + 1) * (1 - p));  // < 1 above the mean
  return std::min(0.0, first - elementary::log10(1 - ratio));
}

}  // namespace

Tail Tail::through(double low, std::size_t low_rank, double high, std::size_t high_rank,
                   std::size_t count) {
  Tail tail{low, static_cast<double>(low_rank + 1) / static_cast<double>(count), 1};
  if (high > low && low > 0) {
    const double ratio = static_cast<double>(high_rank + 1) / static_cast<double>(low_rank + 1);
    tail.power = std::clamp(elementary::log(ratio) / elementary::log(high / low), 1.0, 3.0);
  }
  return tail;
}

double Tail::share_within(double r) const {
  return r < radius ? share * elementary::pow(r / radius, power) : share;
}

double share_within(std::vector<double>& values, double radius) {
  if (values.empty()) return 1;
  const auto within = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [&](double value) { return value <= radius; }));
  if (within > kFew || within == values.size()) {
    return static_cast<double>(within) / static_cast<double>(values.size());
  }
  const std::size_t low = std::min(kFew, values.size() / 20);
  const std::size_t high = std::min(10 * low + 9, values.size() - 1);
  const auto at = [&](std::size_t rank) {
    return values.begin() + static_cast<std::ptrdiff_t>(rank);
  };
  std::nth_element(values.begin(), at(high), values.end());
  const double high_value = *at(high);
  std::nth_element(values.begin(), at(low), at(high));
  return Tail::through(*at(low), low, high_value, high, values.size()).share_within(radius);
}

Chance measure_chance(const problem::CallerCorrespondences& all, const problem::CallerPose& pose) {
  const Index n = all.size();
  if (n < 2) return {};
  const Index count = std::clamp(n / kCorrespondencesAPair, kLeastSample, kMostSample);
  const Similarity& transform = pose.similarity;
  const Eigen::Matrix3d linear = transform.scale * transform.rotation;
  std::vector<double> distances(static_cast<std::size_t>(count)), lengths;
  lengths.reserve(distances.size() / kPerLength + 1);
  // The source of one and the target of another: a random correspondence.
  Couple last = couple(0, n);
  for (std::size_t k = 0; k < distances.size(); ++k) {
    const auto [i, j] = couple(k + 1, n);
    const Eigen::Vector3d image = linear * all.source.col(i) + transform.translation;
    distances[k] = (all.target.col(j) - image).norm() / all.bounds[i];
    if (k % kPerLength == 0) {
      const double from = transform.scale * (all.source.col(i) - all.source.col(last.first)).norm();
      const double to = (all.target.col(j) - all.target.col(last.second)).norm();
      lengths.push_back(std::abs(to - from) / (all.bounds[i] + all.bounds[last.first]));
    }
    last = {i, j};
  }
  return {share_within(distances, 1), share_within(lengths, 1)};
}

double log10_false_alarms(double k, double n, int sample_size, int num_lengths,
                          const Chance& chance) {
  const double m = sample_size;
  if (k <= m) return n > m ? std::max(0.0, log10_choose(n, m)) : 0;
  return log10_choose(n, m) - log10_choose(k, m) + num_lengths * elementary::log10(chance.length) +
         log10_tail(k - m, n - m, chance.inlier);
}

}  // namespace gmcr::noise
