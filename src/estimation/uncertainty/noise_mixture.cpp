#include "estimation/uncertainty/noise_mixture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/elementary.hpp"
#include "gmcr/types.hpp"

namespace gmcr::estimation {
namespace {

constexpr int kLight = 61, kHeavy = 3;  // degrees of freedom
constexpr double kVolume = 4 * std::numbers::pi / 3 * NoiseMixture::kWindow *
                           NoiseMixture::kWindow * NoiseMixture::kWindow;
/// A noise bound is no larger than 20 standard deviations of the noise: else a few matches that
/// happen to agree would be taken for all that are right.
constexpr double kLeastVariance = 0.05 * 0.05;
constexpr double kMostShare = 0.999;

/// Gamma((nu + 3) / 2) / (Gamma(nu / 2) (nu pi)^(3/2)), for odd nu.
double normaliser(int nu) {
  // Gamma(z + 1) = z Gamma(z), from Gamma(1) = 1 and Gamma(1/2) = sqrt(pi)
  double ratio = 1 / std::sqrt(std::numbers::pi);
  for (int k = 1; 2 * k < nu + 3; ++k) ratio *= k;
  for (int k = 1; k < nu; k += 2) ratio /= k / 2.0;
  const double spread = nu * std::numbers::pi;
  return ratio / (spread * std::sqrt(spread));
}

/// base^exponent, in the order of its bits.
Eigen::ArrayXd power(Eigen::ArrayXd base, unsigned exponent) {
  Eigen::ArrayXd result = Eigen::ArrayXd::Ones(base.size());
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result *= base;
    base *= base;
  }
  return result;
}

}  // namespace

NoiseMixture::NoiseMixture(Tails tails, const Eigen::ArrayXd& squares)
    : degrees_of_freedom_(tails == Tails::Light ? kLight : kHeavy) {
  const auto within = squares <= 1;
  const auto count = static_cast<double>(within.count());
  if (count == 0) return;
  variance_ = std::max(kLeastVariance, within.select(squares, 0).sum() / (3 * count));
  share_ = std::min(kMostShare, count / static_cast<double>(squares.size()));
}

Eigen::ArrayXd NoiseMixture::odds(const Eigen::ArrayXd& squares) const {
  const double nu = degrees_of_freedom_;
  const double factor = share_ / (1 - share_) * kVolume * normaliser(degrees_of_freedom_) /
                        (variance_ * std::sqrt(variance_));
  return factor *
         power((1 + squares / (nu * variance_)).inverse(), static_cast<unsigned>((nu + 3) / 2));
}

Eigen::ArrayXd NoiseMixture::right(const Eigen::ArrayXd& squares) const {
  const Eigen::ArrayXd odds = this->odds(squares);
  return odds / (1 + odds);
}

Eigen::ArrayXd NoiseMixture::weights(const Eigen::ArrayXd& squares) const {
  const double nu = degrees_of_freedom_;
  return (nu + 3) / (nu + squares / variance_);
}

double NoiseMixture::information() const {
  const double nu = degrees_of_freedom_;
  return (nu + 3) / (nu + 5);
}

void NoiseMixture::update(const Eigen::ArrayXd& right, const Eigen::ArrayXd& weights,
                          const Eigen::ArrayXd& squares) {
  const double sum = right.sum();
  if (!(sum > 0)) return;
  variance_ = std::max(kLeastVariance, (right * weights * squares).sum() / (3 * sum));
  share_ = std::min(kMostShare, sum / static_cast<double>(squares.size()));
}

double NoiseMixture::log_likelihood(const Eigen::ArrayXd& squares) const {
  // the logarithm of a few factors together
  constexpr Index kTogether = 8;
  const Eigen::ArrayXd factors = (1 - share_) * (1 + odds(squares));
  double sum = 0;
  for (Index begin = 0; begin < factors.size(); begin += kTogether) {
    sum +=
        elementary::log(factors.segment(begin, std::min(kTogether, factors.size() - begin)).prod());
  }
  return sum;
}

NoiseMixture fit_noise(const Eigen::ArrayXd& squares) {
  constexpr int kMaxUpdates = 50;
  constexpr double kSettled = 1e-3;
  const auto fit = [&](NoiseMixture::Tails tails) {
    NoiseMixture noise(tails, squares);
    for (int updates = 0; updates < kMaxUpdates; ++updates) {
      const double before = noise.variance();
      noise.update(noise.right(squares), noise.weights(squares), squares);
      if (std::abs(noise.variance() - before) <= kSettled * before) break;
    }
    return noise;
  };
  const NoiseMixture light = fit(NoiseMixture::Tails::Light);
  const NoiseMixture heavy = fit(NoiseMixture::Tails::Heavy);
  return heavy.log_likelihood(squares) > light.log_likelihood(squares) ? heavy : light;
}

}  // namespace gmcr::estimation
