// Matches of a learned method, with confidences: surer ones localise better, so each has a noise
// bound of its own, and the pose is only used where the verdict says that chance does not explain
// it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "gmcr/registration.hpp"

namespace {

constexpr double kNoiseBound = 0.01;  // metres, of a match of confidence 1
constexpr double kLeastConfidence = 0.2;

/// What a network may give: matches with a confidence each.
struct LearnedMatches {
  gmcr::Points source, target;
  std::vector<double> confidences;
};

LearnedMatches make_matches(gmcr::Index num, gmcr::Index num_right) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  LearnedMatches made{gmcr::Points(3, num), gmcr::Points(3, num), {}};
  const auto point = [&] {
    return Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
  };
  for (gmcr::Index i = 0; i < num; ++i) {
    const bool is_right = i < num_right;
    made.source.col(i) = point();
    made.target.col(i) =
        is_right ? Eigen::Vector3d(made.source.col(i) + Eigen::Vector3d(1, 0, 2) + 0.005 * point())
                 : point();
    made.confidences.push_back((is_right ? 0.7 : 0.4) + 0.3 * uniform(random));
  }
  return made;
}

/// The pose from the matches that are sure enough.
gmcr::Result solve(const LearnedMatches& matches) {
  std::vector<gmcr::Index> kept;
  gmcr::Options options;
  for (std::size_t i = 0; i < matches.confidences.size(); ++i) {
    if (matches.confidences[i] < kLeastConfidence) continue;
    kept.push_back(static_cast<gmcr::Index>(i));
    options.noise_bounds.push_back(kNoiseBound / std::sqrt(std::min(1.0, matches.confidences[i])));
  }
  return gmcr::register_correspondences(matches.source(Eigen::all, kept),
                                        matches.target(Eigen::all, kept), options);
}

}  // namespace

int main() {
  const gmcr::Result result = solve(make_matches(500, 100));
  std::printf("%s: %s\n", to_string(result.verdict), result.verdict_reason.c_str());
  return result.verdict == gmcr::Verdict::Trusted && result.inliers.size() >= 90 ? 0 : 1;
}
