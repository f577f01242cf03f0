"""Errors of a pose against the truth."""

from __future__ import annotations

from dataclasses import dataclass

from . import _gmcr
from ._arguments import PointsLike, PoseLike, as_points, as_pose


@dataclass(frozen=True)
class PoseErrors:
    """How far a pose is from the truth.

    Attributes
    ----------
    scale_error : float
        |estimate / truth - 1|, no unit.
    rotation_error_deg : float
        Angle between the rotations, degrees in [0, 180].
    translation_error : float
        Distance of the translations, metres.
    mean_point_error : float or None
        Mean distance between the images of the points, metres; None without points.
    """

    scale_error: float
    rotation_error_deg: float
    translation_error: float
    mean_point_error: float | None


def evaluate(estimate: PoseLike, truth: PoseLike, points: PointsLike | None = None) -> PoseErrors:
    """Errors of a pose against the truth.

    Parameters
    ----------
    estimate, truth : Similarity, Result, SyntheticProblem or array_like, shape (4, 4)
        The two transforms, target from source.
    points : array_like, shape (N, 3), optional
        Points of the source, metres, for the mean point error.

    Returns
    -------
    PoseErrors
    """
    pair = as_pose(estimate, "estimate"), as_pose(truth, "truth")
    return PoseErrors(
        scale_error=_gmcr.scale_error(*pair),
        rotation_error_deg=_gmcr.rotation_error_deg(*pair),
        translation_error=_gmcr.translation_error(*pair),
        mean_point_error=None
        if points is None
        else _gmcr.mean_point_error(*pair, as_points(points, "points")),
    )
