#!/usr/bin/env python3
"""Features of large clouds, matched all with all and by an index: the table of `bench_features`.

bench/features.py RECORDS.jsonl [--docs docs]

Right: mutual matches within 1.5 voxels of the truth. Prints a table in Markdown, and writes it into
the page.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from page_block import replace_block
from reports.markdown import hardware, milliseconds, number, table
from reports.records import read_records

HEADER = [
    "pair", "voxel", "features", "right, all with all", "right, index", "kept", "all ms", "index ms", "ratio",
]  # fmt: skip


def row_of(record: dict) -> list[str]:
    every, index = record["all"], record["index"]
    return [
        record["scenario"],
        number(record["voxel_size"]),
        f"{record['num_sources']:,} x {record['num_targets']:,}",
        f"{every['num_right']:,} of {every['num_matches']:,}",
        f"{index['num_right']:,} of {index['num_matches']:,}",
        f"{100 * index['num_right'] / max(every['num_right'], 1):.1f} %",
        milliseconds(every["ms"]),
        milliseconds(index["ms"]),
        number(index["ms"] / every["ms"], 2),
    ]


def summary(records: list[dict]) -> str:
    every, index = (sum(record[how]["num_right"] for record in records) for how in ("all", "index"))
    return f"All pairs together: {index:,} of {every:,} right matches are kept, {100 * index / every:.1f} %.\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("records", type=Path)
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    arguments = parser.parse_args()
    records = read_records(arguments.records)
    if not records:
        return 1
    text = hardware(records) + "\n" + table(HEADER, map(row_of, records)) + "\n" + summary(records)
    print(text)
    if arguments.docs:
        replace_block(arguments.docs, "features", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
