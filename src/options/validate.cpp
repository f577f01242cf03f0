#include <Eigen/LU>

#include "options/check.hpp"
#include "options/words.hpp"

namespace gmcr {
namespace options {
namespace {

bool is_rotation(const Eigen::Matrix3d& matrix) {
  constexpr double kTolerance = 1e-6;
  return matrix.allFinite() && matrix.determinant() > 0 &&
         (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <=
             kTolerance;
}

/// The noise is given once, or not at all where it is to be estimated.
void check_noise(const Options& o) {
  if (o.noise_mode == NoiseMode::Estimated) {
    require(o.noise_bound == 0, "noise_bound", o.noise_bound, "is given, but is to be estimated");
    require(o.noise_bounds.empty(), "noise_bounds", o.noise_bounds.size(),
            "values are given, but the noise is to be estimated");
  } else if (o.noise_bounds.empty()) {
    check("noise_bound", o.noise_bound, kMagnitude);
  } else {
    require(o.noise_bound == 0, "noise_bound", o.noise_bound,
            "must be 0 where noise_bounds is given");
  }
}

void check_scale(const Options& o) {
  if (o.scale_mode == ScaleMode::Estimated) {
    require(o.scale == 1, "scale", o.scale, "is given, but the scale is to be estimated");
  } else if (o.scale_range) {
    throw InvalidOption("scale_range", "is given, but the scale is known");
  }
}

/// What the method of the paper does not have.
void check_method(const Options& o) {
  if (o.method != Method::Paper) return;
  const std::string method = std::string("but method '") + word_of(o.method) + "' ";
  require(o.num_hypotheses == 1, "num_hypotheses", o.num_hypotheses,
          "are asked for, " + method + "finds one");
  if (o.certify)
    throw InvalidOption("certify", "is asked for, " + method + "has no search for a proof");
}

}  // namespace

void check(const std::string& name, const ScaleRange& range, const Range&) {
  check(name + ".min", range.min, kMagnitude);
  check(name + ".max", range.max, kMagnitude);
  require(range.min <= range.max, name + ".min", range.min, "exceeds " + name + ".max");
}

void check(const std::string& name, const Similarity& pose, const Range&) {
  require(is_rotation(pose.rotation), name + ".rotation", pose.rotation,
          "is not orthonormal with determinant 1");
  check(name + ".translation", pose.translation, kPlace);
}

}  // namespace options

void Options::validate() const {
  options::check_noise(*this);
  options::check_ranges(*this);
  options::check_scale(*this);
  options::check_method(*this);
}

void Priors::validate() const {
  if (gravity) options::check_ranges(*gravity, "gravity.");
  if (initial_pose) options::check_ranges(*initial_pose, "initial_pose.");
  options::check("max_translation", max_translation, options::kReach);
}

void InstanceOptions::validate() const { options::check_ranges(*this); }

void FrontendOptions::validate() const {
  options::check_ranges(*this);
  options::require(feature_radius >= normal_radius, "feature_radius", feature_radius,
                   "is below normal_radius");
}

}  // namespace gmcr
