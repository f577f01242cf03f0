"""Finer poses of pairs, by Open3D's ICP, and the points that hold them."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._arguments import as_pose
from .._clouds import voxel_grid, with_pose
from .._gmcr import CloudResult, Options
from ..io._cloud import import_extra
from ._motion import Matrix, move

# ICP runs on cells of half a voxel: surfaces that overlap little hold a pose no closer than that.
_CELL = 0.5  # voxels of the target, as all lengths here
_DISTANCES = (2.0, 1.0, 0.5)  # catching first, then fitting closely
_NORMAL_RADIUS = 1.5
_NORMAL_NEIGHBOURS = 30
_MAX_ITERATIONS = 30
# A pose that loses more than this is another pose, not a finer one.
_LEAST_FITNESS_KEPT = 0.98
_LEAST_INLIERS_KEPT = 0.8


def require_open3d() -> Any:
    """Open3D; ImportError with the extra where it is absent."""
    return import_extra("open3d", "multiview", "multiview")


def refine_by_icp(
    result: CloudResult, source: Matrix, target: Matrix, options: Options
) -> CloudResult:
    """The result at the pose that point-to-plane ICP between its clouds leads to.

    It stays as it is where that pose would lose overlap or inliers, or leave what the priors admit.
    """
    open3d = require_open3d()
    registration = open3d.pipelines.registration
    voxel = result.matches.target_voxel_size
    cells = [_to_open3d(voxel_grid(cloud, _CELL * voxel)) for cloud in (source, target)]
    cells[1].estimate_normals(
        open3d.geometry.KDTreeSearchParamHybrid(_NORMAL_RADIUS * voxel, _NORMAL_NEIGHBOURS)
    )
    pose = result.matrix()
    for distance in _DISTANCES:
        pose = registration.registration_icp(
            *cells,
            distance * voxel,
            pose,
            registration.TransformationEstimationPointToPlane(),
            registration.ICPConvergenceCriteria(max_iteration=_MAX_ITERATIONS),
        ).transformation
    if not options.admit(as_pose(pose)):
        return result
    refined = with_pose(result, pose, options)
    keeps_inliers = len(refined.registration.inliers) >= max(
        3, _LEAST_INLIERS_KEPT * len(result.registration.inliers)
    )
    keeps_overlap = refined.fitness >= _LEAST_FITNESS_KEPT * result.fitness
    return refined if keeps_inliers and keeps_overlap else result


def overlap_of(result: CloudResult) -> Matrix:
    """The voxels of the source that meet the target, (n, 3), source frame, metres."""
    moved = move(result.matches.source_voxels, result.matrix())
    target = _to_open3d(result.matches.target_voxels)
    distances = _to_open3d(moved).compute_point_cloud_distance(target)
    meets = np.asarray(distances) <= result.matches.target_voxel_size
    return result.matches.source_voxels[meets]


def _to_open3d(points: Matrix) -> Any:
    open3d = require_open3d()
    return open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points.copy()))
