#pragma once

#include "gmcr/frontend.hpp"
#include "gmcr/result.hpp"

namespace gmcr::test {

/// A result whose fields all differ from their defaults and from each other.
inline Result make_result() {
  Result result;
  result.status = Status::Ok;
  result.target_from_source.scale = 2;
  result.target_from_source.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  result.target_from_source.translation << 1, 2, 3;
  result.inliers = {1, 4, 7};
  result.evidence = 2.5;
  result.verdict = Verdict::Trusted;
  result.verdict_reason = "chance would give this once in 10^9";
  result.log10_false_alarms = -9.5;
  result.certificate = {4, 5, false, {3.25, 4.5, false}, {}, {1, 4, 6, 7}};
  result.certificate.target_from_source = result.target_from_source;
  result.certificate.target_from_source.translation << 1.5, 2, 3;
  result.consistent_scales = {1.9, 2.1};
  result.covariance =
      Covariance{1e-4 * Eigen::MatrixXd::Identity(7, 7), 1e-3 * Eigen::VectorXd::Ones(7)};
  Alternative alternative;
  alternative.target_from_source.scale = 3;
  alternative.inliers = {0, 2};
  alternative.evidence = 1.5;
  result.alternatives = {alternative};
  Diagnostics& diagnostics = result.diagnostics;
  diagnostics.stages = {{"graph", 0.25}, {"clique", 1.5}};
  diagnostics.total_seconds = 2;
  diagnostics.num_correspondences = 10;
  diagnostics.num_used = 9;
  diagnostics.scale_range = {0.5, 4};
  diagnostics.num_candidates = 11;
  diagnostics.num_scale_ranges = 12;
  diagnostics.num_clique_nodes = 13;
  diagnostics.num_threads = 14;
  diagnostics.limits_hit = {{Limit::Time, "the time budget ended the search"},
                            {Limit::CliqueSearch, "a clique search ended before its proof"}};
  return result;
}

inline CloudResult make_cloud_result() {
  CloudResult result;
  result.registration = make_result();
  result.matches.source = result.matches.target = Points::Zero(3, 10);
  result.matches.source_voxels = Points::Zero(3, 20);
  result.matches.target_voxels = Points::Zero(3, 30);
  result.matches.source_voxel_size = 0.25;
  result.matches.target_voxel_size = 0.5;
  result.matches.noise_bound = 0.75;
  result.num_source_points = 200;
  result.num_target_points = 300;
  result.fitness = 0.6;
  result.target_fitness = 0.7;
  result.overlap_rmse = 0.1;
  result.verdict = Verdict::Doubtful;
  result.verdict_reason = "few matches agree";
  result.num_attempts = 3;
  result.refinement = {"icp", true, "ICP turned the pose", 0.02};
  WeakDirection shift;
  shift.shift = {0, 1, 0};
  shift.stiffness = 0.001;
  result.surfaces = {0.5, 0.4, 0.9, 0.03, {shift}};
  result.rivals = {{Similarity{}, 0.95, true}};
  result.notes = {"the source is far away"};
  return result;
}

}  // namespace gmcr::test
