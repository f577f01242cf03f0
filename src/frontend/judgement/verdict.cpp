#include "frontend/judgement/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace gmcr::frontend {
namespace {

// Mutual matches that agree: at most 20 in wrong poses of real pairs, at least 38 in right ones.
constexpr Index kChanceInliers = 12;
constexpr Index kTrustedInliers = 30;
// The same of pooled matches, of which a point may have several.
constexpr Index kTrustedPooled = 60;
constexpr Index kChancePooled = 24;
// Their distinct evidence, which a loose noise bound does not swell: at most 2.4 and at least 5.8.
constexpr double kTrustedEvidence = 4.5;
// Shares of a cloud that the other covers.
constexpr double kLeastCoverage = 0.2;
constexpr double kPlausibleCoverage = 0.5;
// Share of a view that its object covers, of the poses from all around the one without rivals: at
// least 0.67 in right ones, at most 0.61 in wrong ones.
constexpr double kCoveredView = 0.64;
// What meets in right poses has normals that agree to 0.6 and more, and lies within 0.158 voxels;
// mirrored clouds, whose wrong poses have up to 85 inliers, lie 0.164 to 0.29 apart.
constexpr double kLeastAgreement = 0.5;
constexpr double kMostNoise = 0.16;
// The same where the mirrored source was tried and is worse: noisy depth cameras leave up to 0.2.
constexpr double kMostNoiseOfSensor = 0.25;
// Of a cloud, what the other sensor saw through: 0.005 at most in right poses whose views are
// known; wrong ones have 0.016 and more, with an evidence of up to 25.
constexpr double kMostContradicted = 0.018;
constexpr double kBeyondDoubt = 30;
// Bare ground leaves three motions open, a corridor or an edge one.
constexpr std::size_t kFewWeak = 1;

/// "a turn about (0, 0, 1)".
std::string words_of(const WeakDirection& direction) {
  const bool is_turn = !direction.turn.isZero(0);
  const Eigen::Vector3d& axis = is_turn ? direction.turn : direction.shift;
  std::ostringstream words;
  const auto rounded = [](double value) { return std::round(100 * value) / 100 + 0.0; };  // no -0
  words << (is_turn ? "a turn about (" : "a shift along (") << rounded(axis.x()) << ", "
        << rounded(axis.y()) << ", " << rounded(axis.z()) << ")";
  return words.str();
}

/// The words, with commas and an "and".
std::string list_of(const std::vector<std::string>& words) {
  std::string list;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) list += k + 1 == words.size() ? " and " : ", ";
    list += words[k];
  }
  return list;
}

/// A verdict and why; the worst of several counts.
struct Opinion {
  Verdict verdict = Verdict::Trusted;
  std::string reason;
};

/// What the matches say.
Opinion by_matches(const CloudResult& result, bool mirrored_is_worse) {
  const bool all_matches = !result.matches.filtered;
  const bool are_pooled = result.matches.num_radii > 1;
  const Index least = are_pooled ? kTrustedPooled : kTrustedInliers;
  const auto num_inliers = static_cast<Index>(result.registration.inliers.size());
  const double coverage = std::max(result.fitness, result.target_fitness);
  const std::string count = std::to_string(num_inliers) + " of " +
                            std::to_string(result.matches.source.cols()) + " matches agree";
  const std::string meet =
      std::to_string(std::lround(100 * coverage)) + " % of a cloud meets the other";
  // where the matches say nothing, the cover may
  const bool may_be_covered = all_matches || result.found_by_turning;
  const bool is_chance = all_matches || num_inliers < (are_pooled ? kChancePooled : kChanceInliers);
  if (is_chance && !(may_be_covered && coverage >= kPlausibleCoverage)) {
    return {Verdict::Untrusted, count + " and " + meet + ", which chance explains"};
  }
  if (result.found_by_turning && num_inliers < least) {
    const double share = result.surfaces.target_share;
    if (share < kCoveredView || !mirrored_is_worse) {
      return {Verdict::Doubtful, "found by its surface, not by matches: " + meet};
    }
    return {Verdict::Trusted, "turned all around, the source covers " +
                                  std::to_string(std::lround(100 * share)) +
                                  " % of the target in this pose alone"};
  }
  if (all_matches || num_inliers < least || result.distinct_evidence < kTrustedEvidence ||
      coverage < kLeastCoverage) {
    return {Verdict::Doubtful, "only " + count + " and " + meet};
  }
  return {Verdict::Trusted, count + " and " + meet};
}

