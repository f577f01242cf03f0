#!/usr/bin/env python3
"""Calibrates the verdict on clouds: poses that are known to be right or wrong, judged by default.

bench/cloud_verdicts.py [--docs docs] [--records out/bench/cloud_verdicts.jsonl]

Real pairs, synthetic scans, mirrored ones, unrelated ones; of each pair the pose that is found and,
where the truth is known, wrong ones from elsewhere, refined where they are. Prints tables in
Markdown, and writes them into the page. Needs the package (tools/make_venv) and the real data:
$GMCR_DATA, else ../shared/data. With --from-records the tables are drawn from earlier runs.
"""

from __future__ import annotations

import argparse
import json
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import gmcr
import gmcr.io
import numpy as np
import scenes
from page_block import replace_block
from paper.data import CLOUD_SETS, data_root, pairs_of, read_points
from scenes import Scan

MAX_ERROR_DEG = 5.0
MAX_ERROR_OF_EXTENT = 0.05
MAX_VOXELS_AWAY = 2.0
TIME_LIMIT = 8.0  # seconds a pair
FACTORS = (0.25, 0.5, 0.7, 0.85, 1.0, 1.15, 1.4, 2.0)
# the limits that a factor makes stricter or laxer, as src/frontend/judgement/verdict.cpp has them
TRUSTED_INLIERS, TRUSTED_EVIDENCE, LEAST_COVERAGE = 30, 4.5, 0.2
LEAST_AGREEMENT, MOST_NOISE = 0.5, 0.16


def real_scans() -> dict[str, list[Scan]]:
    """The pairs of shared/data by set; those that hardly move are turned."""
    sets = {}
    for name in CLOUD_SETS:
        sets[name] = []
        for folder in pairs_of(name):
            source, target = (read_points(folder / f"{side}.ply") for side in ("source", "target"))
            truth = np.loadtxt(folder / "T_target_source.txt")
            if np.trace(truth[:3, :3]) > 2.9999 and np.linalg.norm(truth[:3, 3]) < 0.1:
                turn = scenes.pose(scenes.rotation_about(np.array([1.0, 2, 3]), 2), np.zeros(3))
                source, truth = scenes.moved(source, turn), truth @ np.linalg.inv(turn)
            sets[name].append(Scan(folder.name, source, target, truth))
    return sets


def reported_scans() -> dict[str, list[Scan]]:
    """Reports that come with clouds and a pose, a set each."""
    sets = {}
    for folder, source, target, truth in (
        ("14-mesh-vertices-as-model", "model_sampled", "scan", "T_truth"),
        ("14-mesh-vertices-as-model", "model_sampled", "scan_all_sides", "T_truth"),
        ("17-scan-to-map", "scan", "submap", "T_truth"),
        ("26-corridor-repeated-doors", "source", "target", "T_truth"),
        ("35-bare-ground-two-cameras", "right_0", "left_0", "T_truth"),
        ("35-bare-ground-two-cameras", "right_1", "left_1", "T_truth"),
        ("35-bare-ground-two-cameras", "right_bumps", "left_bumps", "T_truth"),
        ("35-bare-ground-two-cameras", "edge_a", "edge_b", "T_edge"),
        ("37-fine-voxels-dense-rooms", "source", "target", "T_truth"),
    ):
        at = data_root() / "reports" / folder
        clouds = [gmcr.io.read_cloud(at / f"{side}.ply").points for side in (source, target)]
        scan = Scan(source, *clouds, np.loadtxt(at / f"{truth}.txt"))
        sets.setdefault(f"report {folder[:2]}", []).append(scan)
    return sets


def models() -> dict[str, np.ndarray]:
    """Objects about 0.2 m large: household ones, and statues made as small."""
    folders = sorted((data_root() / "objects_ycb").glob("[0-9]*"))
    clouds = {folder.name: read_points(folder / "source.ply") for folder in folders}
    for name in ("armadillo", "bunny", "dragon"):
        points = gmcr.io.read_cloud(data_root() / "models" / f"{name}.ply").points
        clouds[name] = points * (0.18 / np.ptp(points, axis=0).max())
    return clouds


