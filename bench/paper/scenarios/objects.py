"""The paper's localisation of real objects, on public scans: the robot's objects are not public."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

import gmcr
import numpy as np

from paper.data import listed, pairs_of, read_points, read_pose
from paper.problem import Pose, Problem
from paper.scenarios.drawing import (
    draw_inliers,
    nearest_pairs,
    random_outliers,
    random_pose,
    seed_of,
    structured_outliers,
)
from paper.scenarios.registry import UNKNOWN_SCALE, Case, experiment

UNITS = {"objects_ycb": 1.0, "objects_uwa": 1.0, "mian_views": 1e-3, "object_scans": 1.0}  # metres
SCALES = (0.5, 2.0)
NUM_INLIERS = 50
NUM_OUTLIERS = 50
NUM_BASES = 7  # as make_synthetic at 50 % outliers
MAX_POINTS = 20_000  # of a cloud
MAX_SHARE_OF_DIAMETER = 0.1  # a success, as usual for ADD


PROTOCOL = """\
The robot's objects of the paper are not public. These are real scans of household objects (YCB,
model against what an RGB-D camera saw), of models in a cluttered range scan (UWA), of range views
(Mian) and laser scans (hippo). The model is moved at random and scaled by 0.5 to 2; the paper
moves the view, but then its noise would scale too. Random and structured: 50 matches of nearest
neighbours within the overlap radius of the pair, which is the noise bound, and 50 outliers; 10
runs an object. FPFH: mutual matches and noise bound of `gmcr.match` with unknown scale and
normals outward; 5 runs an object; where fewer than 3 matches are right, least squares on the true
inliers has no pose, and no method can be right but by chance. No method is told the range of
scales. Lengths are in metres, the hippo's in its own units. A success has an ADD below 10 % of
the model's diameter."""


@experiment("objects", "Localisation of real objects, unknown scale", PROTOCOL)
def cases(quick: bool) -> Iterator[Case]:
    for set_name in UNITS:
        for folder in pairs_of(set_name)[: 1 if quick else None]:
            for setting in ("random", "structured", "fpfh"):
                num_seeds = 2 if quick else 5 if setting == "fpfh" else 10
                for seed in range(num_seeds):
                    yield _case(set_name, folder, setting, seed)


def _case(set_name: str, folder: Path, setting: str, seed: int) -> Case:
    fields = {"set": set_name, "object": folder.name, "setting": setting, "seed": seed}
    source, _, _, _ = load_pair(set_name, folder)
    diameter = float(np.linalg.norm(np.ptp(source, axis=0)))
    criterion = {"mean_point": MAX_SHARE_OF_DIAMETER * diameter}
    return Case(
        fields, lambda: make_problem(set_name, folder, setting, seed), criterion, UNKNOWN_SCALE
    )


def make_problem(set_name: str, folder: Path, setting: str, seed: int) -> Problem:
    """The model, moved and rescaled at random, against what the sensor saw of the object.

    The paper moves the view; moving the model instead leaves the noise bound that of the sensor.
    """
    source, target, truth, radius = load_pair(set_name, folder)
    own_seed = seed_of(set_name, folder.name, setting, seed)
    random = np.random.default_rng(own_seed)
    motion = random_pose(random, 1.0, SCALES)
    moved, moved_truth = motion.apply(source), truth.after(motion.inverse())
    if setting == "fpfh":
        # toward a viewpoint the normals of a model and of a view of it would point to other sides
        frontend = gmcr.FrontendOptions(orientation="outward")
        matches = gmcr.match(moved, target, frontend, scale_mode="estimated")
        matched_source, matched_target = np.array(matches.source), np.array(matches.target)
        noise_bound = matches.noise_bound
    else:
        noise_bound = radius
        indices = _draw(source, target, truth, radius, setting, random)
        matched_source, matched_target = moved[indices[:, 0]], target[indices[:, 1]]
    return Problem(
        matched_source,
        matched_target,
        moved_truth,
        noise_bound,
        is_scale_known=False,
        model=moved,
        seed=own_seed,
    )


def _draw(
    source: np.ndarray,
    target: np.ndarray,
    truth: Pose,
    radius: float,
    setting: str,
    random: np.random.Generator,
) -> np.ndarray:
    """(100, 2) indices in random order: half of them nearest neighbours, half outliers."""
    inliers = draw_inliers(nearest_pairs(source, target, truth, radius), NUM_INLIERS, random)
    if setting == "random":
        outliers = random_outliers(source, target, truth, radius, NUM_OUTLIERS, random)
    else:
        bases = random_outliers(source, target, truth, radius, NUM_BASES, random)
        rest = structured_outliers(
            source, target, truth, radius, bases, NUM_OUTLIERS - NUM_BASES, random
        )
        outliers = np.vstack([bases, rest])
    return random.permutation(np.vstack([inliers, outliers]))


@cache
def load_pair(set_name: str, folder: Path) -> tuple[np.ndarray, np.ndarray, Pose, float]:
    """Source and target points, the truth and the radius of the pair's overlap, in metres."""
    unit = UNITS[set_name]
    random = np.random.default_rng(0)
    clouds = []
    for name in ("source", "target"):
        points = unit * read_points(folder / f"{name}.ply")
        kept = random.permutation(len(points))[:MAX_POINTS]
        clouds.append(points[np.sort(kept)])
    truth = read_pose(folder / "T_target_source.txt")
    truth = Pose(1.0, truth.rotation, unit * truth.translation)
    return clouds[0], clouds[1], truth, unit * listed(set_name, folder.name, "radius")
