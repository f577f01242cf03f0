#!/usr/bin/env python3
"""Measures gmcr.batch: pairs a second by number of workers, here and on Ray.

python bench/batch.py [--out out/bench/batch.jsonl] [--workers 1,2] [--seconds 20]

Needs the package with its extra, gmcr[batch]. Real data: $GMCR_DATA, else ../shared/data.
Prints and records one JSON line for a scenario, backend and number of workers.
"""

from __future__ import annotations

import argparse
import concurrent.futures
import csv
import dataclasses
import itertools
import json
import multiprocessing
import os
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import gmcr
import numpy as np
from gmcr import batch
from gmcr.batch.sink import Sink
from gmcr.batch.work import Chunk, Work, process

Fields = dict[str, Any]
_PROBE_PAIRS = 14  # that tell how many pairs fill the time


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=Path("out/bench/batch.jsonl"))
    parser.add_argument("--workers", default="1,2", help="comma between")
    parser.add_argument("--seconds", type=float, default=20, help="of work a worker and run")
    parser.add_argument("--only", help="scenario")
    given = parser.parse_args()
    given.out.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder, given.out.open("w") as out:
        for name, pairs, options in scenarios(Path(folder)):
            if given.only not in (None, name):
                continue
            for record in measure(name, pairs, options, given):
                line = json.dumps(record)
                print(line, flush=True)
                out.write(line + "\n")


def scenarios(folder: Path) -> Iterator[tuple[str, list[Fields], Fields]]:
    """Name, distinct pairs, options. The first is bare: it finds the cost of the driver alone."""
    yield "nothing", [{"matches": "none.npy"}], {}
    files = []
    for seed in range(100):
        problem = gmcr.make_synthetic(num_correspondences=1000, outlier_rate=0.95, seed=seed)
        files.append({"matches": str(folder / f"{seed}.npy")})
        np.save(files[-1]["matches"], np.hstack([problem.source, problem.target]))
    yield "1,000 matches, 95 % wrong", files, {"noise_bound": problem.noise_bound}
    kitti = Path(os.environ.get("GMCR_DATA", "../shared/data")).resolve() / "kitti_fpfh"
    if not kitti.is_dir():
        print(f"skipped: real pairs, because {kitti} is absent; set GMCR_DATA", file=sys.stderr)
        return
    names = sorted(path.name for path in kitti.iterdir() if path.is_dir())
    matches = [{"matches": str(kitti / name / "correspondences.csv")} for name in names]
    yield "KITTI FPFH matches", matches, {"noise_bound": 0.6}
    clouds = [
        {side: str(kitti / name / f"{side}.ply") for side in ("source", "target")} for name in names
    ]
    yield "KITTI scans", clouds, {}


def measure(
    name: str, pairs: list[Fields], options: Fields, given: argparse.Namespace
) -> Iterator[Fields]:
    register = do_nothing if name == "nothing" else batch.register_pair
    counts = [int(count) for count in given.workers.split(",")]
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        settings = {"options": options, "register": register}
        probe = write_list(folder / "probe.csv", pairs, _PROBE_PAIRS)
        batch.run(probe, folder / "probe", num_workers=1, **settings)
        rows = list(batch.read_results(folder / "probe"))
        seconds = sum(row.seconds or 0 for row in rows) / len(rows)
        sizes = {
            "input_bytes": input_bytes(pairs),
            "row_bytes": row_bytes(rows, folder / "distinct"),
            "worker_mb": worker_megabytes(probe, settings),
        }
        num_pairs = 20_000 if name == "nothing" else max(7, int(given.seconds / seconds))
        for k, (count, backend) in enumerate(itertools.product(counts, ("local", "ray"))):
            todo = write_list(folder / f"{k}.csv", pairs, num_pairs * count)
            cpu_started = time.process_time()
            summary = run(backend, count, todo, folder / f"{k}", settings)
            driver_cpu = time.process_time() - cpu_started
            yield {
                "scenario": name,
                "backend": backend,
                "workers": count,
                **figures(summary, folder / f"{k}", count),
                "driver_cpu_us": 1e6 * driver_cpu / (num_pairs * count),
                **sizes,
                "list_bytes": todo.stat().st_size / (num_pairs * count),
                **machine(),
            }


