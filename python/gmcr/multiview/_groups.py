"""Groups of scans, joined by the edges between them that agree with each other.

Pairwise consistent measurements (Mangelson et al. 2018), for scans without an order or odometry.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, product

import numpy as np
import numpy.typing as npt

from .._cliques import max_weight_clique
from .._enums import Verdict
from ._edge import Edge
from ._forest import path_lengths
from ._motion import Matrix, inverse, rms_motion

_MAX_CLIQUE_WORK = 1 << 32  # a second or two; it binds for thousands of edges between two groups


@dataclass(frozen=True)
class _Link:
    """The strongest consistent set of edges between two groups."""

    edges: tuple[Edge, ...]
    strength: float


def joining_edges(edges: Sequence[Edge], spreads: Sequence[Matrix]) -> list[Edge]:
    """Edges that join the scans to as large groups as they consistently can, best first.

    At first each scan is a group. Between two groups, two edges are compatible where the cycle that
    they form with the poses within the groups closes. The clique of compatible edges with the most
    trusted ones, then with the most that close a triangle, then of the greatest weight, is the link
    of the two. The groups with the best link are joined, and so on.

    Parameters
    ----------
    edges : sequence of Edge
        E edges between scans whose origins are their centroids.
    spreads : sequence of ndarray, shape (3, 3)
        Covariance of the points of each scan, square metres.

    Returns
    -------
    list of Edge
        The edges of all links in the order in which they were followed.

    Notes
    -----
    The first edges cannot be checked so, hence the triangles. O(E N) poses for the triangles of N
    scans and O(E^2) for the links, where cliques are small.
    """
    strengths = _strengths(edges, spreads)
    groups: dict[int, dict[int, Matrix]] = {i: {i: np.eye(4)} for i in range(len(spreads))}
    joined: list[Edge] = []
    links: dict[tuple[int, int], _Link] = {}
    while True:
        lengths = path_lengths(len(spreads), joined)
        for pair, between in _edges_between(edges, groups).items():
            if pair not in links:
                is_compatible = _compatibility(between, groups, pair, lengths, spreads)
                links[pair] = _strongest(between, [strengths[e] for e in between], is_compatible)
        if not links:
            return joined
        pair = max(links, key=lambda each: links[each].strength)
        joined += links[pair].edges
        _join(groups, pair, links[pair].edges[0])
        links = {each: link for each, link in links.items() if not set(each) & set(pair)}


def _strengths(edges: Sequence[Edge], spreads: Sequence[Matrix]) -> dict[Edge, float]:
    """Numbers whose sums compare trusted edges first, then confirmed ones, then weights."""
    confirmed = _edges_of_closing_triangles(edges, spreads)
    above_weights = 1 + sum(edge.weight for edge in edges)
    above_confirmed = (1 + len(edges)) * above_weights
    return {
        edge: edge.weight
        + above_weights * (edge in confirmed)
        + above_confirmed * (edge.verdict == Verdict.TRUSTED)
        for edge in edges
    }


def _edges_between(
    edges: Sequence[Edge], groups: Mapping[int, Mapping[int, Matrix]]
) -> dict[tuple[int, int], list[Edge]]:
    group_of = {scan: group for group, poses in groups.items() for scan in poses}
    between: dict[tuple[int, int], list[Edge]] = defaultdict(list)
    for edge in edges:
        ends = sorted((group_of[edge.source], group_of[edge.target]))
        if ends[0] != ends[1]:
            between[ends[0], ends[1]].append(edge)
    return between


def _compatibility(
    edges: Sequence[Edge],
    groups: Mapping[int, Mapping[int, Matrix]],
    pair: tuple[int, int],
    lengths: npt.NDArray[np.int64],
    spreads: Sequence[Matrix],
) -> npt.NDArray[np.bool_]:
    """Which edges between the two groups agree on the pose of one in the frame of the other."""
    poses = [_pose_between(edge, groups, pair) for edge in edges]
    is_compatible = np.zeros((len(edges), len(edges)), dtype=np.bool_)
    for i, j in combinations(range(len(edges)), 2):
        error = _motion_of(edges[i], groups, pair, poses[i], poses[j], spreads)
        limit = _cycle_limit(edges[i], edges[j], groups, pair, lengths)
        is_compatible[i, j] = is_compatible[j, i] = error <= limit
    return is_compatible


def _strongest(
    edges: Sequence[Edge], strengths: Sequence[float], is_compatible: npt.NDArray[np.bool_]
) -> _Link:
    """Maximum clique of compatible edges, the strongest edge first."""
    clique = max_weight_clique(is_compatible, strengths, max_work=_MAX_CLIQUE_WORK).vertices
    order = sorted(clique, key=lambda index: -strengths[index])
    return _Link(tuple(edges[i] for i in order), sum(strengths[i] for i in order))


def _ends(
    edge: Edge, groups: Mapping[int, Mapping[int, Matrix]], pair: tuple[int, int]
) -> tuple[int, int]:
    """The edge's scan in the first group of the pair and its scan in the second."""
    is_forward = edge.source in groups[pair[0]]
    return (edge.source, edge.target) if is_forward else (edge.target, edge.source)


