"""The points that hold the pose of a pair."""

from __future__ import annotations

from typing import Any

import numpy as np

from .._gmcr import CloudResult
from ..io._cloud import import_extra
from ._motion import Matrix, move


def require_open3d() -> Any:
    """Open3D; ImportError with the extra where it is absent."""
    return import_extra("open3d", "multiview", "multiview")


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
