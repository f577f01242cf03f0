"""Poses of pairs of scans."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from .. import _gmcr
from .._arguments import CloudLike, cloud_options
from .._clouds import refine_clouds, register_clouds, with_pose
from .._enums import Refine, ScaleMode, Verdict
from .._gmcr import CloudResult, FrontendOptions, Options, PreparedCloud
from ._edge import Edge, point_information
from ._motion import Matrix
from ._overlap import overlap_of, require_open3d
from ._scans import as_scans

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .._keywords import CloudKeywords

_LEAST_SIGMA = 1e-3  # voxels: copies of a scan meet exactly


def register_pairs(
    scans: Sequence[CloudLike],
    pairs: Iterable[tuple[int, int]] | None = None,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    *,
    tolerance: float | None = None,
    **keywords: Unpack[CloudKeywords],
) -> list[Edge]:
    """Registers pairs of scans by ``gmcr.register_clouds``.

    Parameters
    ----------
    scans : sequence of array_like, shape (N_i, 3), or paths
        Points, metres, finite; each as a cloud of ``register_clouds``.
    pairs : iterable of (int, int), optional
        (source, target) indices; every pair by default, the later scan onto the earlier.
    frontend : FrontendOptions, optional
        How clouds become correspondences, and whether their poses are refined.
    options : Options, optional
        For the solver. With ``num_hypotheses`` > 1, the alternatives of a pair are edges too.
    tolerance : float, optional
        Metres, > 0, see ``Edge.tolerance``; the noise bound of the pair by default.
    **keywords
        Fields of ``Options`` and ``FrontendOptions``, instead of these, as for
        ``gmcr.register_clouds``.

    Returns
    -------
    list of Edge
        In the order of the pairs, alternatives after their best; pairs without a pose are there
        too, untrusted.

    Raises
    ------
    ValueError
        where a pair or the tolerance is out of range, or the scale is not known to be 1.
    ImportError
        where the extra ``multiview`` is not installed.

    Notes
    -----
    O(number of pairs): one ``register_clouds`` each. Where ``voxel_size`` is given each scan is
    prepared once (``gmcr.prepare``). Deterministic.
    """
    points = as_scans(scans)
    chosen = _check_pairs(_all_pairs(len(points)) if pairs is None else pairs, len(points))
    matching, solver = cloud_options(frontend, options, **keywords)
    if solver.scale_mode != ScaleMode.KNOWN or solver.scale != 1:
        raise ValueError("options: scans of one scene have scale 1, known")
    if tolerance is not None and not tolerance > 0:
        raise ValueError(f"tolerance: {tolerance} is not positive")
    require_open3d()  # before the long work
    edges = []
    clouds = _prepared(scans, points, matching, solver)
    for source, target in chosen:
        best = register_clouds(clouds[source], clouds[target], matching, solver)
        for result in _hypotheses(best, points[source], points[target], matching, solver):
            edges.append(_edge_of(source, target, result, points[source].mean(axis=0), tolerance))
    return edges


def _prepared(
    scans: Sequence[CloudLike],
    points: Sequence[Matrix],
    frontend: FrontendOptions,
    options: Options,
) -> list[Matrix | PreparedCloud]:
    """The scans with what all their pairs need, where these are matched at one voxel size."""
    is_shared = (
        frontend.voxel_size > 0
        and frontend.source_voxel_size == 0
        and not np.any(frontend.source_viewpoint)
        and not np.any(frontend.target_viewpoint)
    )
    clouds: list[Matrix | PreparedCloud] = []
    for scan, cloud in zip(scans, points, strict=True):
        if isinstance(scan, PreparedCloud):
            clouds.append(scan)
        elif is_shared:
            clouds.append(_gmcr.prepare(cloud, frontend, options.num_threads))
        else:
            clouds.append(cloud)
    return clouds


def _all_pairs(num_scans: int) -> list[tuple[int, int]]:
    return [(source, target) for target, source in combinations(range(num_scans), 2)]


def _check_pairs(pairs: Iterable[tuple[int, int]], num_scans: int) -> list[tuple[int, int]]:
    chosen = [(int(source), int(target)) for source, target in pairs]
    seen = set()
    for pair in chosen:
        if not 0 <= min(pair) < max(pair) < num_scans:
            raise ValueError(f"pairs: {pair} are not two of {num_scans} scans")
        if frozenset(pair) in seen:
            raise ValueError(f"pairs: {pair} is there twice")
        seen.add(frozenset(pair))
    return chosen


def _hypotheses(
    best: CloudResult, source: Matrix, target: Matrix, frontend: FrontendOptions, options: Options
) -> list[CloudResult]:
    others = [
        with_pose(best, alternative.target_from_source, options)
        for alternative in best.registration.alternatives
    ]
    if frontend.refine == Refine.ICP:
        others = [refine_clouds(other, source, target, options) for other in others]
    return [best, *others]


def _edge_of(
    source: int,
    target: int,
    result: CloudResult,
    centroid: Matrix,
    tolerance: float | None,
) -> Edge:
    information = None
    if result.verdict != Verdict.UNTRUSTED:
        overlap = overlap_of(result) - centroid
        sigma = max(result.overlap_rmse, _LEAST_SIGMA * result.matches.target_voxel_size)
        information = point_information(overlap, sigma)
    return Edge(
        source,
        target,
        result.matrix(),
        weight=result.distinct_evidence,
        tolerance=tolerance or result.matches.noise_bound,
        information=information,
        verdict=result.verdict,
        reason=result.verdict_reason,
        result=result,
    )
