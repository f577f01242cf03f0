#!/usr/bin/env python3
"""How true the covariance of the pose of two raw clouds is.

bench/cloud_covariance.py [--docs docs]

Real pairs whose pose is right: d' C^-1 d over the number of parameters, d the difference to the
truth, of the covariance that is returned, and of that of the matches at the same pose. Truths have
errors of their own, which count here as ours. Then two samplings of synthetic surfaces, whose truth
is exact. Needs the package (tools/make_venv) and the real data: $GMCR_DATA, else ../shared/data.
Prints a table in Markdown, and writes it into the page.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

import gmcr
import numpy as np
from cloud_rivals import MAX_ERROR_DEG, load
from page_block import replace_block
from paper.data import CLOUD_SETS, DataAbsent, pairs_of
from paper.problem import Pose

CHI_SQUARED_95 = 12.59  # of 6 degrees of freedom


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    given = parser.parse_args()
    text = table(given.seeds)
    print(text)
    if given.docs:
        replace_block(given.docs, "cloud_covariance", text)
    return 0


def table(seeds: int) -> str:
    lines = [
        "`bench/cloud_covariance.py`: median of d' C^-1 d / 6, 1 expected, and the share of poses outside "
        "the 95 % line.",
        "",
        "| set | poses | of the matches: median | outside | returned: median | outside |",
        "|---|---|---|---|---|---|",
    ]
    every: list[tuple[float, float]] = []
    for name in CLOUD_SETS:
        try:
            folders = pairs_of(name)
        except DataAbsent as absent:
            print(f"skipped: {absent}", file=sys.stderr)
            continue
        found = []
        for folder in folders:
            pair = load(folder)
            found += ratios(pair.source, pair.target, pair.truth)
        lines.append(row(name, found))
        every += found
    lines.append(row("all real pairs", every))
    for noise in (0.002, 0.01, 0.03):
        found = []
        for source, target, truth in surfaces(seeds, noise):
            found += ratios(source, target, truth)
        lines.append(row(f"bumpy surfaces 2 m across, noise of {noise:g} m", found))
    return "\n".join(lines)


def row(name: str, found: list[tuple[float, float]]) -> str:
    if not found:
        return f"| {name} | 0 | | | | |"
    cells = []
    for values in np.array(found).T:
        outside = np.mean(6 * values > CHI_SQUARED_95)
        cells.append(f"{np.median(values):.2g} | {100 * outside:.0f} %")
    return f"| {name} | {len(found)} | {' | '.join(cells)} |"


def ratios(source: np.ndarray, target: np.ndarray, truth: Pose) -> list[tuple[float, float]]:
    """Of the matches and as returned; nothing where the pose is wrong or has no covariance."""
    result = gmcr.register_clouds(source, target)
    registration = result.registration
    if registration.status != "ok" or registration.covariance is None:
        return []
    difference = to_truth(np.array(result.matrix()), truth)
    if np.degrees(np.linalg.norm(difference[:3])) > MAX_ERROR_DEG:
        return []
    matches = result.matches
    of_matches = gmcr.evaluate_uncertainty(
        result.target_from_source,
        matches.source,
        matches.target,
        registration.inliers,
        noise_bound=matches.noise_bound,
    ).covariance
    if of_matches is None:
        return []
    first, second = (
        float(difference @ np.linalg.solve(np.asarray(covariance.matrix)[:6, :6], difference)) / 6
        for covariance in (of_matches, registration.covariance)
    )
    return [(first, second)]


def to_truth(matrix: np.ndarray, truth: Pose) -> np.ndarray:
    """The parameters of the covariance that lead from the pose to the truth: radians, metres."""
    turn = truth.rotation @ matrix[:3, :3].T
    axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    sine, cosine = np.linalg.norm(axis) / 2, (np.trace(turn) - 1) / 2
    vector = axis / 2 if sine < 1e-12 else axis / (2 * sine) * np.arctan2(sine, cosine)
    return np.concatenate([vector, truth.translation - matrix[:3, 3]])


def surfaces(seeds: int, noise: float) -> Iterator[tuple[np.ndarray, np.ndarray, Pose]]:
    for seed in range(seeds):
        random = np.random.default_rng(seed)
        waves, heights = random.normal(size=(6, 3)) * 3, random.uniform(0.03, 0.12, 6)
        rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
        rotation *= np.sign(np.linalg.det(rotation))
        truth = Pose(1.0, rotation, random.uniform(-2, 2, 3))
        clouds = []
        for _ in range(2):
            directions = random.normal(size=(12_000, 3))
            directions /= np.linalg.norm(directions, axis=1, keepdims=True)
            points = directions * (1 + 2 * np.sin(directions @ waves.T) @ heights)[:, None]
            clouds.append(points)
        source, target = clouds[0], truth.apply(clouds[1])
        yield (
            source + noise * random.normal(size=source.shape),
            target + noise * random.normal(size=target.shape),
            truth,
        )


if __name__ == "__main__":
    sys.exit(main())
