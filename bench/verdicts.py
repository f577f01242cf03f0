#!/usr/bin/env python3
"""Measures the verdict on matches: how often chance is trusted, and how often what is right.

bench/verdicts.py [--docs docs] [--seeds N]

Prints tables in Markdown, and writes them into the page. Needs the package (tools/make_venv); no
data. Chance: problems without a right match. Right: problems whose pose was found, with at least 8
right matches.
"""

from __future__ import annotations

import argparse
import collections
from collections.abc import Callable
from pathlib import Path

import gmcr
import numpy as np
from page_block import replace_block

Cloud = np.ndarray
Matches = tuple[Cloud, Cloud]
Maker = Callable[[np.random.Generator, int], Matches]
BOUND = 0.02  # of clouds about 1 across
MOST_OF_UNKNOWN_SCALE = 1000  # chance at more takes seconds a problem
VERDICTS = ("trusted", "doubtful", "untrusted")


def turned(points: Cloud, random: np.random.Generator) -> Cloud:
    """By a random rotation, moved."""
    rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
    rotation *= np.sign(np.linalg.det(rotation))
    return points @ rotation.T + random.uniform(-2, 2, 3)


def surface(random: np.random.Generator, count: int, seed: int) -> Cloud:
    """Points of a bumpy closed surface, one for each seed."""
    shape = np.random.default_rng(seed)
    waves, heights = shape.normal(size=(6, 3)) * 3, shape.uniform(0.03, 0.12, 6)
    directions = random.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    radius = 0.4 + np.sin(directions @ waves.T) @ heights
    return directions * radius[:, None] * shape.uniform(0.5, 1, 3)


def clusters(random: np.random.Generator, count: int, number: int, width: float) -> Cloud:
    centres = random.uniform(0, 1, (number, 3))
    return centres[random.integers(number, size=count)] + width * random.normal(size=(count, 3))


def uniform(random: np.random.Generator, count: int) -> Matches:
    return random.uniform(0, 1, (count, 3)), random.uniform(0, 1, (count, 3))


def clustered(random: np.random.Generator, count: int) -> Matches:
    number = int(random.integers(2, 12))
    return random.uniform(0, 1, (count, 3)), clusters(random, count, number, 0.01)


def both_clustered(random: np.random.Generator, count: int) -> Matches:
    number = int(random.integers(3, 12))
    return clusters(random, count, number, 0.02), clusters(random, count, number, 0.02)


def planar(random: np.random.Generator, count: int) -> Matches:
    source, target = uniform(random, count)
    return source * [1, 1, 0.01], turned(target * [1, 1, 0.01], random)


def linear(random: np.random.Generator, count: int) -> Matches:
    source, target = uniform(random, count)
    return source * [1, 0.02, 0.02], turned(target * [1, 0.02, 0.02], random)


def other_object(random: np.random.Generator, count: int) -> Matches:
    seed = int(random.integers(10**6))
    return surface(random, count, seed), turned(surface(random, count, seed + 1), random)


def shuffled(random: np.random.Generator, count: int) -> Matches:
    """Points of one object, matched at random: raw clouds handed over as matches."""
    seed = int(random.integers(10**6))
    return surface(random, count, seed), turned(surface(random, count, seed), random)


def repeated(random: np.random.Generator, count: int) -> Matches:
    source, target = uniform(random, count)
    few = max(count // 10, 4)
    return source, target[random.integers(few, size=count)]


def mirrored(random: np.random.Generator, count: int) -> Matches:
    source = surface(random, count, int(random.integers(10**6)))
    noise = 0.3 * BOUND * random.normal(size=source.shape)
    return source, turned(source * [1, 1, -1] + noise, random)


CHANCE: dict[str, Maker] = {
    "uniform": uniform,
    "targets in clusters": clustered,
    "both in clusters": both_clustered,
    "on a plane": planar,
    "along a line": linear,
    "another object": other_object,
    "raw clouds as matches": shuffled,
    "targets repeated": repeated,
    "mirrored": mirrored,
}


def in_clutter(clutter: Maker) -> Maker:
    """8 to 40 right matches, the others of a kind of chance."""

    def make(random: np.random.Generator, count: int) -> Matches:
        right = min(int(random.integers(8, 41)), count)
        source, target = clutter(random, count)
        moved = turned(np.vstack([source, target]), random)[: len(source)]
        noise = random.normal(size=(right, 3))
        noise *= (
            0.9
            * BOUND
            * random.uniform(0, 1, (right, 1))
            / np.linalg.norm(noise, axis=1, keepdims=True)
        )
        moved[right:] = target[right:] - target.mean(0) + moved.mean(0)
        moved[:right] += noise
        return source, moved

    return make


RIGHT: dict[str, Maker] = {
    f"in {name}": in_clutter(CHANCE[kind])
    for name, kind in (
        ("uniform clutter", "uniform"),
        ("clusters", "targets in clusters"),
        ("clutter of another object", "another object"),
        ("points of the same object", "raw clouds as matches"),
    )
}


def count_verdicts(
    make: Maker, sizes: tuple[int, ...], seeds: int, scale_mode: str, wanted_right: bool
) -> collections.Counter[str]:
    counts: collections.Counter[str] = collections.Counter()
    for size in sizes:
        if scale_mode == "estimated" and size > MOST_OF_UNKNOWN_SCALE:
            continue
        for seed in range(seeds):
            source, target = make(np.random.default_rng([seed, size]), size)
            result = gmcr.register_correspondences(
                source, target, noise_bound=BOUND, scale_mode=scale_mode
            )
            if wanted_right:
                # the right ones come first; what was not found is no matter of the verdict
                right = np.sum(np.array(result.inliers) < min(8, size))
                if right < 6:
                    counts["not found"] += 1
                    continue
            counts[result.verdict] += 1
    return counts


def table(makers: dict[str, Maker], sizes: tuple[int, ...], seeds: int, wanted_right: bool) -> str:
    columns = (*VERDICTS, *(["not found"] if wanted_right else []))
    lines = [["matches", "scale", "n", *columns], ["---"] * (3 + len(columns))]
    for name, make in makers.items():
        for scale_mode in ("known", "estimated"):
            counts = count_verdicts(make, sizes, seeds, scale_mode, wanted_right)
            lines.append(
                [name, scale_mode, str(sum(counts.values())), *(str(counts[c]) for c in columns)]
            )
    return "".join("| " + " | ".join(line) + " |\n" for line in lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    parser.add_argument("--seeds", type=int, default=20, help="problems a size")
    given = parser.parse_args()
    sizes = (10, 100, 1000, 5000)
    text = (
        f"Up to N = {MOST_OF_UNKNOWN_SCALE:,} with unknown scale. "
        f"`bench/verdicts.py --seeds {given.seeds}`; N of {', '.join(map(str, sizes))}, a bound of "
        f"{BOUND} for clouds about 1 across.\n\nProblems without a right match:\n\n"
        + table(CHANCE, sizes, given.seeds, wanted_right=False)
        + "8 to 40 right matches of N = 100 and 1,000:\n\n"
        + table(RIGHT, (100, 1000), 2 * given.seeds, wanted_right=True)
    )
    print(text)
    if given.docs:
        replace_block(given.docs, "verdicts", text)


if __name__ == "__main__":
    main()
