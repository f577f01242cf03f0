#pragma once

#include <Eigen/Core>

namespace gmcr::estimation {

/// What the residuals near a pose say: right matches, whose noise is isotropic, among wrong ones
/// that are spread evenly.
///
/// A residual r_i, in parts of its noise bound, has the density
///   share f(r) + (1 - share) / V   for r <= kWindow, a ball of volume V, where
///   f(r) ~ sigma^-3 (1 + r^2 / (nu sigma^2))^(-(nu + 3) / 2)
/// is Student's t distribution in three dimensions with nu degrees of freedom: Gaussian to a few
/// per cent with many, of heavy tails with three. The parameters are found by expectation
/// maximisation (Dempster, Laird, Rubin 1977; Lange, Little, Taylor 1989).
class NoiseMixture {
 public:
  static constexpr double kWindow = 3;  ///< residuals up to so many bounds are looked at

  /// Nearly Gaussian, and of heavy tails: (nu + 3) / 2 is a power of two, or small, so that no
  /// function is needed whose last bit differs from machine to machine.
  enum class Tails { Light, Heavy };

  /// Parameters to start from, of residuals of which some are within their bound.
  /// @param squares  squared residuals over squared bounds, of those within the window.
  NoiseMixture(Tails tails, const Eigen::ArrayXd& squares);

  /// Of the noise of an axis, in squared bounds: sigma^2.
  double variance() const { return variance_; }
  double share() const { return share_; }  ///< of the right ones

  /// Of each residual: the probability that it is of a right match.
  Eigen::ArrayXd right(const Eigen::ArrayXd& squares) const;

  /// What a residual of a right match weighs in the likeliest fit: 1, less for large ones where
  /// tails are heavy.
  Eigen::ArrayXd weights(const Eigen::ArrayXd& squares) const;

  /// What the residuals of a right match say of its place, over what as many with Gaussian noise of
  /// that variance would.
  double information() const;

  /// Takes the likeliest parameters.
  /// @param right, weights  as above, from before the fit that left these squares.
  void update(const Eigen::ArrayXd& right, const Eigen::ArrayXd& weights,
              const Eigen::ArrayXd& squares);

  /// Logarithm of the likelihood, over that of only wrong ones.
  double log_likelihood(const Eigen::ArrayXd& squares) const;

 private:
  /// Density of right matches, times their share, over the one of wrong ones times theirs.
  Eigen::ArrayXd odds(const Eigen::ArrayXd& squares) const;

  int degrees_of_freedom_;
  double variance_ = 1, share_ = 1;
};

/// The mixture of the residuals of a pose that is given, of the tails that are likelier.
NoiseMixture fit_noise(const Eigen::ArrayXd& squares);

}  // namespace gmcr::estimation
