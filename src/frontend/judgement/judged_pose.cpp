#include "frontend/judgement/judged_pose.hpp"

#include <utility>

#include "frontend/alignment/surface_fit.hpp"
#include "frontend/judgement/free_space.hpp"
#include "frontend/judgement/overlap.hpp"
#include "frontend/judgement/verdict.hpp"
#include "gmcr/registration.hpp"

namespace gmcr {
namespace frontend {
namespace {

constexpr Index kSamples = 2500;  // of each cloud, for how the surfaces meet

double distinct_evidence(const CloudMatches& matches, const Similarity& pose,
                         const Options& options) {
  Options distinct = options_with_bound(options, matches);
  distinct.evidence = Evidence::Distinct;
  return evaluate_consensus(pose, matches.source, matches.target, distinct).evidence;
}

/// How the voxels of the two clouds meet under the pose, both ways.
void measure_fit(CloudResult& result, CentredPair& voxels, const Options& options) {
  const Similarity& pose = result.registration.target_from_source;
  const double radius = result.voxels.target_voxel_size;
  const Similarity centred = voxels.centred(pose);
  const Overlap forward =
      measure_overlap(voxels.source, voxels.target, centred, radius, options.num_threads);
  const Overlap backward = measure_overlap(voxels.target, voxels.source, centred.inverse(),
                                           radius / pose.scale, options.num_threads);
  result.fitness = forward.fitness;
  result.overlap_rmse = forward.rmse;
  result.target_fitness = backward.fitness;
  result.surfaces = measure_surfaces(voxels, pose, radius, kSamples, options.num_threads);
  result.surfaces.contradicted =
      measure_contradiction(voxels, pose, radius, kSamples, options.num_threads);
}

/// The result with another pose, judged on these voxels.
CloudResult repose(CloudResult result, const Similarity& target_from_source, CentredPair& voxels,
                   const Options& options) {
  Result& registration = result.registration;
  const Options solver = options_with_bound(options, result.matches);
  Consensus consensus =
      evaluate_consensus(target_from_source, result.matches.source, result.matches.target, solver);
  Uncertainty uncertainty = evaluate_uncertainty(target_from_source, result.matches.source,
                                                 result.matches.target, consensus.inliers, solver);
  registration.target_from_source = target_from_source;
  result.distinct_evidence = options.evidence == Evidence::Distinct
                                 ? consensus.evidence
                                 : distinct_evidence(result.matches, target_from_source, options);
  registration.inliers = std::move(consensus.inliers);
  registration.evidence = consensus.evidence;
  registration.consistent_scales = uncertainty.consistent_scales;
  registration.covariance = std::move(uncertainty.covariance);
  measure_fit(result, voxels, options);
  judge(result);
  return result;
}

}  // namespace

Options options_with_bound(const Options& options, const CloudMatches& matches) {
  Options given = options;
  given.noise_mode = NoiseMode::Given;
  given.noise_bound = matches.noise_bound;
  return given;
}

std::shared_ptr<CentredPair> centred_pair(const JudgedVoxels& voxels, int num_threads) {
  if (voxels.source.cols() == 0 || voxels.target.cols() == 0) return nullptr;
  return std::make_shared<CentredPair>(voxels.source, voxels.target, voxels.source_voxel_size,
                                       voxels.target_voxel_size, num_threads);
}

double evidence_of(const CloudResult& result, const Candidate& candidate, const Options& options) {
  return distinct_evidence(result.matches, candidate.target_from_source, options);
}

void judge_pose(CloudResult& result, CentredPair& voxels, const Options& options) {
  measure_fit(result, voxels, options);
  result.distinct_evidence =
      distinct_evidence(result.matches, result.registration.target_from_source, options);
  judge(result);
}

CloudResult take(CloudResult result, const Candidate& candidate, CentredPair& voxels,
                 const Options& options) {
  result = repose(std::move(result), candidate.target_from_source, voxels, options);
  result.refinement.is_applied = result.refinement.is_applied || candidate.is_refined;
  if (candidate.is_refined) result.refinement.noise = candidate.noise;
  return result;
}

}  // namespace frontend

CloudResult with_pose(CloudResult result, const Similarity& target_from_source,
                      const Options& options) {
  const auto voxels = frontend::centred_pair(result.voxels, options.num_threads);
  if (!voxels) throw std::invalid_argument("result: it has no clouds");
  const Similarity& own = result.registration.target_from_source;
  if (target_from_source.matrix() == own.matrix()) return result;
  result.found_by_turning = false;
  // without the clouds what their sensors saw is not known; what they said before is not forgotten
  const double contradicted = result.surfaces.contradicted;
  result = frontend::repose(std::move(result), target_from_source, *voxels, options);
  result.surfaces.contradicted = contradicted;
  frontend::judge(result);
  return result;
}

}  // namespace gmcr
