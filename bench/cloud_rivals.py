#!/usr/bin/env python3
"""Raw clouds side by side: gmcr.register_clouds, and KISS-Matcher followed by small_gicp.

bench/cloud_rivals.py [--out out/bench/cloud_rivals.jsonl] [--docs docs]

Both start from the same clouds in memory and end with a refined pose. KISS-Matcher takes voxels of
0.3 m, so its clouds are scaled to ours; small_gicp (GICP) follows with search radii of 3 and 1
voxels. The rival's time is the sum of the stages that KISS-Matcher reports, without how its
bindings convert lists, and the wall time of small_gicp. Methods take turns; a record has medians.
From files: with the time that each takes to read the pair, gmcr by its own reader, the rival by
that of small_gicp.

Needs the package (tools/make_venv), kiss-matcher and small_gicp beside it, and the real data:
$GMCR_DATA, else ../shared/data. Prints a table in Markdown, and writes it into the page.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

# idle threads of one method would spin beside the other
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

import gmcr
import numpy as np
from page_block import replace_block
from paper.data import CLOUD_SETS, DataAbsent, pairs_of, read_points, read_pose
from paper.problem import Pose

KISS_VOXEL = 0.3  # metres: its default, and where its other defaults hold
MAX_ERROR_DEG = 5.0
MAX_ERROR_OF_EXTENT = 0.05


@dataclass(frozen=True)
class Pair:
    name: str
    source: np.ndarray  # (N, 3), metres
    target: np.ndarray
    truth: Pose
    voxel: float  # metres, as ours is chosen
    paths: tuple[Path, Path]


@dataclass(frozen=True)
class Run:
    matrix: np.ndarray | None  # (4, 4) target from source, metres; None: no pose
    seconds: float
    seconds_reading: float = 0
    verdict: str = ""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=Path("out/bench/cloud_rivals.jsonl"))
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--sets", default=",".join(CLOUD_SETS), help="comma between")
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    given = parser.parse_args()
    methods = {
        "gmcr": lambda pair: run_gmcr(pair, given.threads),
        "KISS-Matcher + small_gicp": lambda pair: run_rival(pair, given.threads),
    }
    records = []
    given.out.parent.mkdir(parents=True, exist_ok=True)
    with given.out.open("w") as out:
        for set_name in given.sets.split(","):
            try:
                folders = pairs_of(set_name)
            except DataAbsent as absent:
                print(f"skipped: {absent}", file=sys.stderr)
                continue
            for folder in folders:
                pair = load(folder)
                for record in measure(pair, methods, given.repetitions):
                    record["threads"] = given.threads
                    out.write(json.dumps(record) + "\n")
                    records.append(record)
                print(line_of(records[-2], records[-1]), file=sys.stderr, flush=True)
    text = table(records)
    print(text)
    if given.docs:
        replace_block(given.docs, "cloud_rivals", text)
    return 0


def load(folder: Path) -> Pair:
    paths = (folder / "source.ply", folder / "target.ply")
    source, target = map(read_points, paths)
    truth = read_pose(folder / "T_target_source.txt")
    angle = np.degrees(np.arccos(np.clip((np.trace(truth.rotation) - 1) / 2, -1, 1)))
    if angle < 0.5 and np.linalg.norm(truth.translation) < 0.1:
        # it hardly moves: turned about the origin, where the sensor stays, doing nothing is wrong
        turn = np.array([[0.0, -1, 0], [0, 0, -1], [1, 0, 0]])
        source = source @ turn.T
        truth = Pose(1.0, truth.rotation @ turn.T, truth.translation)
    voxel = gmcr.match(source, target).target_voxel_size
    name = f"{folder.parent.name}/{folder.name}"
    clouds = (np.ascontiguousarray(source), np.ascontiguousarray(target))
    return Pair(name, *clouds, truth, voxel, paths)


def seconds_of(read: Callable[[str], Any], pair: Pair) -> float:
    start = time.perf_counter()
    for path in pair.paths:
        read(str(path))
    return time.perf_counter() - start


def run_gmcr(pair: Pair, num_threads: int) -> Run:
    start = time.perf_counter()
    result = gmcr.register_clouds(pair.source, pair.target, num_threads=num_threads)
    seconds = time.perf_counter() - start
    registration = result.registration
    has_pose = registration.status in ("ok", "degenerate")
    matrix = np.array(result.matrix()) if has_pose else None
    return Run(matrix, seconds, seconds_of(gmcr.io.read_points, pair), str(result.verdict))


def run_rival(pair: Pair, num_threads: int) -> Run:
    import kiss_matcher
    import small_gicp

    seconds_reading = seconds_of(small_gicp.read_ply, pair)
    unit = pair.voxel / KISS_VOXEL
    source, target = (cloud / unit for cloud in (pair.source, pair.target))
    lists = [list(cloud.astype(np.float32)) for cloud in (source, target)]
    matcher = kiss_matcher.KISSMatcher(kiss_matcher.KISSMatcherConfig(KISS_VOXEL))
    solution = matcher.estimate(*lists)
    # one object reports the time of its parts
    seconds = (
        matcher.get_processing_time()
        + matcher.get_extraction_time()
        + matcher.get_matching_time()
        + matcher.get_rejection_time()
    )
    if not solution.valid:  # there was nothing to solve
        return Run(None, seconds, seconds_reading)
    seconds += matcher.get_solver_time()
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = np.array(solution.rotation), np.array(solution.translation)
    start = time.perf_counter()
    (near, _), (far, tree) = (
        small_gicp.preprocess_points(cloud, KISS_VOXEL, num_threads=num_threads)
        for cloud in (source, target)
    )
    for radius in (3 * KISS_VOXEL, KISS_VOXEL):
        pose = small_gicp.align(
            far, near, tree, pose, max_correspondence_distance=radius, num_threads=num_threads
        ).T_target_source
    seconds += time.perf_counter() - start
    pose = np.array(pose)
    pose[:3, 3] *= unit
    return Run(pose, seconds, seconds_reading)


def measure(
    pair: Pair, methods: dict[str, Callable[[Pair], Run]], repetitions: int
) -> list[dict[str, Any]]:
    runs: dict[str, list[Run]] = {name: [] for name in methods}
    for _ in range(repetitions):
        for name, method in methods.items():
            runs[name].append(method(pair))
    return [record_of(pair, name, those) for name, those in runs.items()]


def record_of(pair: Pair, method: str, runs: Sequence[Run]) -> dict[str, Any]:
    record: dict[str, Any] = {
        "scenario": pair.name,
        "method": method,
        "num_points": [len(pair.source), len(pair.target)],
        "seconds": median(run.seconds for run in runs),
        "seconds_reading": median(run.seconds_reading for run in runs),
        "verdict": runs[-1].verdict,
        "success": False,
    }
    matrix = runs[-1].matrix
    if matrix is not None:
        moved = pair.source @ matrix[:3, :3].T + matrix[:3, 3]
        error = np.linalg.norm(moved - pair.truth.apply(pair.source), axis=1).mean()
        cosine = (np.trace(matrix[:3, :3] @ pair.truth.rotation.T) - 1) / 2
        record["rotation_deg"] = float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
        record["error_of_extent"] = float(error / np.ptp(pair.target, axis=0).max())
        record["success"] = (
            record["rotation_deg"] <= MAX_ERROR_DEG
            and record["error_of_extent"] <= MAX_ERROR_OF_EXTENT
        )
    return record


def line_of(ours: dict[str, Any], theirs: dict[str, Any]) -> str:
    def words(record: dict[str, Any]) -> str:
        error = record.get("error_of_extent", float("nan"))
        state = "right" if record["success"] else "WRONG"
        return f"{1000 * record['seconds']:.0f} ms {state} {100 * error:.3f} %"

    ratio = ours["seconds"] / theirs["seconds"]
    return f"{ours['scenario']}: {words(ours)} | {words(theirs)} | {ratio:.2f}"


def table(records: Sequence[dict[str, Any]]) -> str:
    """Markdown: a row a pair, then the sums."""
    lines = ["| pair | ours ms | rival ms | ratio | ours | rival |", "|---|---|---|---|---|---|"]
    pairs = list(zip(records[::2], records[1::2], strict=True))
    ratios = []
    for ours, theirs in pairs:
        ratios.append(ours["seconds"] / theirs["seconds"])
        cells = [
            f"{100 * r['error_of_extent']:.3f} %" if r["success"] else "wrong"
            for r in (ours, theirs)
        ]
        times = [f"{1000 * r['seconds']:.0f}" for r in (ours, theirs)]
        lines.append(
            "| " + " | ".join([ours["scenario"], *times, f"{ratios[-1]:.2f}", *cells]) + " |"
        )
    from_files = [
        (ours["seconds"] + ours["seconds_reading"])
        / (theirs["seconds"] + theirs["seconds_reading"])
        for ours, theirs in pairs
    ]
    both = [pair for pair in pairs if pair[0]["success"] and pair[1]["success"]]
    lines.append("")
    lines.append(
        f"Ratio of the times: median {median(ratios):.2f}, {min(ratios):.2f} to {max(ratios):.2f}; "
        f"above 1 on {sum(ratio > 1 for ratio in ratios)} of {len(ratios)}; from files "
        f"{median(from_files):.2f} in the median. "
        f"Right: {sum(p[0]['success'] for p in pairs)} and {sum(p[1]['success'] for p in pairs)}. "
        f"Median error of the {len(both)} that both get right: "
        f"{100 * median(p[0]['error_of_extent'] for p in both):.3f} and "
        f"{100 * median(p[1]['error_of_extent'] for p in both):.3f} % of the extent."
    )
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
