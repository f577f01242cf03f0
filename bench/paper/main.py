"""Command line of the experiments."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from paper.methods import METHODS
from paper.report import write_report
from paper.runner import Runner
from paper.scenarios import EXPERIMENTS


def parse_arguments(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="bench/paper/run",
        description="Runs the experiments of the paper and writes records, tables and figures. "
        "A run that was stopped goes on where it was.",
    )
    parser.add_argument("--quick", action="store_true", help="fewer problems, a few minutes")
    parser.add_argument(
        "--experiments",
        type=_names_of(EXPERIMENTS),
        default=list(EXPERIMENTS),
        metavar="A,B",
        help=f"of {', '.join(EXPERIMENTS)} (default: all)",
    )
    parser.add_argument(
        "--methods",
        type=_names_of(METHODS),
        default=list(METHODS),
        metavar="A,B",
        help=f"of {', '.join(METHODS)} (default: all)",
    )
    parser.add_argument(
        "--out", type=Path, help="folder (default: out/bench-paper or out/bench-paper-quick)"
    )
    parser.add_argument(
        "--time-limit", type=float, default=10.0, help="seconds a solve (default: 10)"
    )
    options = parser.parse_args(arguments)
    if options.time_limit <= 0:
        parser.error(f"--time-limit: {options.time_limit}, must be > 0")
    if options.out is None:
        options.out = Path("out/bench-paper-quick" if options.quick else "out/bench-paper")
    return options


def _names_of(known: dict) -> object:
    def parse(text: str) -> list[str]:
        names = text.split(",")
        for name in names:
            if name not in known:
                raise argparse.ArgumentTypeError(f"unknown: {name}; known: {', '.join(known)}")
        return names

    return parse


def main() -> int:
    options = parse_arguments(sys.argv[1:])
    try:
        with Runner(options.out, options.methods, options.time_limit) as runner:
            for number, name in enumerate(options.experiments, 1):
                print(f"experiment {number} of {len(options.experiments)}", file=sys.stderr)
                runner.run(EXPERIMENTS[name], options.quick)
    except KeyboardInterrupt:
        print("interrupted; run the same command again to go on", file=sys.stderr)
        return 130
    write_report(options.out, options.out / "tables.md", options.out / "figures")
    print(f"records, tables.md and figures/ are in {options.out}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