def _pose_between(
    edge: Edge, groups: Mapping[int, Mapping[int, Matrix]], pair: tuple[int, int]
) -> Matrix:
    """Pose of the second group in the frame of the first, by this edge."""
    first, second = _ends(edge, groups, pair)
    step = edge.target_from_source if edge.source == second else inverse(edge.target_from_source)
    return groups[pair[0]][first] @ step @ inverse(groups[pair[1]][second])


def _motion_of(
    edge: Edge,
    groups: Mapping[int, Mapping[int, Matrix]],
    pair: tuple[int, int],
    pose: Matrix,
    other: Matrix,
    spreads: Sequence[Matrix],
) -> float:
    """How far the points of the edge's scan in the second group lie apart under two poses."""
    _, scan = _ends(edge, groups, pair)
    group_from_scan = groups[pair[1]][scan]
    change = inverse(group_from_scan) @ inverse(pose) @ other @ group_from_scan
    return float(rms_motion(change, spreads[scan]))


def _cycle_limit(
    edge: Edge,
    other: Edge,
    groups: Mapping[int, Mapping[int, Matrix]],
    pair: tuple[int, int],
    lengths: npt.NDArray[np.int64],
) -> float:
    """Errors of the edges of the cycle add up like independent ones of the larger tolerance."""
    ends = zip(_ends(edge, groups, pair), _ends(other, groups, pair), strict=True)
    num_edges = 2 + sum(int(lengths[start, end]) for start, end in ends)
    return max(edge.tolerance, other.tolerance) * math.sqrt(num_edges)


def _join(groups: dict[int, dict[int, Matrix]], pair: tuple[int, int], edge: Edge) -> None:
    """Moves the second group into the first, as the edge says."""
    first_from_second = _pose_between(edge, groups, pair)
    second = groups.pop(pair[1])
    groups[pair[0]].update({scan: first_from_second @ pose for scan, pose in second.items()})


def _edges_of_closing_triangles(edges: Sequence[Edge], spreads: Sequence[Matrix]) -> set[Edge]:
    steps: dict[tuple[int, int], list[tuple[Edge, Matrix]]] = defaultdict(list)
    for edge in edges:
        steps[edge.source, edge.target].append((edge, edge.target_from_source))
        steps[edge.target, edge.source].append((edge, inverse(edge.target_from_source)))
    confirmed: set[Edge] = set()
    for i, j, k in combinations(range(len(spreads)), 3):
        for (a, ij), (b, jk), (c, ki) in product(steps[i, j], steps[j, k], steps[k, i]):
            limit = max(a.tolerance, b.tolerance, c.tolerance) * np.sqrt(3)
            if rms_motion(ki @ jk @ ij, spreads[i]) <= limit:
                confirmed |= {a, b, c}
    return confirmed
