#include "digests/digest.hpp"

#include <bit>

namespace gmcr::bench {
namespace {

constexpr std::uint64_t kOffset = 0xcbf29ce484222325;
constexpr std::uint64_t kPrime = 0x100000001b3;

std::uint64_t fnv(std::uint64_t hash, std::uint64_t byte) { return (hash ^ byte) * kPrime; }

template <typename Matrix>
void add_matrix(Digest& digest, const Matrix& matrix) {
  digest.add(matrix.rows());
  digest.add(matrix.cols());
  for (Index column = 0; column < matrix.cols(); ++column) {
    for (Index row = 0; row < matrix.rows(); ++row) digest.add(double{matrix(row, column)});
  }
}

void add_indices(Digest& digest, const std::vector<Index>& indices) {
  digest.add(indices.size());
  for (const Index index : indices) digest.add(index);
}

void add_range(Digest& digest, const ScaleRange& range) {
  digest.add(range.min);
  digest.add(range.max);
}

void add_pose(Digest& digest, const Similarity& pose) {
  digest.add(pose.scale);
  add_matrix(digest, pose.rotation);
  add_matrix(digest, pose.translation);
}

void add_certificate(Digest& digest, const Certificate& certificate) {
  digest.add(certificate.lower);
  digest.add(certificate.upper);
  digest.add(certificate.certified);
  digest.add(certificate.evidence.lower);
  digest.add(certificate.evidence.upper);
  digest.add(certificate.evidence.certified);
}

void add_covariance(Digest& digest, const std::optional<Covariance>& covariance) {
  digest.add(covariance.has_value());
  if (!covariance) return;
  add_matrix(digest, covariance->matrix);
  add_matrix(digest, covariance->eigenvalues);
}

void add_alternatives(Digest& digest, const std::vector<Alternative>& alternatives) {
  digest.add(alternatives.size());
  for (const Alternative& alternative : alternatives) {
    add_pose(digest, alternative.target_from_source);
    add_indices(digest, alternative.inliers);
    digest.add(alternative.evidence);
  }
}

void add_noise(Digest& digest, const std::optional<NoiseEstimate>& noise) {
  digest.add(noise.has_value());
  if (!noise) return;
  digest.add(noise->noise_bound);
  digest.add(noise->stable_min);
  digest.add(noise->stable_max);
  digest.add(noise->log10_false_alarms);
}

void add_work(Digest& digest, const Diagnostics& diagnostics) {
  digest.add(diagnostics.num_correspondences);
  digest.add(diagnostics.num_used);
  add_range(digest, diagnostics.scale_range);
  digest.add(diagnostics.num_candidates);
  digest.add(diagnostics.num_scale_ranges);
  digest.add(diagnostics.num_clique_nodes);
  digest.add(diagnostics.limits_hit.size());
}

}  // namespace

void Digest::begin(std::string_view part) { parts_.push_back({std::string(part), kOffset}); }

void Digest::add(std::uint64_t word) {
  if (parts_.empty()) begin("all");
  for (int byte = 0; byte < 8; ++byte, word >>= 8) {
    hash_ = fnv(hash_, word & 0xff);
    parts_.back().hash = fnv(parts_.back().hash, word & 0xff);
  }
}

void Digest::add(double value) { add(std::bit_cast<std::uint64_t>(value)); }

void Digest::add(std::string_view text) {
  add(text.size());
  for (const char letter : text) add(static_cast<std::uint64_t>(letter));
}

void add(Digest& digest, const Result& result) {
  digest.begin("status");
  digest.add(std::string_view(to_string(result.status)));
  digest.begin("pose");
  add_pose(digest, result.target_from_source);
  digest.begin("inliers");
  add_indices(digest, result.inliers);
  digest.begin("evidence");
  digest.add(result.evidence);
  digest.begin("certificate");
  add_certificate(digest, result.certificate);
  digest.begin("consistent_scales");
  add_range(digest, result.consistent_scales);
  digest.begin("covariance");
  add_covariance(digest, result.covariance);
  digest.begin("alternatives");
  add_alternatives(digest, result.alternatives);
  digest.begin("noise_estimate");
  add_noise(digest, result.noise_estimate);
  digest.begin("work");
  add_work(digest, result.diagnostics);
}

void add(Digest& digest, const std::vector<Result>& results) {
  digest.begin("instances");
  digest.add(results.size());
  for (const Result& result : results) add(digest, result);
}

void add(Digest& digest, const Consensus& consensus) {
  digest.begin("consensus");
  add_indices(digest, consensus.inliers);
  digest.add(consensus.evidence);
}

void add(Digest& digest, const Uncertainty& uncertainty) {
  digest.begin("uncertainty");
  add_range(digest, uncertainty.consistent_scales);
  add_covariance(digest, uncertainty.covariance);
}

void add(Digest& digest, const CloudMatches& matches) {
  digest.begin("matches");
  add_matrix(digest, matches.source);
  add_matrix(digest, matches.target);
  add_indices(digest, matches.source_indices);
  add_indices(digest, matches.target_indices);
  add_matrix(digest, matches.source_voxels);
  add_matrix(digest, matches.target_voxels);
  digest.add(matches.source_voxel_size);
  digest.add(matches.target_voxel_size);
  digest.add(matches.noise_bound);
  digest.add(matches.filtered);
}

void add(Digest& digest, const CloudResult& result) {
  add(digest, result.registration);
  add(digest, result.matches);
  digest.begin("verdict");
  digest.add(std::string_view(to_string(result.verdict)));
  digest.add(result.num_source_points);
  digest.add(result.num_target_points);
  digest.add(result.fitness);
  digest.add(result.target_fitness);
  digest.add(result.distinct_evidence);
  digest.add(result.overlap_rmse);
  digest.add(result.num_attempts);
}

void add(Digest& digest, const CliqueResult& result) {
  digest.begin("clique");
  add_indices(digest, result.vertices);
  digest.add(result.upper_bound);
  digest.add(result.proven_optimal);
  digest.add(result.nodes);
}

void add(Digest& digest, const WeightedCliqueResult& result) {
  digest.begin("clique");
  add_indices(digest, result.vertices);
  digest.add(result.weight);
  digest.add(result.upper_bound);
  digest.add(result.proven_optimal);
  digest.add(result.nodes);
}

void add(Digest& digest, const SyntheticProblem& problem) {
  digest.begin("problem");
  add_matrix(digest, problem.source);
  add_matrix(digest, problem.target);
  add_pose(digest, problem.target_from_source);
  for (const bool is_inlier : problem.is_inlier) digest.add(is_inlier);
  digest.add(problem.noise_bound);
}

}  // namespace gmcr::bench
