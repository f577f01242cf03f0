"""Synthetic scans with a known answer, of the kinds that verdicts on clouds have to tell apart."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter, minimum_filter

Cloud = np.ndarray  # (N, 3), metres
NUM_RAYS = 30_000


@dataclass(frozen=True)
class Scan:
    """Two clouds and the 4 x 4 pose of the second frame from the first; None: there is none."""

    name: str
    source: Cloud
    target: Cloud
    truth: np.ndarray | None


def rotation_about(axis: np.ndarray, angle: float) -> np.ndarray:
    x, y, z = axis / np.linalg.norm(axis)
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew


def pose(rotation: np.ndarray, translation: np.ndarray) -> np.ndarray:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, translation
    return matrix


def moved(points: Cloud, matrix: np.ndarray) -> Cloud:
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def random_rotation(random: np.random.Generator) -> np.ndarray:
    return rotation_about(random.normal(size=3), random.uniform(0.3, np.pi))


def directions(random: np.random.Generator) -> Cloud:
    """Of a sensor that looks all around, in a random roll."""
    index = np.arange(NUM_RAYS) + 0.5
    height, angle = 1 - 2 * index / NUM_RAYS, np.pi * (1 + 5**0.5) * index
    ring = np.sqrt(1 - height**2)
    fibonacci = np.stack([ring * np.cos(angle), ring * np.sin(angle), height], axis=1)
    return fibonacci @ random_rotation(random).T


def distances_to_boxes(origin: np.ndarray, rays: Cloud, boxes: np.ndarray) -> np.ndarray:
    """Along each ray: out of the first box, into the others, each by its two corners (B, 2, 3)."""
    with np.errstate(divide="ignore"):
        to_sides = (boxes[:, None] - origin) / rays[:, None]  # box, ray, side, axis
    enter, leave = to_sides.min(axis=2).max(axis=2), to_sides.max(axis=2).min(axis=2)
    hits = np.where((enter < leave) & (enter > 0), enter, np.inf)
    return np.minimum(leave[0], hits[1:].min(axis=0, initial=np.inf))


def scan_of(
    boxes: np.ndarray,
    sensor: np.ndarray,
    random: np.random.Generator,
    farthest: float,
    rays: Cloud | None = None,
) -> Cloud:
    """What a sensor sees, in its frame, all around by default; noise of 8 mm along the rays."""
    rays = directions(random) if rays is None else rays
    turn, origin = sensor[:3, :3], sensor[:3, 3]
    distance = distances_to_boxes(origin, rays @ turn.T, boxes)
    distance = distance + random.normal(scale=0.008, size=len(rays))
    is_seen = distance < farthest
    return rays[is_seen] * distance[is_seen, None]


def sensor_at(random: np.random.Generator, place: np.ndarray) -> np.ndarray:
    turn = rotation_about(np.array([0.0, 0, 1]), random.uniform(-np.pi, np.pi))
    tilt = rotation_about(random.normal(size=3), random.uniform(0, 0.1))
    return pose(tilt @ turn, place)


def two_scans(
    name: str, boxes: np.ndarray, places: Cloud, random: np.random.Generator, farthest: float
) -> Scan:
    a, b = (sensor_at(random, place) for place in places)
    clouds = [scan_of(boxes, sensor, random, farthest) for sensor in (a, b)]
    return Scan(name, *clouds, np.linalg.inv(b) @ a)


def room_boxes(random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Walls with furniture along them, and the size of the room."""
    size = random.uniform([5, 4, 2.6], [9, 7, 3.2])
    boxes = [[np.zeros(3), size]]
    for _ in range(random.integers(6, 13)):
        extent = random.uniform([0.3, 0.3, 0.3], [1.6, 1.0, 2.2])
        corner = random.uniform(0, 1, 3) * (size - extent)
        corner[2] = 0
        side = random.integers(4)
        corner[side // 2] = 0 if side % 2 else (size - extent)[side // 2]
        boxes.append([corner, corner + extent])
    return np.array(boxes), size


def rooms(count: int) -> Iterator[Scan]:
    for seed in range(count):
        random = np.random.default_rng([1, seed])
        boxes, size = room_boxes(random)
        middle = size / 2 + random.uniform(-0.3, 0.3, 3) * [1, 1, 0]
        step = (
            random.uniform(0.4, 1.2)
            * rotation_about(np.array([0.0, 0, 1]), random.uniform(0, 6))[0]
        )
        places = np.array([middle - step / 2, middle + step / 2])
        yield two_scans(f"room {seed}", boxes, places, random, 30)


def corridors(count: int) -> Iterator[Scan]:
    """Doors at every 4 m, and no end in sight: aliases fit as well."""
    for seed in range(count):
        random = np.random.default_rng([2, seed])
        width, depth = random.uniform(2, 3), random.uniform(0.1, 0.25)
        boxes = [[[-60, 0, 0], [60, width, 2.7]]]
        for x in np.arange(-60, 60, 4):
            for y in (0, width - depth):
                boxes.append([[x, y, 0], [x + 1, y + depth, 2.1]])
        places = np.array([[0, width / 2, 1.3], [random.uniform(2, 7), width / 2, 1.4]])
        yield two_scans(f"corridor {seed}", np.array(boxes), places, random, 14)


def grounds(count: int) -> Iterator[Scan]:
    """Nearly flat, seen by two cameras, nothing stands on it."""
    for seed in range(count):
        random = np.random.default_rng([3, seed])
        waves, phases = random.normal(size=(5, 2)), random.uniform(0, 6, 5)
        height = random.choice([0.0, 0.004, 0.02])
        views = []
        for centre in random.uniform(-0.6, 0.6, (2, 2)):
            plan = centre + random.uniform(-2.5, 2.5, (20_000, 2))
            level = height * np.sin(plan @ waves.T + phases).sum(axis=1)
            level += random.normal(scale=0.006, size=len(plan))
            sensor = pose(
                random_rotation(random), random.uniform(-1, 1, 3) + np.array([*centre, 4])
            )
            views.append((np.column_stack([plan, level]), sensor))
        (a, from_a), (b, from_b) = views
        yield Scan(
            f"ground {seed}",
            moved(a, np.linalg.inv(from_a)),
            moved(b, np.linalg.inv(from_b)),
            np.linalg.inv(from_b) @ from_a,
        )


def bumpy(random: np.random.Generator, count: int, shape: np.random.Generator) -> Cloud:
    """Points of a bumpy closed surface about 1 across, by its shape."""
    waves, heights = shape.normal(size=(6, 3)) * 3, shape.uniform(0.03, 0.1, 6)
    towards = random.normal(size=(count, 3))
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    radius = 0.4 + np.sin(towards @ waves.T) @ heights
    points = towards * radius[:, None] * shape.uniform(0.6, 1, 3)
    return points + random.normal(scale=0.001, size=points.shape)


def seen_from(points: Cloud, towards: np.ndarray, random: np.random.Generator) -> Scan:
    """The side of a star-shaped object that faces a sensor, in the sensor's frame, and its pose."""
    facing = points @ towards > 0.05 * np.linalg.norm(points, axis=1)
    sensor = pose(random_rotation(random), 3 * towards)
    return Scan("", moved(points[facing], np.linalg.inv(sensor)), points, sensor)


def objects(count: int) -> Iterator[Scan]:
    for seed in range(count):
        random = np.random.default_rng([4, seed])
        towards = random_rotation(random)[0]
        other = rotation_about(random.normal(size=3), random.uniform(0.3, 0.9)) @ towards
        views = [
            seen_from(bumpy(random, 30_000, np.random.default_rng(seed)), side, random)
            for side in (towards, other)
        ]
        a, b = views
        yield Scan(f"object {seed}", a.source, b.source, np.linalg.inv(b.truth) @ a.truth)


def halves(count: int) -> Iterator[Scan]:
    """Opposite sides of an object: nothing is seen twice."""
    for seed in range(count):
        random = np.random.default_rng([5, seed])
        towards = random_rotation(random)[0]
        views = [
            seen_from(bumpy(random, 30_000, np.random.default_rng(seed)), side, random)
            for side in (towards, -towards)
        ]
        a, b = views
        yield Scan(f"halves {seed}", a.source, b.source, np.linalg.inv(b.truth) @ a.truth)


def boxes_and_prisms(count: int) -> Iterator[Scan]:
    """Bodies that some turn maps onto themselves, seen from two sides: any answer may be wrong."""
    for seed in range(count):
        random = np.random.default_rng([6, seed])
        size = random.uniform(0.4, 1, 3)
        views = []
        for towards in (random.normal(size=3), random.normal(size=3)):
            points = random.uniform(-0.5, 0.5, (24_000, 3))
            sides = random.integers(6, size=len(points))
            points[np.arange(len(points)), sides // 2] = sides % 2 - 0.5
            normals = np.zeros_like(points)
            normals[np.arange(len(points)), sides // 2] = 2 * (sides % 2) - 1
            towards = towards / np.linalg.norm(towards)
            points = points[normals @ towards > 0] * size
            points += random.normal(scale=0.001, size=points.shape)
            sensor = pose(random_rotation(random), 3 * towards)
            views.append((moved(points, np.linalg.inv(sensor)), sensor))
        (a, from_a), (b, from_b) = views
        yield Scan(f"box {seed}", a, b, np.linalg.inv(from_b) @ from_a)


def depth_image(points: Cloud, random: np.random.Generator, noise: float) -> Scan:
    """What a depth camera sees of a model about 0.2 m large at 0.75 m, off by `noise` metres along
    the rays, half of it alike over some pixels; and where the model lies."""
    turn, focal, size = random_rotation(random), 400.0, 640
    centre = points.mean(axis=0)
    place = np.array([*random.uniform(-0.1, 0.1, 2), 0.75])
    truth = pose(turn, place - turn @ centre)
    seen = moved(points, truth)
    column, row = (np.round(focal * seen[:, :2] / seen[:, 2:]) + size // 2).astype(int).T
    depth = np.full((size, size), np.inf)
    np.minimum.at(depth, (row, column), seen[:, 2])
    gap = 0.06 * np.ptp(points, axis=0).max()  # what lies behind shows through between the points
    rows, columns = np.nonzero(np.isfinite(depth) & (depth < minimum_filter(depth, 7) + gap))
    smooth = gaussian_filter(random.normal(size=depth.shape), 2.0)
    off = 0.7 * (smooth / smooth.std() + random.normal(size=depth.shape))
    z = (depth + noise * off)[rows, columns]
    rays = np.stack([columns - size // 2, rows - size // 2, np.full(len(rows), focal)], axis=1)
    return Scan("", points, rays / focal * z[:, None], truth)


def views(models: dict[str, Cloud], count: int, noise: float) -> Iterator[Scan]:
    """Each model against views of it."""
    for seed in range(count):
        for k, (name, points) in enumerate(models.items()):
            scan = depth_image(points, np.random.default_rng([7, seed, k]), noise)
            yield Scan(f"{name} {seed}", scan.source, scan.target, scan.truth)


def mirrored(scans: Iterator[Scan]) -> Iterator[Scan]:
    """The target left-handed: no pose is right."""
    for scan in scans:
        yield Scan(f"mirrored {scan.name}", scan.source, scan.target * [1, 1, -1], None)


def unrelated(scans: list[Scan], others: list[Scan]) -> Iterator[Scan]:
    """Clouds of different places: no pose is right."""
    for scan, other in zip(scans, others, strict=True):
        yield Scan(f"{scan.name} / {other.name}", scan.source, other.target, None)
