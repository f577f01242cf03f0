"""From edges to poses: which edges agree, and where they put the scans."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .._arguments import CloudLike
from .._enums import Verdict
from ._edge import Edge, point_information
from ._forest import length_around, poses_along, spanning_forest
from ._groups import joining_edges
from ._motion import Matrix, inverse, rms_motion, translation_by
from ._pose_graph import optimise_poses
from ._result import Component, JudgedEdge, MultiviewResult
from ._scans import as_scans

_MAX_ROUNDS = 10


def place_scans(scans: Sequence[CloudLike], edges: Sequence[Edge]) -> MultiviewResult:
    """Poses of all scans from measured poses of pairs, some of which may be wrong.

    1. Groups of scans, at first single ones, are joined by the largest sets of edges between them
       that are pairwise consistent: maximum cliques of edges whose cycles close.
    2. The poses along these edges say which of all edges agree with them; these are accepted.
    3. A pose graph refines the poses with the accepted edges, and so on from 2, until they stay the
       same.

    Parameters
    ----------
    scans : sequence of array_like, shape (N_i, 3), or paths
        Points, metres, finite; only their centroids and extents are used.
    edges : sequence of Edge
        Measured poses; several for one pair of scans are hypotheses of which one may be accepted.

    Returns
    -------
    MultiviewResult

    Raises
    ------
    ValueError
        where there is no scan, one is empty, or an edge does not fit them.
    ImportError
        where the extra ``multiview`` is not installed and a pose graph is needed.

    Notes
    -----
    Deterministic. A pose is only as sure as its edges: what no cycle confirms is accepted where it
    is trusted, and ``JudgedEdge.is_confirmed`` says so.
    """
    points = as_scans(scans)
    _check(edges, len(points))
    centres = [translation_by(scan.mean(axis=0)) for scan in points]
    spreads = [np.cov(scan.T, bias=True) for scan in points]
    centred = [_centred(edge, centres, points) for edge in edges]
    accepted, groups = _agree(centred, spreads)
    components = tuple(_uncentred(group, centres) for group in groups)
    poses = components[0].poses
    return MultiviewResult(
        tuple(poses.get(index) for index in range(len(points))),
        components,
        tuple(
            _judge(edge, replaced, accepted, groups, spreads)
            for edge, replaced in zip(edges, centred, strict=True)
        ),
    )


def _check(edges: Sequence[Edge], num_scans: int) -> None:
    for index, edge in enumerate(edges):
        if not (0 <= min(edge.source, edge.target) < max(edge.source, edge.target) < num_scans):
            raise ValueError(
                f"edges[{index}]: {edge.source} -> {edge.target} are not two of {num_scans} scans"
            )


def _centred(edge: Edge, centres: Sequence[Matrix], scans: Sequence[Matrix]) -> Edge:
    """The edge between the scans with their centroids as origins, with information."""
    pose = inverse(centres[edge.target]) @ edge.target_from_source @ centres[edge.source]
    information = edge.information
    if information is None:
        points = scans[edge.source] - centres[edge.source][:3, 3]
        information = point_information(points, edge.tolerance)
    return replace(edge, target_from_source=pose, information=information)


def _uncentred(poses: dict[int, Matrix], centres: Sequence[Matrix]) -> Component:
    scans = tuple(poses)
    first = centres[scans[0]]
    return Component(scans, {i: first @ poses[i] @ inverse(centres[i]) for i in scans})


def _agree(
    edges: Sequence[Edge], spreads: Sequence[Matrix]
) -> tuple[list[Edge], list[dict[int, Matrix]]]:
    """The accepted edges, and the poses of the groups of scans that they connect."""
    candidates = [edge for edge in edges if edge.verdict != Verdict.UNTRUSTED]
    preferred = joining_edges(candidates, spreads)

    def rank(edge: Edge) -> int:
        return preferred.index(edge) if edge in preferred else len(preferred)

    accepted = spanning_forest(len(spreads), preferred)
    groups = poses_along(len(spreads), accepted)
    for _ in range(_MAX_ROUNDS):
        agreeing = [edge for edge in candidates if _agrees(edge, accepted, groups, spreads)]
        agreeing = [
            edge
            for edge in agreeing
            if edge.verdict == Verdict.TRUSTED or length_around(edge, agreeing) is not None
        ]
        if agreeing == accepted:
            break
        accepted = agreeing
        forest = spanning_forest(len(spreads), sorted(accepted, key=rank))
        groups = [_refined(group, accepted) for group in poses_along(len(spreads), forest)]
    return accepted, groups


def _refined(poses: dict[int, Matrix], accepted: Sequence[Edge]) -> dict[int, Matrix]:
    edges = [edge for edge in accepted if edge.source in poses]
    # the poses of a tree meet its edges exactly
    return optimise_poses(poses, edges) if len(edges) >= len(poses) > 1 else poses


def _disagreement(
    edge: Edge, groups: Sequence[dict[int, Matrix]], spreads: Sequence[Matrix]
) -> float | None:
    for poses in groups:
        if edge.source in poses and edge.target in poses:
            placed = inverse(poses[edge.target]) @ poses[edge.source]
            change = inverse(edge.target_from_source) @ placed
            return float(rms_motion(change, spreads[edge.source]))
    return None


def _limit(edge: Edge, accepted: Sequence[Edge]) -> float:
    """What the edge may disagree by: the errors of all edges of the shortest cycle add up."""
    return edge.tolerance * math.sqrt(1 + (length_around(edge, accepted) or 0))


def _agrees(
    edge: Edge,
    accepted: Sequence[Edge],
    groups: Sequence[dict[int, Matrix]],
    spreads: Sequence[Matrix],
) -> bool:
    disagreement = _disagreement(edge, groups, spreads)
    return disagreement is not None and disagreement <= _limit(edge, accepted)


def _judge(
    edge: Edge,
    centred: Edge,
    accepted: Sequence[Edge],
    groups: Sequence[dict[int, Matrix]],
    spreads: Sequence[Matrix],
) -> JudgedEdge:
    disagreement = _disagreement(centred, groups, spreads)
    is_accepted = centred in accepted
    is_confirmed = is_accepted and length_around(centred, accepted) is not None
    if is_confirmed:
        reason = f"confirmed by others, {disagreement:.3g} m off the poses"
    elif is_accepted:
        reason = "no cycle confirms it"
    elif edge.verdict == Verdict.UNTRUSTED:
        reason = edge.reason or "untrusted"
    elif disagreement is None:
        reason = f"no cycle confirms it; {edge.reason}"
    else:
        limit = _limit(centred, accepted)
        reason = f"{disagreement:.3g} m off the poses that the others agree on, limit {limit:.3g} m"
    return JudgedEdge(edge, is_accepted, is_confirmed, disagreement, reason)
