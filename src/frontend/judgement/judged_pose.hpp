#pragma once

#include <memory>

#include "frontend/judgement/surface_judge.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {

/// Options to solve with, or to judge a pose with: by then the bound is known.
Options options_with_bound(const Options& options, const CloudMatches& matches);

/// The voxels in frames at their centroids; null where there are none of one cloud.
std::shared_ptr<CentredPair> centred_pair(const JudgedVoxels& voxels, int num_threads);

/// Measures how the voxel clouds meet under the pose of `result`, what the inliers are worth, and
/// judges the pose by both.
/// @param voxels  `centred_pair` of its voxels.
void judge_pose(CloudResult& result, CentredPair& voxels, const Options& options);

/// Distinct evidence of the matches of `result` for the pose of a candidate.
double evidence_of(const CloudResult& result, const Candidate& candidate, const Options& options);

/// `with_pose` at the pose of a candidate, which may have been refined.
CloudResult take(CloudResult result, const Candidate& candidate, CentredPair& voxels,
                 const Options& options);

}  // namespace gmcr::frontend
