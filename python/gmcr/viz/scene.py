"""What to draw: plain arrays that the page, the report and the figure share."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from .. import consistency_graph
from .motion import Motion
from .outcome import OtherPose, Outcome, WeakDirection

Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]

# Farther from the origin than so many times their extent, points are drawn relative to their
# centre: single precision, which is all that WebGL has, would tear them.
_FAR = 1000

# Points of the source whose distances are shown, and of the target from which these are taken.
_MEASURED = 4000
_MEASURED_AGAINST = 50_000
_CHUNK = 250


@dataclass(frozen=True)
class DrawLimits:
    """How much is drawn, each >= 1; what is left out is said.

    Attributes
    ----------
    points : int
        Points of each cloud.
    inliers, outliers : int
        Correspondences drawn as lines.
    vertices : int
        Inliers, and as many outliers, of the consensus graph.
    """

    points: int = 20_000
    inliers: int = 200
    outliers: int = 200
    vertices: int = 100

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if value < 1:
                raise ValueError(f"{name}: {value} is less than 1")


@dataclass(frozen=True)
class Sample:
    """Some of many: indices, ascending, and how many there are."""

    indices: Indices
    total: int

    def words(self, noun: str) -> str:
        """Such as '115 inliers' or '200 of 5,229 outliers'."""
        shown = len(self.indices)
        return f"{shown:,} {noun}" if shown == self.total else f"{shown:,} of {self.total:,} {noun}"


@dataclass(frozen=True)
class Graph:
    """Part of the consensus graph: which correspondences can be inliers of one transform.

    Attributes
    ----------
    inliers, outliers : Sample
        Its vertices, the inliers first.
    adjacency : ndarray of bool, shape (k, k)
        Symmetric, False on the diagonal.
    """

    inliers: Sample
    outliers: Sample
    adjacency: npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Scene:
    """What to draw of a registration.

    Attributes
    ----------
    source_cloud, target_cloud : ndarray, shapes (n, 3) and (m, 3)
        The points that are drawn, metres, each in its own frame, less ``origin``.
    source_points, target_points : Sample
        Which points these are.
    source, target : ndarray, shape (N, 3)
        The correspondences, less ``origin``.
    motion : Motion
        From source to target, less ``origin``.
    inliers, outliers : Sample
        Correspondences to draw.
    residuals : ndarray, shape (N,)
        Distance of each target point from the image of its source point, metres.
    bounds : ndarray, shape (N,), or None
        Largest residual of an inlier, metres, where it is known.
    graph : Graph or None
        Where there is a pose and the bounds are known.
    origin : ndarray, shape (3,)
        What was subtracted from all points; 0 unless they are far from the origin.
    measured : Sample
        The points of ``source_cloud`` whose distances are known.
    distances : ndarray or None
        Of each of them, after the motion, from the nearest point of the target, metres; None where
        the source is no cloud or has no pose.
    """

    source_cloud: Floats
    target_cloud: Floats
    source_points: Sample
    target_points: Sample
    source: Floats
    target: Floats
    motion: Motion
    inliers: Sample
    outliers: Sample
    residuals: Floats
    bounds: Floats | None
    graph: Graph | None
    origin: Floats
    measured: Sample
    distances: Floats | None

    def links(self, sample: Sample, share: float) -> tuple[Floats, Floats]:
        """Both ends, (k, 3) each, of correspondences after ``share`` of the motion."""
        return self.motion.apply(self.source[sample.indices], share), self.target[sample.indices]

    def moved_by(self, pose: OtherPose) -> Scene:
        """The same under another pose; its distances are those of this one."""
        shift = pose.scale * pose.rotation @ self.origin + pose.translation - self.origin
        motion = Motion(pose.scale, pose.rotation, shift, self.motion.centre)
        return replace(self, motion=motion)


def make_scene(
    outcome: Outcome,
    clouds: tuple[Floats, Floats],
    correspondences: tuple[Floats, Floats],
    bounds: Floats | None = None,
    limits: DrawLimits | None = None,
) -> Scene:
    """What to draw of an outcome.

    Parameters
    ----------
    outcome : Outcome
        The outcome.
    clouds : pair of ndarray, shapes (n, 3) and (m, 3)
        Source and target, metres.
    correspondences : pair of ndarray, shape (N, 3) each
        Matched points that the inliers of the outcome index, metres.
    bounds : ndarray, shape (N,), optional
        Largest residual of an inlier for each correspondence, metres.
    limits : DrawLimits, optional
        How much to draw.

    Returns
    -------
    Scene
        The same for the same arguments: samples are drawn with a fixed seed.

    Raises
    ------
    ValueError
        where these are not the correspondences, or not the bounds, that the outcome is about.
    """
    limits = limits or DrawLimits()
    source, target = correspondences
    _check_correspondences(outcome, source, target)
    residuals = np.linalg.norm(
        target - outcome.scale * source @ outcome.rotation.T - outcome.translation, axis=1
    )
    _check_bounds(outcome, residuals, bounds)
    origin = _origin(clouds)
    is_outlier = np.ones(len(source), dtype=bool)
    is_outlier[outcome.inliers] = False
    outliers = np.flatnonzero(is_outlier)
    shown = [_sample(np.arange(len(cloud)), limits.points) for cloud in clouds]
    source_cloud = clouds[0][shown[0].indices] - origin
    motion = _motion(outcome, clouds[0], origin)
    measured = _sample(np.arange(len(source_cloud)), _MEASURED)
    distances = None
    if outcome.is_of_clouds and outcome.has_pose and len(clouds[1]):
        near = _sample(np.arange(len(clouds[1])), _MEASURED_AGAINST)
        distances = nearest_distances(
            motion.apply(source_cloud[measured.indices]), clouds[1][near.indices] - origin
        )
    return Scene(
        source_cloud=source_cloud,
        target_cloud=clouds[1][shown[1].indices] - origin,
        source_points=shown[0],
        target_points=shown[1],
        source=source - origin,
        target=target - origin,
        motion=motion,
        inliers=_sample(outcome.inliers, limits.inliers),
        outliers=_sample(outliers, limits.outliers),
        residuals=residuals,
        bounds=bounds,
        graph=_graph(outcome, correspondences, outliers, bounds, limits.vertices),
        origin=origin,
        measured=measured,
        distances=distances,
    )


def weak_segment(scene: Scene, direction: WeakDirection) -> Floats:
    """Both ends, (2, 3), of the axis of a turn, or of a shift, through the middle of the target."""
    target = scene.target_cloud
    reach = 0.6 * float(np.ptp(target, axis=0).max()) if len(target) else 1.0
    centre = target.mean(axis=0) if len(target) else np.zeros(3)
    ends: Floats = centre + reach * np.outer([-1, 1], direction.axis)
    return ends


def nearest_distances(points: Floats, others: Floats) -> Floats:
    """Distance of each of the points, (n, 3), from the nearest of the others, (m, 3), m > 0.

    O(n m) by matrix products, a second for 4,000 and 50,000.
    """
    centre = others.mean(axis=0)
    points, others = points - centre, others - centre
    squares = (others**2).sum(axis=1)
    nearest = np.empty(len(points), dtype=np.int64)
    for start in range(0, len(points), _CHUNK):
        part = points[start : start + _CHUNK]
        nearest[start : start + _CHUNK] = np.argmin(squares - 2 * part @ others.T, axis=1)
    distances: Floats = np.linalg.norm(points - others[nearest], axis=1)
    return distances


def _check_correspondences(outcome: Outcome, source: Floats, target: Floats) -> None:
    expected = (outcome.num_correspondences, 3)
    for name, points in (("source", source), ("target", target)):
        if points.shape != expected:
            raise ValueError(f"{name}: shape {points.shape}, but the result is about {expected}")


def _check_bounds(outcome: Outcome, residuals: Floats, bounds: Floats | None) -> None:
    if bounds is None:
        return
    if bounds.shape != residuals.shape:
        raise ValueError(f"noise_bounds: shape {bounds.shape} instead of {residuals.shape}")
    ratios = residuals[outcome.inliers] / bounds[outcome.inliers]
    if np.any(ratios > 1 + 1e-6):
        raise ValueError(
            f"noise_bound: an inlier has {ratios.max():.4g} times the largest residual; give the "
            "points and the options that the result was computed with"
        )


def _sample(indices: Indices, most: int) -> Sample:
    if len(indices) <= most:
        return Sample(indices, len(indices))
    chosen = np.random.default_rng(0).choice(len(indices), most, replace=False)
    return Sample(indices[np.sort(chosen)], len(indices))


def _origin(clouds: tuple[Floats, Floats]) -> Floats:
    target = clouds[1]
    if len(target) == 0:
        return np.zeros(3)
    centre = (target.min(axis=0) + target.max(axis=0)) / 2
    extent = float(np.ptp(target, axis=0).max())
    return np.round(centre) if np.linalg.norm(centre) > _FAR * extent > 0 else np.zeros(3)


def _motion(outcome: Outcome, source_cloud: Floats, origin: Floats) -> Motion:
    # y - o = s R (x - o) + (s R o + t - o)
    shift = outcome.scale * outcome.rotation @ origin + outcome.translation - origin
    centre = source_cloud.mean(axis=0) - origin if len(source_cloud) else np.zeros(3)
    return Motion(outcome.scale, outcome.rotation, shift, centre)


def _graph(
    outcome: Outcome,
    correspondences: tuple[Floats, Floats],
    outliers: Indices,
    bounds: Floats | None,
    most: int,
) -> Graph | None:
    if bounds is None or not outcome.has_pose:
        return None
    inlier_sample, outlier_sample = _sample(outcome.inliers, most), _sample(outliers, most)
    vertices = np.concatenate([inlier_sample.indices, outlier_sample.indices])
    adjacency = consistency_graph(
        correspondences[0][vertices],
        correspondences[1][vertices],
        noise_bounds=bounds[vertices],
        scale=outcome.scale,
    )
    return Graph(inlier_sample, outlier_sample, adjacency)
