"""Registration problems, poses and their errors."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Pose:
    """Similarity x -> scale * rotation @ x + translation."""

    scale: float
    rotation: np.ndarray  # (3, 3)
    translation: np.ndarray  # (3,), metres

    def apply(self, points: np.ndarray) -> np.ndarray:
        """Transform (N, 3) points."""
        return self.scale * points @ self.rotation.T + self.translation

    def inverse(self) -> Pose:
        rotation = self.rotation.T
        return Pose(1 / self.scale, rotation, -(rotation @ self.translation) / self.scale)

    def after(self, first: Pose) -> Pose:
        """The pose that applies `first`, then this one."""
        return Pose(
            self.scale * first.scale,
            self.rotation @ first.rotation,
            self.apply(first.translation[None])[0],
        )


def pose_from_matrix(matrix: np.ndarray) -> Pose:
    """Pose of a (4, 4) matrix [sR t; 0 1]; where s is 0 the rotation is the identity."""
    linear = np.asarray(matrix, dtype=float)[:3, :3]
    scale = float(np.cbrt(max(np.linalg.det(linear), 0.0)))
    rotation = linear / scale if scale > 0 else np.eye(3)
    return Pose(scale, rotation, np.array(matrix, dtype=float)[:3, 3])


@dataclass(frozen=True)
class Problem:
    """Putative correspondences with their truth, which only the judge and the oracle may read."""

    source: np.ndarray  # (N, 3), metres
    target: np.ndarray  # (N, 3), metres
    truth: Pose
    noise_bound: float  # metres, target frame
    is_scale_known: bool  # if so it is 1
    model: np.ndarray  # (M, 3), source points whose mean error is the ADD
    seed: int = 0  # for methods that draw

    @property
    def is_inlier(self) -> np.ndarray:
        """(N,) bool: within the noise bound of the truth."""
        residuals = np.linalg.norm(self.target - self.truth.apply(self.source), axis=1)
        return residuals <= self.noise_bound

    def input_hash(self) -> str:
        """16 hex digits of all that every method is given."""
        digest = hashlib.sha256()
        for points in (self.source, self.target):
            digest.update(np.ascontiguousarray(points, dtype=np.float64).tobytes())
        digest.update(repr((float(self.noise_bound), self.is_scale_known, self.seed)).encode())
        return digest.hexdigest()[:16]


def errors_of(estimate: Pose, problem: Problem) -> dict[str, float]:
    """Errors of a pose: rotation in degrees, translation and mean point (ADD) in metres, scale."""
    truth = problem.truth
    chord = np.linalg.norm(estimate.rotation - truth.rotation) / np.sqrt(8)
    gaps = estimate.apply(problem.model) - truth.apply(problem.model)
    return {
        "rotation_deg": float(np.degrees(2 * np.arcsin(np.clip(chord, 0, 1)))),
        "translation": float(np.linalg.norm(estimate.translation - truth.translation)),
        "scale": float(abs(estimate.scale - truth.scale)),
        "mean_point": float(np.linalg.norm(gaps, axis=1).mean()),
    }


def fit_similarity(source: np.ndarray, target: np.ndarray, is_scale_known: bool) -> Pose:
    """Least-squares similarity of (N, 3) points (Umeyama 1991); scale 1 where it is known."""
    source_mean, target_mean = source.mean(axis=0), target.mean(axis=0)
    a, b = source - source_mean, target - target_mean
    u, singular, vt = np.linalg.svd(b.T @ a)
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    rotation = u @ np.diag(signs) @ vt
    spread = np.sum(a * a)
    scale = 1.0 if is_scale_known or spread == 0 else float(np.sum(singular * signs) / spread)
    return Pose(scale, rotation, target_mean - scale * rotation @ source_mean)


def easy_problem(is_scale_known: bool = True) -> Problem:
    """Forty exact matches and ten wrong ones: what every method has to solve."""
    random = np.random.default_rng(0)
    source = random.uniform(-0.5, 0.5, (50, 3))
    rotation = fit_similarity(random.normal(size=(9, 3)), random.normal(size=(9, 3)), True).rotation
    truth = Pose(1.0 if is_scale_known else 1.5, rotation, np.array([0.3, -0.2, 0.1]))
    target = truth.apply(source)
    target[:10] = truth.translation + random.uniform(-0.8, 0.8, (10, 3))
    return Problem(source, target, truth, 0.02, is_scale_known, model=source)
