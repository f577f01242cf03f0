"""What is known of the relative pose of two scans."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .._enums import Verdict
from .._gmcr import CloudResult, Similarity

Matrix = npt.NDArray[np.float64]

_RIGID = 1e-3  # as far from 1 as from_matrix lets rotations be from orthonormal


@dataclass(frozen=True, eq=False)
class Edge:
    """A measured pose between two scans.

    Attributes
    ----------
    source, target : int
        Indices of the scans.
    target_from_source : ndarray, shape (4, 4)
        The pose, rigid.
    weight : float
        > 0; how much speaks for it, such as the distinct evidence of its inliers.
    tolerance : float
        Metres, > 0: what its error may move the points of the source by (RMS).
    information : ndarray, shape (6, 6), optional
        Inverse covariance of its error (omega, tau), radians and metres, which moves the source's
        points by ``omega x (p - centroid) + tau``; by default ``tolerance`` for each point.
    verdict : Verdict
        ``'trusted'`` edges place scans; ``'doubtful'`` ones only where a cycle confirms them;
        ``'untrusted'`` ones never.
    reason : str
        Of the verdict.
    result : CloudResult, optional
        The registration that it comes from, with its certificate.
    """

    source: int
    target: int
    target_from_source: Matrix
    weight: float
    tolerance: float
    information: Matrix | None = None
    verdict: Verdict = Verdict.TRUSTED
    reason: str = ""
    result: CloudResult | None = None

    def __post_init__(self) -> None:
        if not abs(Similarity.from_matrix(self.target_from_source).scale - 1) <= _RIGID:
            raise ValueError("target_from_source: expected a rigid pose, but its scale is not 1")
        if self.verdict != Verdict.UNTRUSTED and not (self.weight > 0 and self.tolerance > 0):
            raise ValueError(
                f"weight and tolerance: {self.weight} and {self.tolerance} are not both positive"
            )


def point_information(points: Matrix, sigma: float) -> Matrix:
    """Information of a pose that holds points of the source, each to ``sigma`` metres.

    The sum of ``J^T J / sigma^2`` with ``J = [-[p]x, I]`` (Choi et al. 2015).

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        Metres, from the centroid of the source.
    sigma : float
        Metres, > 0.

    Returns
    -------
    ndarray, shape (6, 6)
        As ``Edge.information``.

    Raises
    ------
    ValueError
        where ``sigma`` is not positive.
    """
    if not sigma > 0:
        raise ValueError(f"sigma: {sigma} is not positive")
    squares, (x, y, z) = points.T @ points, points.sum(axis=0)
    information = np.empty((6, 6))
    information[:3, :3] = np.trace(squares) * np.eye(3) - squares
    information[:3, 3:] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    information[3:, :3] = information[:3, 3:].T
    information[3:, 3:] = len(points) * np.eye(3)
    return information / sigma**2
