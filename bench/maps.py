#!/usr/bin/env python3
"""A scan in a map: the table of what `bench_maps` recorded.

bench/maps.py RECORDS.jsonl ... [--docs docs]

Right: within 0.5 m and 2 degrees. Of another place: scans that were not taken in the map, of which
none is right. Prints a table in Markdown, and writes it into the page.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from page_block import replace_block
from reports.markdown import count_cell, hardware, milliseconds, number, table
from reports.records import group_by, median_of, quantile_of, read_records

HEADER = [
    "map", "points", "prior", "scans", "right", "trusted", "wrong trusted", "error m", "covered",
    "CPU ms median", "p95", "prepared s", "peak MiB",
]  # fmt: skip


def prior_of(record: dict) -> str:
    words = [word for word in ("gravity", "initial_pose") if record[word]]
    return ", ".join(words).replace("_", " ") or "none"


def row_of(group: list[dict]) -> list[str]:
    trusted = [record for record in group if record["verdict"] == "trusted"]
    right = [record for record in group if record["success"]]
    first = group[0]
    share = median_of(group, "source_share")
    return [
        f"{first['scenario']}, seed {first['seed']}"
        + (", by features" if first["method"] == "register_clouds" else ""),
        f"{first['num_map_points'] / 1e6:.1f} M",
        prior_of(first),
        first["group"],
        "-" if first["is_elsewhere"] else count_cell(group, "success"),
        str(sum(record["success"] for record in trusted)),
        str(sum(not record["success"] for record in trusted)),
        number(median_of(right, "errors", "translation"), 2),
        "-" if share is None else f"{100 * share:.0f} %",
        milliseconds(median_of(group, "cpu_ms")),
        milliseconds(quantile_of(group, 0.95, "cpu_ms")),
        number(first["prepare_cpu_ms"] / 1000, 2),
        milliseconds(max(record["peak_mib"] for record in group)),
    ]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("records", nargs="+", type=Path)
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    arguments = parser.parse_args()
    records = [record for path in arguments.records for record in read_records(path)]
    if not records:
        return 1
    groups = group_by(records, "scenario", "seed", "method", "gravity", "initial_pose", "group")
    text = hardware(records) + "\n" + table(HEADER, [row_of(group) for group in groups.values()])
    print(text)
    if arguments.docs:
        replace_block(arguments.docs, "maps", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
