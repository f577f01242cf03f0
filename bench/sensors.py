#!/usr/bin/env python3
"""Clouds of unlike sensors, and of unknown scale: `gmcr.register_clouds` by default options.

bench/sensors.py [--docs docs] [--records out/bench/sensors.jsonl]

Every pair is registered at equal density and with an unlike source or target
(bench/sensor_cases.py); every real pair with the scale known and estimated, its source scaled by a
factor between 0.2 and 5. The source is turned about its sensor at random, so each seed has other
voxels. Times are CPU seconds of one thread. Prints tables in Markdown, and writes them into the
page. Needs the package (tools/make_venv) and the real data: $GMCR_DATA, else ../shared/data. With
--from-records the tables are drawn from earlier runs.
"""

from __future__ import annotations

import argparse
import json
import re
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from statistics import median

import gmcr
import numpy as np
import sensor_cases
from page_block import replace_block
from paper.data import CLOUD_SETS, pairs_of
from scenes import Scan

MAX_ERROR_DEG = 5.0
MAX_ERROR_OF_EXTENT = 0.05
MAX_SYMMETRIC_ERROR = 0.02
MAX_SCALE_ERROR = 0.1
FURTHER_SETS = ("kitti_fpfh", "gore")  # of no bearing on how the front end was made
NUM_QUERIES = 500