/// What the surfaces leave open.
Opinion by_weak_directions(const CloudResult& result) {
  std::vector<std::string> words;
  for (const WeakDirection& direction : result.surfaces.weak_directions) {
    words.push_back(words_of(direction));
  }
  if (words.empty()) return {};
  const Verdict verdict = words.size() > kFewWeak ? Verdict::Untrusted : Verdict::Doubtful;
  return {verdict, "the surfaces leave open " + list_of(words)};
}

/// How closely the surfaces meet.
Opinion by_surfaces(const CloudResult& result, bool mirrored_is_worse) {
  const SurfaceFit& fit = result.surfaces;
  if (fit.agreement < kLeastAgreement) {
    return {Verdict::Doubtful, "the normals of what meets agree in " +
                                   std::to_string(std::lround(100 * fit.agreement)) + " % alone"};
  }
  const double most = mirrored_is_worse ? kMostNoiseOfSensor : kMostNoise;
  if (fit.noise > most * result.voxels.target_voxel_size) {
    return {Verdict::Doubtful, "the surfaces that meet lie apart"};
  }
  return {};
}

/// Whether one of the clouds is left-handed.
Opinion by_handedness(const CloudResult& result) {
  if (!result.mirrored_is_better) return {};
  return {Verdict::Doubtful, "the mirrored source meets the target better"};
}

/// What the sensors saw.
Opinion by_free_space(const CloudResult& result) {
  const double share = result.surfaces.contradicted;
  // a map, or a model, may hold what was carried away since
  const bool are_views = result.voxels.source_viewpoint && result.voxels.target_viewpoint;
  if (!are_views || share <= kMostContradicted || result.distinct_evidence >= kBeyondDoubt) {
    return {};
  }
  return {Verdict::Doubtful, std::to_string(std::lround(100 * share)) +
                                 " % of a cloud lie where the other sensor saw through"};
}

/// Whether other poses do as well.
Opinion by_rivals(const CloudResult& result) {
  if (result.rivals.empty()) return {};
  const std::size_t count = result.rivals.size();
  const bool are_symmetries = std::all_of(result.rivals.begin(), result.rivals.end(),
                                          [](const RivalPose& rival) { return rival.is_symmetry; });
  return {Verdict::Doubtful,
          "ambiguous: the surfaces meet about as well at " + std::to_string(count) +
              (count == 1 ? " other pose" : " other poses") +
              (are_symmetries ? ", where a symmetry of the source puts it" : "")};
}

Opinion opinion_on(const CloudResult& result, bool mirrored_is_worse) {
  const Result& registration = result.registration;
  if (registration.status != Status::Ok) {
    const bool has_pose = registration.status == Status::Degenerate;
    return {Verdict::Untrusted, (has_pose ? "the pose is one of many: " : "there is no pose: ") +
                                    registration.status_reason};
  }
  Opinion all = by_matches(result, mirrored_is_worse);
  for (const Opinion& opinion :
       {by_weak_directions(result), by_rivals(result), by_handedness(result), by_free_space(result),
        by_surfaces(result, mirrored_is_worse)}) {
    if (opinion.verdict == Verdict::Trusted) continue;
    all.verdict = std::max(all.verdict, opinion.verdict);
    all.reason += "; " + opinion.reason;
  }
  return all;
}

}  // namespace

bool awaits_mirrored(const CloudResult& result) {
  return result.registration.status == Status::Ok && !result.mirrored_is_worse &&
         opinion_on(result, false).verdict == Verdict::Doubtful &&
         opinion_on(result, true).verdict == Verdict::Trusted;
}

void judge(CloudResult& result) {
  const Opinion opinion = opinion_on(result, result.mirrored_is_worse);
  result.verdict = opinion.verdict;
  result.verdict_reason = opinion.reason;
}

}  // namespace gmcr::frontend
