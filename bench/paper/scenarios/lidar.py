"""The paper's LiDAR scan matching: structured outliers, known scale."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

import numpy as np

from paper.data import DataAbsent, data_root, pairs_of, read_points, read_pose
from paper.problem import Pose, Problem
from paper.scenarios.drawing import (
    draw_inliers,
    nearest_pairs,
    random_outliers,
    seed_of,
    structured_outliers,
)
from paper.scenarios.registry import KNOWN_SCALE, Case, experiment

MAX_DISTANCE = 0.2  # metres, of an inlier's points; the noise bound of all methods
NUM_INLIERS = 100
NUM_BASES = 50
NUM_OUTLIERS = 300
MAX_TRANSLATION = 10.0  # metres an axis
SENSOR_NOISE = 0.02  # metres an axis, added to the two halves of the nuScenes sweep
CRITERION = {"rotation_deg": 5.0, "translation": 0.6}


PROTOCOL = """\
100 matches of nearest neighbours within 0.2 m and 300 structured outliers in the neighbourhoods
(9 nearest points) of 50 random ones; rotation about z, translation of up to 10 m an axis; noise
bound 0.2 m. Only one nuScenes sweep could be had: its pair is two disjoint halves of it, each
with Gaussian noise of 0.02 m. The other pairs are real. A success is within 5 degrees and 0.6 m;
the paper does not say what its successes are."""


@experiment("lidar", "LiDAR scan matching, known scale", PROTOCOL)
def cases(quick: bool) -> Iterator[Case]:
    sweeps = [("nuscenes", path) for path in sorted((data_root() / "nuscenes").glob("*.ply"))]
    if not sweeps:
        raise DataAbsent(f"{data_root() / 'nuscenes'} is absent; set GMCR_DATA")
    scans = [*sweeps, *((folder.name, folder) for folder in pairs_of("lidar"))]
    for name, path in scans[:3] if quick else scans:
        for seed in range(3 if quick else 20):
            fields = {"scan": name, "seed": seed}
            yield Case(fields, lambda p=path, s=seed: make_problem(p, s), CRITERION, KNOWN_SCALE)


def make_problem(path: Path, seed: int) -> Problem:
    """Scans in a common frame, matched there, of which the target is then moved."""
    source, target, nearest = load_scans(path)
    own_seed = seed_of(path.stem, seed)
    random = np.random.default_rng(own_seed)
    aligned = Pose(1.0, np.eye(3), np.zeros(3))
    inliers = draw_inliers(nearest, NUM_INLIERS, random)
    bases = random_outliers(source, target, aligned, MAX_DISTANCE, NUM_BASES, random)
    outliers = structured_outliers(
        source, target, aligned, MAX_DISTANCE, bases, NUM_OUTLIERS, random
    )
    indices = random.permutation(np.vstack([inliers, outliers]))

    angle = random.uniform(-np.pi, np.pi)
    turn = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    truth = Pose(1.0, turn, random.uniform(-MAX_TRANSLATION, MAX_TRANSLATION, 3))
    matched = source[indices[:, 0]]
    return Problem(
        matched,
        truth.apply(target[indices[:, 1]]),
        truth,
        MAX_DISTANCE,
        is_scale_known=True,
        model=matched,
        seed=own_seed,
    )


@lru_cache(maxsize=1)
def load_scans(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Source in the target's frame, target, and the pairs of nearest points (K, 2).

    A single sweep is split into two disjoint halves, each with noise of its own.
    """
    if path.is_dir():
        truth = read_pose(path / "T_target_source.txt")
        source = truth.apply(read_points(path / "source.ply"))
        target = read_points(path / "target.ply")
    else:
        random = np.random.default_rng(0)
        points = random.permutation(read_points(path))
        points = points + random.normal(0, SENSOR_NOISE, points.shape)
        source, target = points[::2], points[1::2]
    same_frame = Pose(1.0, np.eye(3), np.zeros(3))
    return source, target, nearest_pairs(source, target, same_frame, MAX_DISTANCE)
