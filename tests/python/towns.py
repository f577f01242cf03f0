"""A yard of boxes on level ground, and what a scanner in it sees of them."""

from __future__ import annotations

import numpy as np

EXTENT = 60.0  # metres
REACH = 22.0
HEIGHT = 1.6  # of the scanner


def town_points(seed: int = 3) -> np.ndarray:
    """Ground and the walls of 45 boxes, about 40 points a square metre."""
    rng = np.random.default_rng(seed)
    ground = np.column_stack([rng.uniform(0, EXTENT, (150_000, 2)), np.zeros(150_000)])
    parts = [ground]
    for _ in range(45):
        size = np.array([*rng.uniform(1, 7, 2), rng.uniform(1.5, 7)])
        angle = rng.uniform(0, np.pi)
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        centre = rng.uniform(3, EXTENT - 3, 2)
        count = int(40 * 2 * (size[0] + size[1]) * size[2])
        walls = rng.uniform(-0.5, 0.5, (count, 3)) * size
        side = rng.integers(0, 2, count)
        rows = np.arange(count)
        walls[rows, side] = np.sign(walls[rows, side]) * size[side] / 2
        walls[:, :2] = walls[:, :2] @ turn.T + centre
        walls[:, 2] += size[2] / 2
        parts.append(walls)
    return np.vstack(parts)


def pose_at(x: float, y: float, heading: float) -> np.ndarray:
    """Matrix that puts a scanner there, level."""
    cosine, sine = np.cos(heading), np.sin(heading)
    return np.array([[cosine, -sine, 0, x], [sine, cosine, 0, y], [0, 0, 1, HEIGHT], [0, 0, 0, 1]])


def sweep(points: np.ndarray, pose: np.ndarray, seed: int = 4) -> np.ndarray:
    """Half of the points about the scanner, with noise, in its frame."""
    rng = np.random.default_rng(seed)
    local = (points - pose[:3, 3]) @ pose[:3, :3]
    near = local[np.linalg.norm(local, axis=1) < REACH]
    kept = near[rng.random(len(near)) < 0.5]
    return kept + rng.normal(0, 0.01, kept.shape)
