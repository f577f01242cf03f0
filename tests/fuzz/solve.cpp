// Matches and options of any numbers: a solve refuses them by name, or what it says is recounted.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/bytes.hpp"
#include "fuzz/target.hpp"
#include "gmcr/registration.hpp"

namespace gmcr::fuzz {
namespace {

using Eigen::Vector3d;

constexpr Index kMostMatches = 12;

struct Matches {
  Points source, target;
};

Vector3d point(Bytes& input) {
  const double x = input.number(), y = input.number(), z = input.number();
  return {x, y, z};
}

/// A similarity of small whole numbers.
Similarity small_pose(Bytes& input) {
  const auto whole = [&] { return static_cast<double>(input.raw<std::int8_t>()); };
  Similarity pose;
  const Eigen::Quaterniond turn(whole(), whole(), whole(), whole());
  if (turn.norm() > 0) pose.rotation = turn.normalized().toRotationMatrix();
  pose.translation = Vector3d(whole(), whole(), whole());
  return pose;
}

/// Images of the sources under one pose, but for those that are any numbers.
Matches matches_of(Bytes& input) {
  const auto n = static_cast<Index>(input.below(kMostMatches + 1));
  const Similarity pose = small_pose(input);
  Matches matches{Points(3, n), Points(3, n)};
  for (Index i = 0; i < n; ++i) {
    const std::size_t kind = input.below(4);
    if (kind == 0) {
      matches.source.col(i) = point(input);
      matches.target.col(i) = point(input);
      continue;
    }
    for (Index j = 0; j < 3; ++j) matches.source(j, i) = 0.25 * input.raw<std::int8_t>();
    matches.target.col(i) = pose * matches.source.col(i);
    if (kind == 1) matches.target(static_cast<Index>(input.below(3)), i) += input.number();
  }
  return matches;
}

void add_priors(Options& options, Bytes& input) {
  if (input.below(4) == 0) {
    options.gravity = GravityPrior{point(input), point(input), std::abs(input.number())};
  }
  if (input.below(4) == 0) {
    options.initial_pose =
        InitialPose{small_pose(input), std::abs(input.number()), std::abs(input.number())};
  }
  if (input.below(4) == 0) options.max_translation = input.number();
}

Options options_of(Bytes& input, Index num_matches) {
  Options options;
  const std::size_t noise = input.below(8);
  if (noise == 0) {
    for (Index i = 0; i < num_matches; ++i) {
      options.noise_bounds.push_back(0.01 * static_cast<double>(1 + input.below(255)));
    }
  } else if (noise == 1) {
    for (Index i = 0; i < num_matches; ++i) options.noise_bounds.push_back(input.number());
  } else if (noise == 2) {
    options.noise_mode = NoiseMode::Estimated;
  } else if (noise == 3) {
    options.noise_bound = input.number();
  } else {
    options.noise_bound = 0.01 * static_cast<double>(1 + input.below(255));
  }
  if (input.flag()) options.scale_mode = ScaleMode::Estimated;
  if (input.below(4) == 0) options.scale = input.number();
  if (input.below(4) == 0) options.scale_range = ScaleRange{input.number(), input.number()};
  if (input.below(4) == 0) options.method = Method::Paper;
  if (input.flag()) options.evidence = Evidence::Count;
  options.one_to_one = input.below(4) == 0;
  options.num_hypotheses = static_cast<int>(1 + input.below(3));
  options.certify = input.below(4) == 0;
  options.num_threads = static_cast<int>(1 + input.below(2));
  constexpr double kTimes[] = {1, 1, 1, 1e-3, 1e-6};
  options.time_limit = options.certify ? 0.05 : kTimes[input.below(std::size(kTimes))];
  if (input.below(8) == 0) options.memory_limit = 1 + input.raw<std::uint16_t>();
  add_priors(options, input);
  return options;
}

bool says(const Result& result, const std::string& words) {
  const auto& limits = result.diagnostics.limits_hit;
  return std::any_of(limits.begin(), limits.end(), [&](const LimitHit& hit) {
    return hit.sentence.find(words) != std::string::npos;
  });
}

/// Residuals of what is said to be within its bounds, by another formula than the library's.
void check_residuals(const Similarity& pose, const std::vector<Index>& inliers,
                     const Matches& matches, const Options& options) {
  for (const Index i : inliers) {
    const Vector3d a = matches.source.col(i), b = matches.target.col(i);
    const Vector3d moved = pose.scale * (pose.rotation * a);
    const double residual = (b - moved - pose.translation).stableNorm();
    const double bound = options.noise_bounds.empty()
                             ? options.noise_bound
                             : options.noise_bounds[static_cast<std::size_t>(i)];
    const double rounding = 1e-14 * (b.lpNorm<Eigen::Infinity>() + moved.lpNorm<Eigen::Infinity>() +
                                     pose.translation.lpNorm<Eigen::Infinity>());
    require(residual <= bound * (1 + 1e-9) + rounding, "inliers are within their bounds");
  }
}

/// The pose of three matches, nullopt where they do not say.
std::optional<Similarity> pose_of(const Matches& matches, const Index (&three)[3], double scale) {
  Points a(3, 3), b(3, 3);
  for (Index k = 0; k < 3; ++k) {
    a.col(k) = (scale > 0 ? scale : 1) * matches.source.col(three[k]);
    b.col(k) = matches.target.col(three[k]);
  }
  if (a.lpNorm<Eigen::Infinity>() > 1e6 || b.lpNorm<Eigen::Infinity>() > 1e6) return {};
  const Eigen::Matrix4d matrix = Eigen::umeyama(a, b, scale <= 0);
  if (!matrix.allFinite()) return {};
  Similarity pose;
  pose.scale = scale > 0 ? scale : std::cbrt(matrix.topLeftCorner<3, 3>().determinant());
  if (!(pose.scale > 1e-6)) return {};
  pose.rotation = matrix.topLeftCorner<3, 3>() / (scale > 0 ? 1 : pose.scale);
  pose.translation = matrix.topRightCorner<3, 1>();
  return pose;
}

/// The poses of all threes hold no more than the upper bounds say.
void check_upper_bounds(const Result& result, const Matches& matches, const Options& options) {
  const Certificate& certificate = result.certificate;
  const ScaleRange& scales = result.diagnostics.scale_range;
  const double scale = options.scale_mode == ScaleMode::Known ? options.scale : 0;
  const Index n = matches.source.cols();
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j) {
      for (Index k = j + 1; k < n; ++k) {
        const auto pose = pose_of(matches, {i, j, k}, scale);
        if (!pose || !options.admit(*pose)) continue;
        if (scale == 0 && (pose->scale < scales.min || pose->scale > scales.max)) continue;
        const Consensus consensus =
            evaluate_consensus(*pose, matches.source, matches.target, options);
        require(static_cast<Index>(consensus.inliers.size()) <= certificate.upper,
                "no pose has more inliers than the bound");
        require(consensus.evidence <= certificate.evidence.upper * (1 + 1e-9) + 1e-9,
                "no pose has more evidence than the bound");
      }
    }
  }
}