def symmetric_error(a: np.ndarray, b: np.ndarray) -> float:
    """Mean distance of some of the points (N, 3) from the nearest of the others, over their
    diameter.
    """
    some = a[:: -(-len(a) // NUM_QUERIES)]
    nearest = [np.linalg.norm(b - point, axis=1).min() for point in some]
    return float(np.mean(nearest) / np.linalg.norm(np.ptp(b, axis=0)))


def errors_of(scan: Scan, found: np.ndarray) -> dict[str, object]:
    """Of a (4, 4) pose; right as in bench_clouds, household objects also by symmetry."""
    scale, true_scale = (np.cbrt(np.linalg.det(m[:3, :3])) for m in (found, scan.truth))
    cosine = (np.trace(found[:3, :3] @ scan.truth[:3, :3].T) / scale / true_scale - 1) / 2
    there, moved = (scan.source @ m[:3, :3].T + m[:3, 3] for m in (scan.truth, found))
    degrees = float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
    error = float(np.linalg.norm(moved - there, axis=1).mean() / np.ptp(scan.target, axis=0).max())
    is_right = degrees <= MAX_ERROR_DEG and error <= MAX_ERROR_OF_EXTENT
    if not is_right and scan.name.startswith("objects_ycb"):
        is_right = max(symmetric_error(moved, there), symmetric_error(there, moved)) <= (
            MAX_SYMMETRIC_ERROR
        )
    scale_error = float(abs(scale / true_scale - 1))
    return {
        "right": is_right and scale_error <= MAX_SCALE_ERROR,
        "rotation_deg": degrees,
        "error_of_extent": error,
        "scale_error": scale_error,
    }


def measure(scan: Scan, **options: object) -> dict[str, object]:
    begin = time.process_time()
    result = gmcr.register_clouds(scan.source, scan.target, num_threads=1, **options)
    record = {
        "pair": scan.name,
        "cpu_s": time.process_time() - begin,
        "verdict": str(result.verdict),
        "reason": result.verdict_reason,
        "right": False,
        "num_points": [len(scan.source), len(scan.target)],
        "num_attempts": result.num_attempts,
        "num_inliers": len(result.inliers),
        "num_matches": len(result.matches.source),
    }
    if scan.truth is not None and str(result.status) in ("ok", "degenerate"):
        record |= errors_of(scan, result.target_from_source.matrix())
    return record


def scaled(scan: Scan, factor: float) -> Scan:
    truth = scan.truth.copy()
    truth[:3, :3] /= factor
    return Scan(scan.name, factor * scan.source, scan.target, truth)


def scale_cases(folders: list[Path], seed: int) -> Iterator[tuple[str, Scan, float]]:
    for folder in folders:
        random = np.random.default_rng([15, seed, *folder.name.encode()])
        factor = float(np.exp(random.uniform(np.log(0.2), np.log(5))))
        group = {name: "further sets" for name in FURTHER_SETS} | {"objects_ycb": "household"}
        pair = sensor_cases.real_pair(folder, seed)
        yield group.get(folder.parent.name, "the real pairs"), scaled(pair, factor), factor


def run(given: argparse.Namespace) -> Iterator[dict]:
    folders = [folder for name in CLOUD_SETS for folder in pairs_of(name)]
    further = [folder for name in FURTHER_SETS for folder in pairs_of(name)]
    for seed in given.seeds:
        if "density" in given.parts:
            for case in sensor_cases.all_cases(folders, given.size, seed):
                if not re.search(given.groups, case.group):
                    continue
                for kind in ("equal", "unlike"):
                    scan = getattr(case, kind)
                    yield {"part": kind, "group": case.group, "seed": seed, **measure(scan)}
            if re.search(given.groups, "other places"):
                for scan in sensor_cases.unrelated(folders, seed):
                    yield {"part": "unlike", "group": "other places", "seed": seed, **measure(scan)}
        if "scale" in given.parts:
            for group, scan, factor in scale_cases([*folders, *further], seed):
                if not re.search(given.groups, group):
                    continue
                head = {"group": group, "seed": seed, "factor": factor}
                yield {"part": "known", **head, **measure(scan, scale=1 / factor)}
                yield {"part": "estimated", **head, **measure(scan, scale_mode="estimated")}


def table(rows: list[list[object]]) -> str:
    lines = [rows[0], ["---"] * len(rows[0]), *rows[1:]]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines) + "\n"


def trusted(records: Iterable[dict], right: bool) -> int:
    return sum(r["verdict"] == "trusted" and r["right"] == right for r in records)


def paired(records: list[dict], first: str, second: str) -> dict[str, list[tuple[dict, dict]]]:
    """Both records of each case, by group in order."""
    groups: dict[str, list[tuple[dict, dict]]] = {}
    before: dict = {}
    for record in records:
        if record["part"] == first:
            before = record
        elif record["part"] == second and record["pair"] == before.get("pair"):
            groups.setdefault(record["group"], []).append((before, record))
    return groups


def density_table(records: list[dict]) -> str:
    rows: list[list[object]] = [
        ["clouds", "pairs", "right at equal density", "of these right", "trusted at equal density",
         "trusted", "wrong trusted at equal density", "wrong trusted", "CPU s"]
    ]  # fmt: skip
    total = [0, 0]
    for group, pairs in paired(records, "equal", "unlike").items():
        at_equal = [unlike for equal, unlike in pairs if equal["right"]]
        kept = sum(unlike["right"] for unlike in at_equal)
        total = [total[0] + len(at_equal), total[1] + kept]
        unlike = [pair[1] for pair in pairs]
        equal = [pair[0] for pair in pairs]
        seconds = " / ".join(f"{median(r['cpu_s'] for r in some):.2g}" for some in (equal, unlike))
        wrong = [trusted(some, False) for some in (equal, unlike)]
        share = f"{kept} ({100 * kept / max(len(at_equal), 1):.0f} %)"
        counts = [trusted(equal, True), trusted(unlike, True), *wrong]
        rows.append([group, len(pairs), len(at_equal), share, *counts, seconds])
    elsewhere = [r for r in records if r["group"] == "other places"]
    if elsewhere:
        wrong = trusted(elsewhere, False)
        seconds = f"{median(r['cpu_s'] for r in elsewhere):.2g}"
        rows.append(["thinned, other places", len(elsewhere), *5 * ["-"], wrong, seconds])
    share = f"{100 * total[1] / max(total[0], 1):.0f} %"
    return (
        f"Right of what is right at equal density: {total[1]} of {total[0]} ({share}).\n\n"
        + table(rows)
    )


def scale_table(records: list[dict]) -> str:
    rows: list[list[object]] = [
        ["pairs", "count", "right, scale known", "right", "trusted, scale known", "trusted",
         "wrong trusted", "scale off, median", "at worst", "CPU s, median", "at worst",
         "over the time of known scale, median"]
    ]  # fmt: skip
    groups = paired(records, "known", "estimated")
    several = [pair for group, pairs in groups.items() if group != "household" for pair in pairs]
    for group, pairs in [*groups.items(), ("all but household", several)]:
        known, estimated = ([pair[k] for pair in pairs] for k in (0, 1))
        off = [100 * r["scale_error"] for r in estimated if r["right"]]
        ratio = median(b["cpu_s"] / a["cpu_s"] for a, b in pairs)
        seconds = [r["cpu_s"] for r in estimated]
        rows.append(
            [
                group,
                len(pairs),
                *(sum(r["right"] for r in some) for some in (known, estimated)),
                *(trusted(some, True) for some in (known, estimated)),
                trusted(estimated, False),
                *(f"{of(off):.2g} %" if off else "-" for of in (median, max)),
                f"{median(seconds):.2g}",
                f"{max(seconds):.2g}",
                f"{ratio:.2g}",
            ]
        )
    return table(rows)


def text_of(records: list[dict]) -> str:
    seeds = sorted({record["seed"] for record in records})
    text = f"`bench/sensors.py --seeds {' '.join(map(str, seeds))}`, gmcr {gmcr.__version__}.\n\n"
    parts = {record["part"] for record in records}
    if "equal" in parts:
        text += density_table(records)
    if "known" in parts:
        text += scale_table(records)
    return text


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--docs", type=Path, help="page whose block is replaced")
    parser.add_argument("--block", default="sensors", help="its name")
    parser.add_argument("--records", type=Path, default=Path("out/bench/sensors.jsonl"))
    parser.add_argument("--from-records", type=Path, nargs="+", help="nothing is run")
    parser.add_argument("--seeds", type=int, nargs="+", default=[0])
    parser.add_argument("--parts", nargs="+", default=["density", "scale"])
    parser.add_argument("--groups", default="", help="those whose names match")
    parser.add_argument("--size", type=int, default=8, help="pairs of a synthetic kind")
    given = parser.parse_args()
    if given.from_records:
        lines = [line for path in given.from_records for line in path.read_text().splitlines()]
        records = [json.loads(line) for line in lines]
    else:
        records = []
        given.records.parent.mkdir(parents=True, exist_ok=True)
        with given.records.open("w") as file:
            for record in run(given):
                print(json.dumps(record), file=file, flush=True)
                records.append(record)
    text = text_of(records)
    print(text)
    if given.docs:
        replace_block(given.docs, given.block, text)


if __name__ == "__main__":
    main()
