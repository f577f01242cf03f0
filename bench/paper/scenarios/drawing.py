"""Random motions and wrong matches for experiments on real clouds."""

from __future__ import annotations

import zlib

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from paper.problem import Pose

NEIGHBOURS = 9  # of a base: as in make_synthetic
MAX_DRAWS = 10_000


def seed_of(*case: object) -> int:
    """A seed of its own for each case, the same everywhere: 31 bits."""
    return zlib.crc32("|".join(map(str, case)).encode()) & 0x7FFFFFFF


def random_pose(
    random: np.random.Generator, max_translation: float, scale_range: tuple[float, float] = (1, 1)
) -> Pose:
    """Uniform rotation, translation uniform in a cube (metres, half an edge), uniform scale."""
    scale = random.uniform(*scale_range)
    rotation = Rotation.random(random_state=random).as_matrix()
    return Pose(scale, rotation, random.uniform(-max_translation, max_translation, 3))


def nearest_pairs(
    source: np.ndarray, target: np.ndarray, truth: Pose, max_distance: float
) -> np.ndarray:
    """(K, 2) indices of source points and their nearest target points nearer than a distance."""
    distances, nearest = cKDTree(target).query(truth.apply(source), workers=-1)
    near = distances < max_distance
    return np.column_stack([np.flatnonzero(near), nearest[near]])


def draw_inliers(pairs: np.ndarray, count: int, random: np.random.Generator) -> np.ndarray:
    """`count` of the pairs without repetition.

    Raises
    ------
    ValueError
        Where there are fewer.
    """
    if len(pairs) < count:
        raise ValueError(f"pairs: {len(pairs)}, {count} are needed")
    return pairs[random.choice(len(pairs), count, replace=False)]


def random_outliers(
    source: np.ndarray,
    target: np.ndarray,
    truth: Pose,
    noise_bound: float,
    count: int,
    random: np.random.Generator,
) -> np.ndarray:
    """(count, 2) indices of random source and target points further apart than the noise bound."""
    kept = np.empty((0, 2), dtype=int)
    for _ in range(MAX_DRAWS):
        drawn = np.column_stack(
            [random.integers(len(source), size=count), random.integers(len(target), size=count)]
        )
        gaps = np.linalg.norm(target[drawn[:, 1]] - truth.apply(source[drawn[:, 0]]), axis=1)
        kept = np.vstack([kept, drawn[gaps > noise_bound]])
        if len(kept) >= count:
            return kept[:count]
    raise ValueError(f"noise_bound: {noise_bound} leaves no room for outliers")


def structured_outliers(
    source: np.ndarray,
    target: np.ndarray,
    truth: Pose,
    noise_bound: float,
    bases: np.ndarray,
    count: int,
    random: np.random.Generator,
) -> np.ndarray:
    """(count, 2) indices of outliers in the neighbourhoods of wrong matches.

    Each is drawn near a random one of the (B, 2) `bases`: a source among the base's source and its
    nearest neighbours, a target likewise, further apart than the noise bound under the truth.
    """
    near_source = cKDTree(source).query(source[bases[:, 0]], NEIGHBOURS + 1)[1]
    near_target = cKDTree(target).query(target[bases[:, 1]], NEIGHBOURS + 1)[1]
    kept = np.empty((0, 2), dtype=int)
    for _ in range(MAX_DRAWS):
        base = random.integers(len(bases), size=count)
        which = random.integers(NEIGHBOURS + 1, size=(2, count))
        drawn = np.column_stack([near_source[base, which[0]], near_target[base, which[1]]])
        gaps = np.linalg.norm(target[drawn[:, 1]] - truth.apply(source[drawn[:, 0]]), axis=1)
        kept = np.unique(np.vstack([kept, drawn[gaps > noise_bound]]), axis=0)
        if len(kept) >= count:
            return kept[random.permutation(len(kept))[:count]]
    raise ValueError(f"noise_bound: {noise_bound} leaves no room for structured outliers")
