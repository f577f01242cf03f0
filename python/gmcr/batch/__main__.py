"""``python -m gmcr.batch``."""

from __future__ import annotations

import argparse
import re
import signal
import sys
from collections.abc import Sequence
from difflib import get_close_matches
from types import FrameType
from typing import Any

from .options import OPTION_NAMES, advice_on, parse_value
from .run import Summary, run

_DESCRIPTION = """\
Registers many pairs of point sets: on all cores of this machine, or on a Ray cluster.
Run the same command again to go on where it was ended: no pair is lost or done twice."""

_EXAMPLES = """\
pairs: CSV, JSONL or Parquet with the columns id and matches (.csv, .npy), or id, source and target
(clouds); any other column is an option of that pair, such as noise_bound.

  python -m gmcr.batch pairs.csv --out results --noise-bound 0.05
  python -m gmcr.batch scans.jsonl --out results --voxel 0.3 --format jsonl --workers 8
  python -m gmcr.batch pairs.parquet --out results --address auto --set scale_range=[0.5,2]

exit: 0 every pair was worked on, 1 some rows are errors, also of earlier runs, 2 bad usage or
input, 3 a file cannot be read or written, 130 interrupted."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line; returns the exit code."""
    parser = _parser()
    words = sys.argv[1:] if arguments is None else list(arguments)
    _refuse_unknown_flags(parser, words)
    given = parser.parse_args(words)
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        summary = run(
            given.pairs,
            given.out,
            options=_options(given),
            format=given.format,
            address=given.address,
            num_workers=given.workers,
            chunk_pairs=given.chunk,
            retries=given.retries,
            pair_timeout=given.pair_timeout,
            part_seconds=given.part_seconds,
            keep_inliers=given.keep_inliers,
            restart=given.restart,
            retry_errors=given.retry_errors,
            show_progress=not given.quiet,
        )
    except ValueError as error:
        print(f"gmcr.batch: {error}", file=sys.stderr)
        return 2
    except ModuleNotFoundError as error:
        print(f"gmcr.batch: {error}; try: pip install 'gmcr[batch]'", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"gmcr.batch: {error}", file=sys.stderr)
        return 3
    except (KeyboardInterrupt, SystemExit):
        print("gmcr.batch: interrupted; run the same command again to go on", file=sys.stderr)
        return 130
    print(_describe(summary), file=sys.stderr)
    return 1 if summary.num_errors else 0


def _refuse_unknown_flags(parser: argparse.ArgumentParser, words: Sequence[str]) -> None:
    """Says what to write, which argparse does not."""
    known = re.findall(r"--[a-z][a-z-]*", parser.format_help())
    for word in words:
        if word == "--":
            return
        flag = word.partition("=")[0]
        if flag[:2] != "--" or any(each.startswith(flag) for each in known):
            continue
        name = flag[2:].replace("-", "_")
        near = get_close_matches(flag.replace("_", "-"), known, 1, 0.8)
        if not near and name in OPTION_NAMES:
            advice = f"; write --set {name}=VALUE"
        else:
            advice = f"; did you mean {near[0]}?" if near else advice_on(name, ())
        parser.error(f"unrecognized argument {flag}{advice}")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m gmcr.batch",
        description=_DESCRIPTION,
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("pairs", help="list of pairs: .csv, .jsonl, .parquet")
    parser.add_argument("--out", required=True, help="folder for the rows")
    parser.add_argument("--format", choices=("parquet", "jsonl"), default="parquet")
    parser.add_argument("--restart", action="store_true", help="remove earlier rows first")
    parser.add_argument("--retry-errors", action="store_true", help="do the error rows again")
    parser.add_argument("--keep-inliers", action="store_true", help="write inlier indices")
    parser.add_argument(
        "--part-seconds", type=float, default=30, metavar="S", help="work that a crash can cost"
    )
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    workers = parser.add_argument_group("workers")
    workers.add_argument("--address", help="Ray cluster: auto, HOST:PORT or ray://HOST:PORT")
    workers.add_argument("--workers", type=int, default=0, help="processes; 0: one a core")
    workers.add_argument("--chunk", type=int, default=0, help="pairs at a time; 0: about a second")
    workers.add_argument("--retries", type=int, default=2, help="new starts after a worker died")
    workers.add_argument("--pair-timeout", type=float, metavar="S", help="then an error row")
    solver = parser.add_argument_group("options of all pairs")
    solver.add_argument("--noise-bound", metavar="B", help="metres, or auto")
    solver.add_argument("--estimate-scale", action="store_true")
    solver.add_argument("--scale", type=float)
    solver.add_argument(
        "--voxel-size",
        "--voxel",
        dest="voxel",
        type=float,
        metavar="M",
        help="metres, of clouds",
    )
    solver.add_argument("--method", choices=("gmcr", "paper"))
    solver.add_argument("--evidence", choices=("distinct", "count"))
    solver.add_argument("--certify", action="store_true")
    solver.add_argument("--time-limit", type=float, metavar="S", help="then the best pose so far")
    solver.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="NAME=VALUE",
        help="any field of gmcr.Options or gmcr.FrontendOptions",
    )
    return parser


def _options(given: argparse.Namespace) -> dict[str, Any]:
    """Options by name; only those that were given, since the defaults are the library's."""
    options: dict[str, Any] = {}
    if given.noise_bound == "auto":
        options["noise_mode"] = "estimated"
    elif given.noise_bound is not None:
        options["noise_bound"] = float(given.noise_bound)
    if given.estimate_scale:
        options["scale_mode"] = "estimated"
    if given.certify:
        options["certify"] = True
    for name, value in (
        ("scale", given.scale),
        ("voxel_size", given.voxel),
        ("method", given.method),
        ("evidence", given.evidence),
        ("time_limit", given.time_limit),
    ):
        if value is not None:
            options[name] = value
    for setting in given.set:
        name, equals, text = setting.partition("=")
        if not equals:
            raise ValueError(f"--set: expected NAME=VALUE, got {setting!r}")
        options[name] = parse_value(text)
    return options


def _describe(summary: Summary) -> str:
    counts = ", ".join(f"{count} {status}" for status, count in sorted(summary.statuses.items()))
    num_new = sum(summary.statuses.values())
    rate = num_new / summary.seconds if summary.seconds > 0 else 0
    return (
        f"{num_new} of {summary.num_pairs} pairs in {summary.seconds:.1f} s ({rate:.3g} a second), "
        f"{summary.num_skipped} done before; {counts or 'nothing to do'}{_describe_errors(summary)}"
    )


def _describe_errors(summary: Summary) -> str:
    lines = ""
    if summary.first_error:
        lines += f"\nfirst error: {summary.first_error}"
    num_earlier = summary.num_errors - summary.statuses.get("error", 0)
    if num_earlier:
        lines += f"\nerror rows of earlier runs: {num_earlier}; --retry-errors does them again"
    return lines


def _interrupt(signal_number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt


if __name__ == "__main__":
    sys.exit(main())
