#!/usr/bin/python3
"""Compares two runs of bench_micro: bench/compare.py OLD.json NEW.json [--max-slowdown FACTOR].

Record runs with repetitions, the two programs in turn on a machine with nothing else to do:

    bench_micro --benchmark_repetitions=9 --benchmark_enable_random_interleaving=true \\
        --benchmark_out=OLD.json --benchmark_out_format=json

A difference is beyond noise where the medians differ by more than the larger of 2 % and three
times the spreads (median absolute deviations) of both together. Exits with status 1 where
something is slower than the factor allows, beyond noise.
"""

import argparse
import json
import sys
from pathlib import Path

from reports.micro import compare, table


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument(
        "--max-slowdown", type=float, default=1.1, help="new / old that is accepted (default: 1.1)"
    )
    parser.add_argument("--metric", choices=["cpu_time", "real_time"], default="cpu_time")
    arguments = parser.parse_args()
    try:
        old, new = (json.loads(path.read_text()) for path in (arguments.old, arguments.new))
    except (OSError, ValueError) as error:
        print(f"compare: {error}", file=sys.stderr)
        return 3
    rows = compare(old, new, arguments.metric)
    print(table(rows))
    slower = [row for row in rows if row.is_beyond_noise and row.ratio > arguments.max_slowdown]
    for row in slower:
        print(f"slower: {row.name}: {row.ratio:.2f} x", file=sys.stderr)
    return 1 if slower else 0


if __name__ == "__main__":
    sys.exit(main())