void check(const Result& result, const Matches& matches, Options options) {
  const Certificate& certificate = result.certificate;
  check_pose(result.target_from_source);
  check_pose(certificate.target_from_source);
  require(certificate.lower <= certificate.upper, "bounds in order");
  require(certificate.upper <= matches.source.cols(), "no more inliers than matches");
  require(certificate.lower == static_cast<Index>(certificate.inliers.size()), "lower is a count");
  require(certificate.certified == (certificate.lower == certificate.upper), "certified is a fact");
  require(result.status == Status::Ok || !result.status_reason.empty(), "a reason");
  if (result.status == Status::TooFewCorrespondences) return;
  if (options.noise_mode == NoiseMode::Estimated) {
    if (!result.noise_estimate) return;
    options.noise_mode = NoiseMode::Given;
    options.noise_bound = result.noise_estimate->noise_bound;
  }
  if (says(result, "inliers were counted")) options.evidence = Evidence::Count;
  check_residuals(result.target_from_source, result.inliers, matches, options);
  check_residuals(certificate.target_from_source, certificate.inliers, matches, options);
  if (certificate.lower > 0) {
    const Consensus again =
        evaluate_consensus(certificate.target_from_source, matches.source, matches.target, options);
    require(again.inliers == certificate.inliers, "lower is achieved");
    require(std::abs(again.evidence - certificate.evidence.lower) < 1e-9, "so is its evidence");
  }
  if (result.status == Status::Ok) {
    const Consensus again =
        evaluate_consensus(result.target_from_source, matches.source, matches.target, options);
    require(again.inliers == result.inliers, "the inliers are those of the pose");
    require(options.admit(result.target_from_source), "the priors hold");
  }
  for (const Alternative& alternative : result.alternatives) {
    check_pose(alternative.target_from_source);
    check_residuals(alternative.target_from_source, alternative.inliers, matches, options);
  }
  check_upper_bounds(result, matches, options);
}

}  // namespace

void solve(std::string_view bytes) {
  Bytes input(bytes);
  const Matches matches = matches_of(input);
  const Options options = options_of(input, matches.source.cols());
  Result result;
  try {
    result = register_correspondences(matches.source, matches.target, options);
  } catch (const std::invalid_argument& error) {
    require(std::string(error.what()).find(": ") != std::string::npos, "a refusal by name");
    return;
  }
  check(result, matches, options);
}

}  // namespace gmcr::fuzz