def run(
    backend: str, num_workers: int, todo: Path, out: Path, settings: Mapping[str, Any]
) -> batch.Summary:
    if backend == "local":
        return batch.run(todo, out, num_workers=num_workers, **settings)
    import ray

    ray.init(num_cpus=num_workers, include_dashboard=False, log_to_driver=False)
    try:
        return batch.run(todo, out, address="auto", **settings)
    finally:
        ray.shutdown()


def figures(summary: batch.Summary, out: Path, num_workers: int) -> Fields:
    rows = list(batch.read_results(out))
    busy = sum(row.seconds or 0 for row in rows)
    return {
        "pairs": len(rows),
        "statuses": summary.statuses,
        "seconds": summary.seconds,
        "pairs_per_second": len(rows) / summary.seconds,
        # work / (workers x wall): what is missing is start, sending and waiting
        "busy_share": busy / (num_workers * summary.seconds),
        "pair_ms": 1000 * busy / len(rows),
        "pair_cpu_ms": 1000 * sum(row.cpu_seconds or 0 for row in rows) / len(rows),
        "read_ms": 1000 * sum(row.read_seconds or 0 for row in rows) / len(rows),
    }


def do_nothing(pair: batch.Pair, options: Mapping[str, Any]) -> batch.Row:
    return batch.Row(id=pair.id, status="ok", target_from_source=[0.0] * 16, limits_hit=[])


def write_list(path: Path, pairs: list[Fields], count: int) -> Path:
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, ["id", *pairs[0]])
        writer.writeheader()
        for k, pair in zip(range(count), itertools.cycle(pairs)):
            writer.writerow({"id": f"pair-{k:09d}", **pair})
    return path


def input_bytes(pairs: list[Fields]) -> float:
    """Mean size of the files of a pair."""
    files = [Path(file) for pair in pairs for file in pair.values()]
    return sum(file.stat().st_size for file in files if file.exists()) / len(pairs)


def row_bytes(rows: list[batch.Row], folder: Path, count: int = 10_000) -> float:
    """Size of a row in Parquet where no two have the same numbers."""
    rng = np.random.default_rng(0)
    with Sink(folder, "parquet", {}) as sink:
        for k, row in zip(range(count), itertools.cycle(rows)):
            floats = {name: v * rng.random() for name, v in vars(row).items() if type(v) is float}
            pose = rng.random(16).tolist()
            changes = {**floats, "id": f"pair-{k:09d}", "target_from_source": pose}
            sink.write([dataclasses.replace(row, **changes)])
    return sum(part.stat().st_size for part in folder.glob("part-*")) / count


def worker_megabytes(probe: Path, settings: Mapping[str, Any]) -> float:
    """Largest memory of a process that worked on all pairs of the list."""
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=context) as pool:
        return pool.submit(peak_after, probe, settings).result()


def peak_after(probe: Path, settings: Mapping[str, Any]) -> float:
    process(Chunk(tuple(batch.read_pairs(probe))), Work(**settings))
    # ru_maxrss would begin with the memory of the parent
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM")) / 1024


def machine() -> Fields:
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    names = (line for line in lines if "model name" in line)
    return {
        "version": gmcr.__version__,
        "cpu": next(names, "unknown: unknown").split(":")[1].strip(),
        "isa": str(gmcr.instruction_set()),
        "cores": gmcr.hardware_threads(),
        "load": os.getloadavg()[0],
        "date": time.strftime("%Y-%m-%d"),
    }


if __name__ == "__main__":
    main()
