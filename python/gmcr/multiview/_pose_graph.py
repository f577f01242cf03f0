"""Least-squares poses, by Open3D."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ._edge import Edge
from ._motion import Matrix
from ._overlap import require_open3d

# Relative, and absolute where residuals are in standard deviations; Open3D's 1e-6 stops early.
_PRECISION = 1e-9


def optimise_poses(poses: Mapping[int, Matrix], edges: Sequence[Edge]) -> dict[int, Matrix]:
    """Poses that the edges agree with best, weighted by their information.

    Parameters
    ----------
    poses : mapping of int to ndarray, shape (4, 4)
        Where to start: for each scan of a connected group its pose in the frame of the first.
    edges : sequence of Edge
        Edges between these scans, each with its information. Scans have their centroids as origins.

    Returns
    -------
    dict of int to ndarray, shape (4, 4)
        The pose of the first stays as it was.
    """
    registration = require_open3d().pipelines.registration
    scans = list(poses)
    graph = registration.PoseGraph()
    for pose in poses.values():
        graph.nodes.append(registration.PoseGraphNode(pose))
    for edge in edges:
        ends = scans.index(edge.source), scans.index(edge.target)
        graph.edges.append(
            registration.PoseGraphEdge(*ends, edge.target_from_source, edge.information, False)
        )
    criteria = registration.GlobalOptimizationConvergenceCriteria()
    criteria.min_relative_increment = criteria.min_relative_residual_increment = _PRECISION
    criteria.min_right_term = criteria.min_residual = _PRECISION
    registration.global_optimization(
        graph,
        registration.GlobalOptimizationLevenbergMarquardt(),
        criteria,
        registration.GlobalOptimizationOption(reference_node=0),
    )
    return {scan: np.array(node.pose) for scan, node in zip(scans, graph.nodes, strict=True)}
