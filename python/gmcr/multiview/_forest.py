"""Paths and trees of edges."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence

import numpy as np
import numpy.typing as npt

from ._edge import Edge
from ._motion import Matrix, inverse


def spanning_forest(num_scans: int, edges: Iterable[Edge]) -> list[Edge]:
    """The edges that join two groups of scans, each taken as early as possible (Kruskal)."""
    group = list(range(num_scans))
    forest = []
    for edge in edges:
        source, target = group[edge.source], group[edge.target]
        if source != target:
            forest.append(edge)
            group = [source if each == target else each for each in group]
    return forest


def poses_along(num_scans: int, forest: Sequence[Edge]) -> list[dict[int, Matrix]]:
    """Poses of each group of connected scans in the frame of its first, groups by their first."""
    groups: list[dict[int, Matrix]] = []
    placed: set[int] = set()
    for root in range(num_scans):
        if root in placed:
            continue
        poses = {root: np.eye(4)}
        queue = deque([root])
        while queue:
            scan = queue.popleft()
            for edge in forest:
                if edge.target == scan and edge.source not in poses:
                    poses[edge.source] = poses[scan] @ edge.target_from_source
                    queue.append(edge.source)
                elif edge.source == scan and edge.target not in poses:
                    poses[edge.target] = poses[scan] @ inverse(edge.target_from_source)
                    queue.append(edge.target)
        placed |= poses.keys()
        groups.append(dict(sorted(poses.items())))
    return groups


def path_lengths(num_scans: int, edges: Iterable[Edge]) -> npt.NDArray[np.int64]:
    """Least number of edges from each scan to each other, (N, N); 0 where none lead there."""
    adjacency = np.zeros((num_scans, num_scans), dtype=np.int64)
    for edge in edges:
        adjacency[edge.source, edge.target] = adjacency[edge.target, edge.source] = 1
    lengths = np.zeros_like(adjacency)
    frontier = reached = np.eye(num_scans, dtype=np.bool_)
    for length in range(1, num_scans):
        frontier = (frontier @ adjacency > 0) & ~reached
        reached = reached | frontier
        lengths[frontier] = length
    return lengths


def length_around(edge: Edge, edges: Iterable[Edge]) -> int | None:
    """Least number of the other edges that lead from its source to its target; None: none do."""
    steps = [(other.source, other.target) for other in edges if other is not edge]
    steps += [(target, source) for source, target in steps]
    reached = frontier = {edge.source}
    length = 0
    while edge.target not in reached:
        length += 1
        frontier = {to for at, to in steps if at in frontier and to not in reached}
        if not frontier:
            return None
        reached = reached | frontier
    return length
