"""Pairs of clouds of unlike sensors, each beside the same pair at equal density."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import scenes
from paper.data import data_root, pairs_of, read_points
from scenes import Cloud, Scan

THINNING = 8
NUM_RINGS = 64  # of a scan; every fourth is kept
CAMERA_FIELD = np.radians([60.0, 45.0])
CAMERA_NOISE = 1.5e-3  # of the square of the distance in metres, as structured light has
CAMERA_PIXELS = (320, 240)
SPINNING_SETS = ("lidar", "kitti_fpfh")
NOT_SPINNING = ("pcl_room_scan", "lpm_car")
NUM_VIEWS = 8


@dataclass(frozen=True)
class Case:
    """A pair of unlike clouds, and the same at equal density."""

    group: str
    name: str
    equal: Scan
    unlike: Scan


def random_of(seed: int, name: str) -> np.random.Generator:
    return np.random.default_rng([seed, *name.encode()])


def real_pair(folder: Path, seed: int) -> Scan:
    """The source is turned about its sensor at random: other voxels for each seed."""
    source, target = (read_points(folder / f"{side}.ply") for side in ("source", "target"))
    truth = np.loadtxt(folder / "T_target_source.txt")
    turn = scenes.pose(scenes.random_rotation(random_of(seed, folder.name)), np.zeros(3))
    return Scan(
        f"{folder.parent.name}/{folder.name}",
        scenes.moved(source, turn),
        target,
        truth @ np.linalg.inv(turn),
    )


def with_source(scan: Scan, is_kept: np.ndarray) -> Scan:
    return Scan(scan.name, scan.source[is_kept], scan.target, scan.truth)


def thinned(folders: list[Path], seed: int) -> Iterator[Case]:
    """One point of eight of the source, at random."""
    for folder in folders:
        pair = real_pair(folder, seed)
        is_kept = random_of(seed, folder.name).random(len(pair.source)) < 1 / THINNING
        yield Case("source thinned by 8", pair.name, pair, with_source(pair, is_kept))


def rings(points: Cloud) -> np.ndarray:
    """Number of the ring of each point, by its elevation from the origin."""
    elevation = np.arctan2(points[:, 2], np.hypot(points[:, 0], points[:, 1]))
    low, high = np.quantile(elevation, [0.005, 0.995])
    return np.floor((elevation - low) / (high - low) * NUM_RINGS).astype(int)


def every_fourth_ring(folders: list[Path], seed: int) -> Iterator[Case]:
    """Of scans by spinning sensors, whose origin is the sensor."""
    for folder in folders:
        if folder.parent.name not in SPINNING_SETS or folder.name in NOT_SPINNING:
            continue
        pair = real_pair(folder, seed)
        is_kept = rings(read_points(folder / "source.ply")) % 4 == seed % 4
        yield Case("every 4th ring", pair.name, pair, with_source(pair, is_kept))


def spinning_rays(num_rings: int, elevation_deg: tuple[float, float]) -> Cloud:
    elevation = np.radians(np.linspace(*elevation_deg, num_rings))[:, None]
    azimuth = np.linspace(0, 2 * np.pi, 1000, endpoint=False)[None, :]
    rays = np.stack(
        [
            np.cos(elevation) * np.cos(azimuth),
            np.cos(elevation) * np.sin(azimuth),
            np.sin(elevation) + 0 * azimuth,
        ],
        axis=2,
    )
    return rays.reshape(-1, 3)


def camera_rays() -> Cloud:
    """Of a depth camera that looks along x."""
    across, up = (
        np.tan(np.linspace(-field / 2, field / 2, count))
        for field, count in zip(CAMERA_FIELD, CAMERA_PIXELS, strict=True)
    )
    y, z = np.meshgrid(across, up)
    rays = np.stack([np.ones(y.size), y.ravel(), z.ravel()], axis=1)
    return rays / np.linalg.norm(rays, axis=1, keepdims=True)


def two_places(random: np.random.Generator, size: np.ndarray) -> list[np.ndarray]:
    step = (
        random.uniform(0.4, 1.2)
        * scenes.rotation_about(np.array([0.0, 0, 1]), random.uniform(0, 2 * np.pi))[0]
    )
    return [scenes.sensor_at(random, size / 2 + side * step / 2) for side in (-1, 1)]


def rooms_by_rings(count: int, seed: int) -> Iterator[Case]:
    """16 rings against 64 in a room."""
    for number in range(count):
        random = np.random.default_rng([11, seed, number])
        boxes, size = scenes.room_boxes(random)
        a, b = two_places(random, size)
        few, many = (
            scenes.scan_of(boxes, a, random, 30, spinning_rays(n, (-35, 35))) for n in (16, 64)
        )
        target = scenes.scan_of(boxes, b, random, 30, spinning_rays(64, (-35, 35)))
        truth = np.linalg.inv(b) @ a
        name = f"room {number}"
        yield Case(
            "16 rings of 64, synthetic",
            name,
            Scan(name, many, target, truth),
            Scan(name, few, target, truth),
        )


def with_camera_noise(points: Cloud, random: np.random.Generator) -> Cloud:
    """Noise along the rays that grows with the square of the distance."""
    distance = np.linalg.norm(points, axis=1, keepdims=True)
    error = CAMERA_NOISE * distance * random.normal(size=distance.shape)
    return points * (1 + error)


def rooms_by_camera(count: int, seed: int) -> Iterator[Case]:
    """A depth camera against a scanner that looks all around; the same view by such a scanner."""
    for number in range(count):
        random = np.random.default_rng([12, seed, number])
        boxes, size = scenes.room_boxes(random)
        a, b = two_places(random, size)
        # away from the middle, toward it
        a[:3, :3] = scenes.rotation_about(np.array([0.0, 0, 1]), random.uniform(0, 2 * np.pi))
        a[:3, 3] -= 1.2 * a[:3, 0]
        a[:3, 3] = np.clip(a[:3, 3], 0.3, size - 0.3)
        target = scenes.scan_of(boxes, b, random, 30)
        seen = scenes.scan_of(boxes, a, random, 30, camera_rays())
        scanned = scenes.scan_of(boxes, a, random, 30)
        is_seen = in_view(scanned, np.eye(3))
        truth = np.linalg.inv(b) @ a
        name = f"room {number}"
        yield Case(
            "depth camera, synthetic",
            name,
            Scan(name, scanned[is_seen], target, truth),
            Scan(name, with_camera_noise(seen, random), target, truth),
        )


def in_view(points: Cloud, turn: np.ndarray) -> np.ndarray:
    """Whether a camera at the origin, whose axes are the columns, along the first, sees them."""
    along, across, up = (points @ turn).T
    tangents = np.tan(CAMERA_FIELD / 2)
    return (along > 0) & (abs(across) < tangents[0] * along) & (abs(up) < tangents[1] * along)


def scans_by_camera(seed: int) -> Iterator[Case]:
    """Views cut from a terrestrial scan of a room, with the noise and the pixels of a camera."""
    folder = data_root() / "lidar" / "pcl_room_scan"
    pair = real_pair(folder, seed)
    random = random_of(seed, "camera")
    middle = np.median(pair.source, axis=0)
    for number in range(NUM_VIEWS):
        towards = pair.source[random.integers(len(pair.source))] - middle
        turn = turn_to(towards)
        centre = middle - 0.6 * np.linalg.norm(towards) * turn[:, 0]
        view = pair.source[in_view(pair.source - centre, turn)] - centre
        view = view[is_unhidden(view @ turn)]
        truth = pair.truth @ scenes.pose(np.eye(3), centre)
        name = f"{pair.name} view {number}"
        noisy = with_camera_noise(view, random)
        kept = noisy[one_a_pixel(noisy @ turn)]
        yield Case(
            "depth camera",
            name,
            Scan(name, view, pair.target, truth),
            Scan(name, kept, pair.target, truth),
        )


def turn_to(towards: np.ndarray) -> np.ndarray:
    """Rotation whose first column points there."""
    first = towards / np.linalg.norm(towards)
    second = np.cross([0.2, 0.3, 1.0], first)
    second /= np.linalg.norm(second)
    return np.column_stack([first, second, np.cross(first, second)])


def pixels_of(points: Cloud, count: tuple[int, int]) -> np.ndarray:
    """(N, 2) pixels of so many across and up at which a camera along x sees the points."""
    tangents = points[:, 1:] / points[:, :1]
    return np.floor((tangents / np.tan(CAMERA_FIELD / 2) + 1) / 2 * count).astype(int)


def is_unhidden(points: Cloud) -> np.ndarray:
    """Whether nothing lies clearly before the points, as a camera along x sees them."""
    _, pixel = np.unique(pixels_of(points, (80, 60)), axis=0, return_inverse=True)
    foremost = np.full(pixel.max() + 1, np.inf)
    np.minimum.at(foremost, pixel.ravel(), points[:, 0])
    return points[:, 0] < 1.1 * foremost[pixel.ravel()]


def one_a_pixel(points: Cloud) -> np.ndarray:
    """The nearest point of each pixel."""
    pixels = pixels_of(points, CAMERA_PIXELS)
    order = np.argsort(points[:, 0], kind="stable")
    _, first = np.unique(pixels[order], axis=0, return_index=True)
    return order[first]


def seen_by_scanner(
    points: Cloud, towards: np.ndarray, num_rings: int, noise: float, random: np.random.Generator
) -> tuple[Cloud, np.ndarray]:
    """What lies foremost in cells of view of a model, on rings alone where their number is not 0.

    The sensor stands three diameters away. Returns the points in its frame, and its pose in the
    frame of the model.
    """
    size = np.linalg.norm(np.ptp(points, axis=0))
    sensor = scenes.pose(
        turn_to(-towards), points.mean(axis=0) + 3 * size * towards / np.linalg.norm(towards)
    )
    local = scenes.moved(points, np.linalg.inv(sensor))
    distance = np.linalg.norm(local, axis=1)
    azimuth, elevation = local[:, 1] / local[:, 0], local[:, 2] / local[:, 0]
    cell = 0.012
    cells = np.floor(np.column_stack([azimuth, elevation]) * 3 / cell).astype(int)
    _, where = np.unique(cells, axis=0, return_inverse=True)
    foremost = np.full(where.max() + 1, np.inf)
    np.minimum.at(foremost, where.ravel(), distance)
    is_seen = distance < foremost[where.ravel()] + 2 * cell * size
    if num_rings:
        at = (elevation - elevation.min()) / np.ptp(elevation) * num_rings
        is_seen &= abs(at % 1 - 0.5) < 0.125
    seen = local[is_seen]
    seen = seen * (1 + noise * size / distance[is_seen] * random.normal(size=len(seen)))[:, None]
    return seen, sensor


def models_by_scanner(seed: int) -> Iterator[Case]:
    """Half of the points of a scanned model against a scan by 32 rings made of the other half."""
    clouds = {
        path.stem: read_points(path) for path in sorted((data_root() / "models").glob("*.ply"))
    }
    for name, points in clouds.items():
        yield from model_by_scanner("dense model, real shapes", name, points, seed)


def bumps_by_scanner(count: int, seed: int) -> Iterator[Case]:
    for number in range(count):
        random = np.random.default_rng([13, seed, number])
        points = scenes.bumpy(random, 120_000, np.random.default_rng([14, seed, number]))
        yield from model_by_scanner("dense model, synthetic", f"object {number}", points, seed)


def model_by_scanner(group: str, name: str, points: Cloud, seed: int) -> Iterator[Case]:
    random = random_of(seed, name)
    is_model = random.random(len(points)) < 0.5
    for number in range(NUM_VIEWS // 4):
        towards = random.normal(size=3)
        scans = []
        for num_rings, noise in ((0, 0.0), (32, 0.001)):
            seen, sensor = seen_by_scanner(points[~is_model], towards, num_rings, noise, random)
            scans.append(
                Scan(f"{name} view {number}", points[is_model], seen, np.linalg.inv(sensor))
            )
        yield Case(group, scans[0].name, *scans)


def scenes_by_rows(folders: list[Path], seed: int) -> Iterator[Case]:
    """Models in range images of scenes of which every fourth row is left."""
    for folder in folders:
        if folder.parent.name not in ("objects_uwa", "objects_ycb", "objects_rgbd"):
            continue
        pair = real_pair(folder, seed)
        # rows from above to below, as the camera sees them
        rows = np.floor(pair.target[:, 1] / abs(pair.target[:, 2]).clip(1e-9) * 300).astype(int)
        few = pair.target[rows % 4 == seed % 4]
        unlike = Scan(pair.name, pair.source, few, pair.truth)
        yield Case("dense model, scene of every 4th row", pair.name, pair, unlike)


def unrelated(folders: list[Path], seed: int) -> Iterator[Scan]:
    """The thinned source of one pair and the target of another: no pose is right."""
    for folder, other in zip(folders, folders[13:] + folders[:13], strict=True):
        if folder.parent == other.parent:
            continue
        pair = real_pair(folder, seed)
        is_kept = random_of(seed, folder.name).random(len(pair.source)) < 1 / THINNING
        target = read_points(other / "target.ply")
        yield Scan(f"{folder.name} / {other.name}", pair.source[is_kept], target, None)


def all_cases(folders: list[Path], size: int, seed: int) -> Iterator[Case]:
    yield from thinned(folders, seed)
    yield from every_fourth_ring([*folders, *pairs_of("kitti_fpfh")], seed)
    yield from rooms_by_rings(size, seed)
    yield from scans_by_camera(seed)
    yield from rooms_by_camera(size, seed)
    yield from scenes_by_rows(folders, seed)
    yield from models_by_scanner(seed)
    yield from bumps_by_scanner(size // 2, seed)
