"""Poses and matches of clouds."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from . import _gmcr
from ._arguments import (
    CloudLike,
    PoseLike,
    as_cloud,
    as_options,
    as_pose,
    cloud_instance_options,
    cloud_options,
    solver_options,
)
from ._gmcr import CloudMatches, CloudResult, FrontendOptions, InstanceOptions, Options
from ._hints import require_cloud_result
from ._prepared import as_prepared_pair

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import CloudInstanceKeywords, CloudKeywords, SolverKeywords


def register_clouds(
    source: CloudLike,
    target: CloudLike,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    **keywords: Unpack[CloudKeywords],
) -> CloudResult:
    """Pose that aligns two clouds, from no initial guess.

    Voxel grid, normals, FPFH, nearest neighbours in feature space, ``register_correspondences``,
    the refinement of ``refine``, and a verdict from the inliers and from how the surfaces meet.
    Where the verdict is not ``'trusted'``, other settings of the front end are tried, and the poses
    of all are compared by their surfaces.

    Parameters
    ----------
    source : array_like, shape (N, 3), or path
        Points, metres, finite: an array of any library, an Open3D cloud, a structured array with
        x, y, z, as of ROS, or a file that ``gmcr.io`` reads. More columns may follow x, y, z. Or a
        ``PreparedCloud``.
    target : array_like, shape (M, 3), or path
        As the source.
    frontend : FrontendOptions, optional
        How clouds become correspondences; voxel sizes come from the data by default.
    options : Options, optional
        For the solver; ``noise_bound`` 0 takes the bound from the voxel size.
    **keywords
        Fields of ``Options`` and ``FrontendOptions``, instead of these. ``initial_pose`` may be
        any pose, such as a matrix (4, 4), with ``max_rotation_error``, degrees,
        ``max_translation_error``, metres, or both: how near to it the pose is.

    Returns
    -------
    CloudResult
        Registration, matches, fitness and verdict.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, or an option out of range.
    OSError
        where a file cannot be read.

    Examples
    --------
    >>> result = gmcr.register_clouds("scan_2.ply", "scan_1.ply", voxel_size=0.1)
    >>> result.verdict, result.matrix()
    """
    matching, solver = cloud_options(frontend, options, **keywords)
    prepared = as_prepared_pair(source, target, matching)
    if prepared is not None:
        return _gmcr.register_prepared(*prepared, matching, solver)
    return _gmcr.register_clouds(
        as_cloud(source, "source"), as_cloud(target, "target"), matching, solver
    )


def register_cloud_instances(
    source: CloudLike,
    target: CloudLike,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    instances: InstanceOptions | None = None,
    **keywords: Unpack[CloudInstanceKeywords],
) -> list[CloudResult]:
    """Several instances of the source in the target, such as parts in a bin.

    ``register_clouds``, then again without the points of the target that the instance covers, and
    so on. A pose that fits about as well somewhere else is another instance, not a rival.

    Parameters
    ----------
    source, target : array_like, shape (N, 3) and (M, 3), or path
        As for ``register_clouds``.
    frontend : FrontendOptions, optional
        As for ``register_clouds``.
    options : Options, optional
        As for ``register_clouds``; the time limit is for all instances together.
    instances : InstanceOptions, optional
        When the search ends.
    **keywords
        Fields of ``Options``, ``FrontendOptions`` and ``InstanceOptions``, instead of these, as
        for ``register_clouds``.

    Returns
    -------
    list of CloudResult
        Never empty. Those after the first have a pose that is not untrusted; each is judged by
        itself, on what was left of the target.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, or an option out of range.
    """
    matching, solver, limits = cloud_instance_options(frontend, options, instances, **keywords)
    return _gmcr.register_cloud_instances(
        as_cloud(source, "source"), as_cloud(target, "target"), matching, solver, limits
    )


def match(
    source: CloudLike,
    target: CloudLike,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    **keywords: Unpack[CloudKeywords],
) -> CloudMatches:
    """Correspondences between two clouds by FPFH: the front end of ``register_clouds`` alone.

    Parameters
    ----------
    source, target : array_like, shape (N, 3) and (M, 3), or path
        As for ``register_clouds``.
    frontend : FrontendOptions, optional
        How clouds become correspondences.
    options : Options, optional
        ``scale_mode``, ``scale``, ``noise_bound``, ``one_to_one`` and ``num_threads`` are read.
    **keywords
        Fields of ``Options`` and ``FrontendOptions``, instead of these, as for
        ``register_clouds``.

    Returns
    -------
    CloudMatches
        Matched points, their indices, the clouds after the voxel grid.
    """
    matching, solver = cloud_options(frontend, options, **keywords)
    prepared = as_prepared_pair(source, target, matching)
    if prepared is not None:
        return _gmcr.match_prepared(*prepared, matching, solver)
    return _gmcr.match_clouds(
        as_cloud(source, "source"), as_cloud(target, "target"), matching, solver
    )


def refine_clouds(
    result: CloudResult,
    source: CloudLike,
    target: CloudLike,
    options: Options | None = None,
    **keywords: Unpack[SolverKeywords],
) -> CloudResult:
    """The result at the pose near its own at which the surfaces of the clouds meet best.

    What ``register_clouds`` does with its pose unless ``refine='none'``: for a pose from elsewhere,
    or for an alternative.

    Parameters
    ----------
    result : CloudResult
        Of ``register_clouds`` or ``with_pose``.
    source, target : array_like, shape (N, 3) and (M, 3), or path
        The clouds that it is of, as for ``register_clouds``.
    options, **keywords
        Those that the result was computed with, as for ``register_clouds``; ``time_limit`` ends
        the refinement.

    Returns
    -------
    CloudResult
        As it was where it has no pose, or the surfaces meet best there.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, or an option out of range.
    TypeError
        where the result is not one of clouds, with what to write.
    """
    require_cloud_result(
        result,
        "gmcr.refine_clouds(result, source, target)",
        "for a pose from elsewhere gmcr.register_clouds(source, target, initial_pose=pose, "
        "max_rotation_error=5, max_translation_error=0.5), which refines it",
    )
    return _gmcr.refine_clouds(
        result,
        as_cloud(source, "source"),
        as_cloud(target, "target"),
        solver_options(options, **keywords),
    )


def with_pose(
    result: CloudResult,
    target_from_source: PoseLike,
    options: Options | None = None,
    **keywords: Unpack[SolverKeywords],
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

    Raises
    ------
    TypeError
        where the result is not one of clouds, with what to write.
    """
    require_cloud_result(result, "gmcr.with_pose(result, pose)")
    return _gmcr.with_pose(result, as_pose(target_from_source), solver_options(options, **keywords))


def voxel_grid(points: CloudLike, voxel_size: float) -> npt.NDArray[np.float64]:
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
    array = as_cloud(points, "points")
    if not np.isfinite(array).all():
        raise ValueError("points: not all are finite")
    return _gmcr.voxel_grid(array, voxel_size)


def fpfh(
    points: CloudLike,
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
        as_cloud(points, "points"),
        as_options(FrontendOptions, frontend, {}),
        voxel_size,
        num_threads,
    )
