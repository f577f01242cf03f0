"""One cloud from many scans."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from .._arguments import CloudLike, PoseLike, as_cloud, as_pose
from .._clouds import voxel_grid
from ._motion import move


def merge_scans(
    scans: Sequence[CloudLike],
    poses: Sequence[PoseLike | None],
    voxel_size: float,
) -> npt.NDArray[np.float64]:
    """The scans in one frame, averaged in each voxel.

    Parameters
    ----------
    scans : sequence of array_like, shape (N_i, 3), or paths
        Points, metres, finite.
    poses : sequence of array_like, shape (4, 4), or None
        One a scan, as ``MultiviewResult.poses``; scans without one are left out.
    voxel_size : float
        Edge of a voxel, metres, > 0.

    Returns
    -------
    ndarray, shape (M, 3)
        Means of the points of each occupied voxel.

    Raises
    ------
    ValueError
        where the numbers of scans and poses differ, or no scan has a pose.
    """
    if len(scans) != len(poses):
        raise ValueError(f"poses: {len(poses)} for {len(scans)} scans")
    placed = [
        move(as_cloud(scan, f"scans[{index}]"), as_pose(pose).matrix())
        for index, (scan, pose) in enumerate(zip(scans, poses, strict=True))
        if pose is not None
    ]
    if not placed:
        raise ValueError("poses: none is given")
    return voxel_grid(np.concatenate(placed), voxel_size)