def views(size: int) -> dict[str, list[Scan]]:
    """Of objects whose matches say little for the noise of the camera."""
    scans = list(scenes.views(models(), size // 2, 0.0015))
    scans += list(scenes.views(models(), size // 2, 0.003))
    others = scans[1:] + scans[:1]  # the next object
    return {
        "views": scans,
        "views mirrored": list(scenes.mirrored(iter(scans))),
        "views unrelated": list(scenes.unrelated(scans, others)),
    }


def all_scans(size: int) -> dict[str, list[Scan]]:
    real = real_scans()
    flat = [scan for scans in real.values() for scan in scans]
    rooms, objects = list(scenes.rooms(2 * size)), list(scenes.objects(2 * size))
    sets = {"rooms": rooms, "objects": objects}
    sets["corridors"] = list(scenes.corridors(size))
    sets["grounds"] = list(scenes.grounds(size))
    sets["halves"] = list(scenes.halves(size))
    sets["boxes"] = list(scenes.boxes_and_prisms(size))
    sets["mirrored rooms"] = list(scenes.mirrored(iter(rooms[:size])))
    sets["mirrored objects"] = list(scenes.mirrored(iter(objects[:size])))
    sets["mirrored real pairs"] = list(scenes.mirrored(iter(flat[::3])))
    sets |= reported_scans() | real | views(size)
    sets["other real pairs"] = list(scenes.unrelated(flat, flat[17:] + flat[:17]))
    sets["other rooms"] = list(scenes.unrelated(rooms, rooms[1:] + rooms[:1]))
    sets["other objects"] = list(scenes.unrelated(objects, objects[1:] + objects[:1]))
    return sets


def wrong_poses(scan: Scan, random: np.random.Generator) -> Iterator[tuple[str, np.ndarray]]:
    """Half turns about the axes of the source, a turn, and shifts; all about its centroid."""
    centre = scan.source.mean(axis=0)
    spread, axes = np.linalg.eigh(np.cov((scan.source - centre).T))
    changes = [
        (f"half turn {k + 1}", scenes.rotation_about(axes[:, k], np.pi), np.zeros(3))
        for k in range(3)
    ]
    changes.append(("turned", scenes.rotation_about(random.normal(size=3), 0.5), np.zeros(3)))
    for share in (0.5, 1.0):
        shift = share * np.sqrt(spread[2]) * axes[:, 2]
        changes.append((f"shifted by {share}", np.eye(3), shift))
    for name, turn, shift in changes:
        change = scenes.pose(turn, centre - turn @ centre + shift)
        yield name, scan.truth @ change


def error_of(scan: Scan, found: np.ndarray) -> float:
    """Mean distance of the points from where they belong, metres; infinity without a truth."""
    if scan.truth is None:
        return float("inf")
    apart = scenes.moved(scan.source, found) - scenes.moved(scan.source, scan.truth)
    return float(np.linalg.norm(apart, axis=1).mean())


def is_right(scan: Scan, found: np.ndarray) -> bool:
    if scan.truth is None:
        return False
    cosine = (np.trace(found[:3, :3] @ scan.truth[:3, :3].T) - 1) / 2
    extent = np.ptp(scan.target, axis=0).max()
    return bool(
        np.degrees(np.arccos(np.clip(cosine, -1, 1))) <= MAX_ERROR_DEG
        and error_of(scan, found) <= MAX_ERROR_OF_EXTENT * extent
    )


def record_of(set_name: str, scan: Scan, kind: str, result: gmcr.CloudResult) -> dict[str, object]:
    fit = result.surfaces
    return {
        "set": set_name,
        "pair": scan.name,
        "pose": kind,
        "is_right": is_right(scan, result.target_from_source.matrix()),
        "verdict": str(result.verdict),
        "reason": result.verdict_reason,
        "num_inliers": len(result.inliers),
        "evidence": result.distinct_evidence,
        "coverage": max(result.fitness, result.target_fitness),
        "agreement": fit.agreement,
        "noise": fit.noise / result.voxels.target_voxel_size,
        "overlap": fit.source_share + fit.target_share,
        "num_weak": len(fit.weak_directions),
        "num_rivals": len(result.rivals),
        "filtered": result.matches.filtered,
    }


def judged(set_name: str, scan: Scan, number: int) -> Iterator[dict[str, object]]:
    """The pose that is found, and wrong ones."""
    result = gmcr.register_clouds(scan.source, scan.target, time_limit=TIME_LIMIT)
    if result.status != "ok":
        return
    yield record_of(set_name, scan, "found", result)
    # a placed pose was not found by turning, which is what views are about
    if scan.truth is None or set_name.startswith("views"):
        return
    for kind, wrong in wrong_poses(scan, np.random.default_rng(number)):
        placed = gmcr.with_pose(result, wrong)
        other = gmcr.refine_clouds(placed, scan.source, scan.target)
        if not is_halfway(scan, other):
            yield record_of(set_name, scan, kind, other)


def is_halfway(scan: Scan, result: gmcr.CloudResult) -> bool:
    """Whether a placed pose is right by the letter, but was not drawn to where it belongs."""
    found = result.target_from_source.matrix()
    away = MAX_VOXELS_AWAY * result.voxels.target_voxel_size
    is_trusted = str(result.verdict) == "trusted"
    return not is_trusted and is_right(scan, found) and error_of(scan, found) > away


def count(records: Iterable[dict], right: bool, trusted: bool | None = None) -> int:
    return sum(
        record["is_right"] == right
        and (trusted is None or (record["verdict"] == "trusted") == trusted)
        for record in records
    )


def is_determined(record: dict) -> bool:
    """Whether the surfaces leave no motion open and meet as well at no other pose."""
    return bool(record["num_weak"] == record["num_rivals"] == 0)


def is_trusted_at(record: dict, factor: float) -> bool:
    """Whether the verdict were trusted with every limit that many times as strict."""
    return bool(
        record["num_inliers"] >= factor * TRUSTED_INLIERS
        and record["evidence"] >= factor * TRUSTED_EVIDENCE
        and record["coverage"] >= factor * LEAST_COVERAGE
        and record["agreement"] >= min(factor * LEAST_AGREEMENT, 0.99)
        and record["noise"] * factor <= MOST_NOISE
        and record["filtered"]
        and is_determined(record)
    )


def table(rows: list[list[object]]) -> str:
    lines = [rows[0], ["---"] * len(rows[0]), *rows[1:]]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines) + "\n"


def share(part: int, total: int) -> str:
    return f"{part} of {total}" + (f" ({100 * part / total:.0f} %)" if total else "")


def tables(records: list[dict]) -> str:
    names = sorted({record["set"] for record in records})
    seen = set(names[::2])  # the limits may be set on these
    rows: list[list[object]] = [
        ["set", "half", "right", "of these determined", "trusted", "wrong", "wrong and trusted"]
    ]
    for name in names:
        group = [record for record in records if record["set"] == name]
        half = "set on" if name in seen else "reported"
        rows.append(
            [
                name,
                half,
                count(group, True),
                count(filter(is_determined, group), True),
                count(group, True, True),
                count(group, False),
                count(group, False, True),
            ]
        )
    text = table(rows)
    curve: list[list[object]] = [
        [
            "limits times",
            *(
                f"{half}: {kind}"
                for half in ("set on", "reported")
                for kind in ("right trusted", "wrong trusted")
            ),
        ]
    ]
    halves = [[r for r in records if (r["set"] in seen) == is_seen] for is_seen in (True, False)]
    for factor in FACTORS:
        row: list[object] = [factor]
        for half in halves:
            for right in (True, False):
                group = [record for record in half if record["is_right"] == right]
                row.append(share(sum(is_trusted_at(r, factor) for r in group), len(group)))
        curve.append(row)
    totals: list[list[object]] = [
        ["half", "right: trusted", "right and determined: trusted", "wrong: trusted"]
    ]
    for half, group in zip(("set on", "reported"), halves, strict=True):
        clear = [record for record in group if is_determined(record)]
        row = [half]
        for records, right in ((group, True), (clear, True), (group, False)):
            row.append(share(count(records, right, True), count(records, right)))
        totals.append(row)
    return text + table(totals) + table(curve)


def run(size: int, sets: str, path: Path) -> Iterator[dict]:
    """Judges all, and keeps the records in a file too, a line each."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as file:
        for name, scans in all_scans(size).items():
            if not re.search(sets, name):
                continue
            for number, scan in enumerate(scans):
                for record in judged(name, scan, number):
                    print(json.dumps(record), file=file, flush=True)
                    yield record


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    parser.add_argument("--records", type=Path, default=Path("out/bench/cloud_verdicts.jsonl"))
    parser.add_argument(
        "--from-records", type=Path, nargs="+", help="of earlier runs, by set: nothing is run"
    )
    parser.add_argument("--size", type=int, default=4, help="pairs of a synthetic kind")
    parser.add_argument("--sets", help="those whose names hold this")
    given = parser.parse_args()
    if given.from_records:
        lines = [line for path in given.from_records for line in path.read_text().splitlines()]
        records = [json.loads(line) for line in lines]
    else:
        records = list(run(given.size, given.sets or "", given.records))
    num_right = count(records, True)
    command = f"bench/cloud_verdicts.py --size {given.size}"
    text = f"`{command}`: {len(records)} poses, {num_right} of them right.\n\n" + tables(records)
    print(text)
    if given.docs:
        replace_block(given.docs, "cloud_verdicts", text)


if __name__ == "__main__":
    main()
