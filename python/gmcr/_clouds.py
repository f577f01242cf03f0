"""Poses and matches of clouds."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _gmcr
from ._arguments import PoseLike, as_options, as_points, as_pose, split_options
from ._gmcr import CloudMatches, CloudResult, FrontendOptions, Options


def register_clouds(
    source: npt.ArrayLike,
    target: npt.ArrayLike,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    **keywords: Any,
) -> CloudResult:
    """Pose that aligns two clouds, from no initial guess.

    Voxel grid, normals, FPFH, nearest neighbours in feature space, ``register_correspondences``,
    the refinement of ``refine``, and a verdict from the inliers and from how the surfaces meet.
    Where the verdict is not ``'trusted'``, other settings of the front end are tried, and the poses
    of all are compared by their surfaces.

    Parameters
    ----------
    source : array_like, shape (N, 3)
        Points, metres, finite.
    target : array_like, shape (M, 3)
        Points, metres, finite.
    frontend : FrontendOptions, optional
        How clouds become correspondences; voxel sizes come from the data by default.
    options : Options, optional
        For the solver; ``noise_bound`` 0 takes the bound from the voxel size.
    **keywords
        Fields of ``Options`` and ``FrontendOptions``, instead of these.

    Returns
    -------
    CloudResult
        Registration, matches, fitness and verdict.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, or an option out of range.
    """
    matching, solver = split_options(FrontendOptions, frontend, options, keywords)
    return _gmcr.register_clouds(
        as_points(source, "source"), as_points(target, "target"), matching, solver
    )


def match(
    source: npt.ArrayLike,
    target: npt.ArrayLike,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    **keywords: Any,
) -> CloudMatches:
    """Correspondences between two clouds by FPFH: the front end of ``register_clouds`` alone.

    Parameters
    ----------
    source : array_like, shape (N, 3)
        Points, metres, finite.
    target : array_like, shape (M, 3)
        Points, metres, finite.
    frontend : FrontendOptions, optional
        How clouds become correspondences.
    options : Options, optional
        ``scale_mode``, ``scale``, ``noise_bound``, ``one_to_one`` and ``num_threads`` are read.
    **keywords
        Fields of ``Options`` and ``FrontendOptions``, instead of these.

    Returns
    -------
    CloudMatches
        Matched points, their indices, the clouds after the voxel grid.
    """
    matching, solver = split_options(FrontendOptions, frontend, options, keywords)
    return _gmcr.match_clouds(
        as_points(source, "source"), as_points(target, "target"), matching, solver
    )


def refine_clouds(
    result: CloudResult,
    source: npt.ArrayLike,
    target: npt.ArrayLike,
    options: Options | None = None,
    **keywords: Any,
) -> CloudResult:
    """The result at the pose near its own at which the surfaces of the clouds meet best.

    What ``register_clouds`` does with its pose unless ``refine='none'``: for a pose from elsewhere,
    or for an alternative.

    Parameters
    ----------
    result : CloudResult
        Of ``register_clouds`` or ``with_pose``.
    source, target : array_like, shape (N, 3) and (M, 3)
        The clouds that it is of, metres, finite.
    options, **keywords
        Those that the result was computed with; ``time_limit`` ends the refinement.

    Returns
    -------
    CloudResult
        As it was where it has no pose, or the surfaces meet best there.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, or an option out of range.
    """
    return _gmcr.refine_clouds(
        result,
        as_points(source, "source"),
        as_points(target, "target"),
        as_options(Options, options, keywords),
    )


def with_pose(
    result: CloudResult,
    target_from_source: PoseLike,
    options: Options | None = None,
    **keywords: Any,
) -> CloudResult:
    """The result with another pose in place of its own, such as a refined one.

    Parameters
    ----------
    result : CloudResult
        Of ``register_clouds``.
    target_from_source : Similarity, Result or array_like, shape (4, 4)
        The pose.
    options, **keywords
        Those that the result was computed with.

    Returns
    -------
    CloudResult
        Inliers, certificate, fitness and verdict are those of the new pose.
    """
    return _gmcr.with_pose(
        result, as_pose(target_from_source), as_options(Options, options, keywords)
    )


def voxel_grid(points: npt.ArrayLike, voxel_size: float) -> npt.NDArray[np.float64]:
    """Mean of the points in each occupied cell of a cubic grid.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        Metres, finite.
    voxel_size : float
        Edge of a cell, metres, > 0.

    Returns
    -------
    ndarray, shape (M, 3)
        M <= N, in the order of the cells.
    """
    if not 0 < voxel_size < np.inf:
        raise ValueError(f"voxel_size: {voxel_size} is not positive and finite")
    array = as_points(points, "points")
    if not np.isfinite(array).all():
        raise ValueError("points: not all are finite")
    return _gmcr.voxel_grid(array, voxel_size)


def fpfh(
    points: npt.ArrayLike,
    *,
    voxel_size: float,
    frontend: FrontendOptions | None = None,
    num_threads: int = 0,
) -> npt.NDArray[np.float32]:
    """Fast point feature histograms (Rusu, Blodow and Beetz, ICRA 2009) of all points.

    Parameters
    ----------
    points : array_like, shape (N, 3)
        Metres, finite; best after ``voxel_grid``.
    voxel_size : float
        Unit of the radii of ``frontend``, metres: the edge of the voxels, or the spacing.
    frontend : FrontendOptions, optional
        ``normal_radius``, ``feature_radius``, ``orientation`` and ``source_viewpoint`` are read.
    num_threads : int
        0 uses every core. The result does not depend on it.

    Returns
    -------
    ndarray of float32, shape (N, 33)
        Three histograms of 11 bins, each of which sums to 200; 0 where there is no surface.
    """
    if not 0 < voxel_size < np.inf:
        raise ValueError(f"voxel_size: {voxel_size} is not positive and finite")
    return _gmcr.fpfh(
        as_points(points, "points"),
        as_options(FrontendOptions, frontend, {}),
        voxel_size,
        num_threads,
    )
