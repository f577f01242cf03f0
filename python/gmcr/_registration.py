"""Poses from correspondences."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _gmcr
from ._arguments import (
    PointsLike,
    PoseLike,
    as_points,
    as_pose,
    bounded_options,
    instance_options,
)
from ._gmcr import Consensus, InstanceOptions, Options, Result, Uncertainty

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import InstanceKeywords, SolverKeywords


def register_correspondences(
    source: PointsLike,
    target: PointsLike,
    options: Options | None = None,
    **keywords: Unpack[SolverKeywords],
) -> Result:
    """Transform that most of the correspondences ``source[i] -> target[i]`` agree with.

    Parameters
    ----------
    source, target : array_like, shape (N, 3)
        Matched points, metres; coordinates are 0 or of a magnitude from 1e-50 to 1e50. C-order
        float64 arrays are read in place.
    options : Options, optional
        Every choice of the solver.
    **keywords
        Fields of ``Options``, instead of ``options``; ``noise_bound`` in metres is the one that is
        needed, or 'auto' to take it from the data.
        ``initial_pose`` may be any pose, such as a matrix (4, 4), with ``max_rotation_error``,
        degrees, ``max_translation_error``, metres, or both: how near to it the transform is.

    Returns
    -------
    Result
        Status, transform, inliers, certificate and diagnostics. Data without an answer is a status,
        not an exception. The same bits for any number of threads, unless the time limit binds.

    Raises
    ------
    ValueError
        on a wrong shape, or a value or an option out of range, before any work.
    TypeError
        on an unknown option.

    Notes
    -----
    O(N^2) time and N^2 / 8 bytes, O(N) and those of a sample where memory or time is far from
    sufficing; the clique search is exponential in the worst case and ends at
    ``options.time_limit``. Other Python threads run meanwhile, and Ctrl-C stops it.

    Points may be of any library: torch tensors, clouds of Open3D, structured arrays with x, y, z.

    Examples
    --------
    >>> problem = gmcr.make_synthetic(num_correspondences=200, outlier_rate=0.9, seed=1)
    >>> result = gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.01)
    >>> result.status
    'ok'
    """
    return _gmcr.register_correspondences(
        as_points(source, "source"),
        as_points(target, "target"),
        bounded_options(options, **keywords),
    )


def register_instances(
    source: PointsLike,
    target: PointsLike,
    options: Options | None = None,
    instances: InstanceOptions | None = None,
    **keywords: Unpack[InstanceKeywords],
) -> list[Result]:
    """Several instances of the source in the target.

    Registers, removes the consensus set, registers what is left, and so on.

    Parameters
    ----------
    source, target : array_like, shape (N, 3)
        As for ``register_correspondences``.
    options : Options, optional
        The time limit is for all instances together.
    instances : InstanceOptions, optional
        When the search ends.
    **keywords
        Fields of ``Options`` and ``InstanceOptions``, instead of these, as for
        ``register_correspondences``.

    Returns
    -------
    list of Result
        Never empty; the inliers of later ones are those that no earlier one has.
    """
    limits, solver = instance_options(instances, options, **keywords)
    return _gmcr.register_instances(
        as_points(source, "source"), as_points(target, "target"), solver, limits
    )


def evaluate_consensus(
    target_from_source: PoseLike,
    source: PointsLike,
    target: PointsLike,
    options: Options | None = None,
    **keywords: Unpack[SolverKeywords],
) -> Consensus:
    """Consensus set of a given transform, by the rules of ``Result.inliers``.

    Parameters
    ----------
    target_from_source : Similarity, Result or array_like, shape (4, 4)
        The transform.
    source, target : array_like, shape (N, 3)
        Matched points, metres.
    options, **keywords
        As for ``register_correspondences``.

    Returns
    -------
    Consensus
        Inliers and evidence.
    """
    return _gmcr.evaluate_consensus(
        as_pose(target_from_source),
        as_points(source, "source"),
        as_points(target, "target"),
        bounded_options(options, **keywords),
    )


def evaluate_uncertainty(
    target_from_source: PoseLike,
    source: PointsLike,
    target: PointsLike,
    inliers: npt.ArrayLike,
    options: Options | None = None,
    **keywords: Unpack[SolverKeywords],
) -> Uncertainty:
    """Covariance and consistent scales of a given transform, by the rules of ``Result``.

    Parameters
    ----------
    target_from_source : Similarity, Result or array_like, shape (4, 4)
        The transform.
    source, target : array_like, shape (N, 3)
        Matched points, metres.
    inliers : array_like of int, shape (m,), or of bool, shape (N,)
        Its consensus set, such as ``Result.inliers``, or which of the matches are in it.
    options, **keywords
        As for ``register_correspondences``.

    Returns
    -------
    Uncertainty
        Covariance and consistent scales.

    Raises
    ------
    ValueError
        on a wrong shape, a value or an option out of range, or inliers that are no indices.
    """
    pose, points = as_pose(target_from_source), as_points(source, "source")
    return _gmcr.evaluate_uncertainty(
        pose,
        points,
        as_points(target, "target"),
        _as_indices(inliers, len(points)),
        bounded_options(options, **keywords),
    )


def _as_indices(inliers: npt.ArrayLike, num_matches: int) -> npt.NDArray[Any]:
    indices = np.asarray(inliers)
    if indices.dtype == bool and indices.shape == (num_matches,):
        return np.flatnonzero(indices)
    if indices.ndim != 1 or (indices.size and indices.dtype.kind not in "iu"):
        given = (
            f"shape {indices.shape}, {indices.dtype}" if indices.ndim else type(inliers).__name__
        )
        raise ValueError(
            f"inliers: expected indices of matches, or {num_matches} of True and False, but it is "
            f"{given}; write result.inliers"
        )
    return indices.astype(np.int64)


def consistency_graph(
    source: PointsLike,
    target: PointsLike,
    options: Options | None = None,
    **keywords: Unpack[SolverKeywords],
) -> npt.NDArray[np.bool_]:
    """Which pairs of correspondences can be inliers of one transform: the graph that is searched.

    Parameters
    ----------
    source, target : array_like, shape (N, 3)
        Matched points, metres.
    options, **keywords
        As for ``register_correspondences``; priors and ``one_to_one`` remove edges. With an
        estimated scale, ``scale_range`` is needed: the pairs are those that agree at some scale in
        it.

    Returns
    -------
    ndarray of bool, shape (N, N)
        Symmetric, False on the diagonal.
    """
    return _gmcr.consistency_graph(
        as_points(source, "source"),
        as_points(target, "target"),
        bounded_options(options, **keywords),
    )
