"""RANSAC with 10,000 fixed iterations that scores a pose by the given matches."""

from __future__ import annotations

from typing import Any

import numpy as np

from paper.methods.registry import Look, Method, Outcome, register
from paper.problem import Pose, Problem, fit_similarity

NUM_SAMPLES = 10_000
CHUNK = 2_000_000  # residuals scored at once


@register
class Ransac10k(Method):
    name = "ransac10k"
    look = Look("RANSAC10k", 31, "#cc79a7", "D", (0, (1, 1.5)))
    settings = (
        "our own in numpy: 10,000 samples of 3, distance check at the noise bound, scored by the "
        "number of given matches within the noise bound, least squares on the best set"
    )

    def prepare(self, problem: Problem, time_limit: float) -> None:
        self._problem = problem

    def solve(self) -> Pose | None:
        problem = self._problem
        count = len(problem.source)
        if count < 3:
            return None
        random = np.random.default_rng(problem.seed)
        samples = random.integers(0, count, (NUM_SAMPLES, 3))
        scale, rotation, translation = _poses_of_triangles(
            problem.source[samples], problem.target[samples], problem
        )
        best, best_score = None, 2
        step = max(1, CHUNK // count)
        for start in range(0, len(scale), step):
            part = slice(start, start + step)
            linear = scale[part, None, None] * rotation[part]
            moved = problem.source @ linear.transpose(0, 2, 1) + translation[part, None]
            gaps = np.einsum("kni,kni->kn", moved - problem.target, moved - problem.target)
            scores = (gaps <= problem.noise_bound**2).sum(axis=1)
            if scores.size and scores.max() > best_score:
                k = int(scores.argmax())
                best_score = int(scores[k])
                best = gaps[k] <= problem.noise_bound**2
        if best is None:
            return None
        return fit_similarity(problem.source[best], problem.target[best], problem.is_scale_known)

    def outcome(self, result: Any) -> Outcome:
        if result is None:
            return Outcome("no_pose", reason="no sample has 3 matches within the noise bound")
        return Outcome("ok", result)


def _poses_of_triangles(
    source: np.ndarray, target: np.ndarray, problem: Problem
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Least-squares poses of those of the (K, 3, 3) triangles that fit within the noise bound."""
    source_edges, target_edges = _edge_lengths(source), _edge_lengths(target)
    scale = np.ones(len(source))
    if not problem.is_scale_known:
        size = np.linalg.norm(source_edges, axis=1)
        scale = np.divide(np.linalg.norm(target_edges, axis=1), size, out=scale, where=size > 0)
    gaps = np.abs(target_edges - scale[:, None] * source_edges).max(axis=1)
    alike = (gaps <= 2 * problem.noise_bound) & (source_edges.min(axis=1) > 0) & (scale > 0)
    source, target, scale = source[alike], target[alike], scale[alike]

    source_centre, target_centre = source.mean(axis=1), target.mean(axis=1)
    a, b = source - source_centre[:, None], target - target_centre[:, None]
    u, _, vt = np.linalg.svd(b.transpose(0, 2, 1) @ a)
    u[:, :, 2] *= np.linalg.det(u @ vt)[:, None]
    rotation = u @ vt
    linear = scale[:, None, None] * rotation
    translation = target_centre - np.einsum("kij,kj->ki", linear, source_centre)
    residuals = np.linalg.norm(b - a @ linear.transpose(0, 2, 1), axis=2)
    fits = (residuals <= problem.noise_bound).all(axis=1)
    return scale[fits], rotation[fits], translation[fits]


def _edge_lengths(triangles: np.ndarray) -> np.ndarray:
    """(K, 3) lengths of the edges of (K, 3, 3) triangles."""
    return np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2)
