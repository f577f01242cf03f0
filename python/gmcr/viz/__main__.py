"""Reports from files: ``python -m gmcr.viz report``, as ``gmcr register --report`` runs it."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from . import _require
from .prepare import scene_of_files

_ARROW = " \u2192 "  # between the names of two clouds


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m gmcr.viz", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("check", help="succeed where reports can be made")
    report = commands.add_parser("report", help="write a self-contained HTML file")
    report.add_argument("result", type=Path, help="JSON object of gmcr register or gmcr solve")
    report.add_argument("--matches", type=Path, required=True, help=".npy, (N, 6) or (N, 7)")
    report.add_argument("--clouds", type=Path, nargs=2, help="source and target, .npy, (N, 3)")
    report.add_argument("--title", default="Registration")
    report.add_argument("-o", "--output", type=Path, required=True, help="HTML file")
    return parser


def _heading(title: str) -> str:
    """The files that the tool names, without the folders that are not needed to tell them apart."""
    paths = [Path(name).parts for name in title.split(_ARROW)]
    for length in range(1, max(map(len, paths), default=0)):
        names = [str(Path(*parts[-length:])) for parts in paths if parts]
        if len(set(names)) == len(paths):
            return _ARROW.join(names)
    return title


def main(arguments: list[str] | None = None) -> int:
    """Runs the command; 0 where it worked, 3 where a file cannot be read or written."""
    given = _parser().parse_args(arguments)
    _require("plotly")
    if given.command == "check":
        return 0
    from .page import write_page

    try:
        clouds = tuple(given.clouds) if given.clouds else None
        outcome, scene = scene_of_files(given.result, given.matches, clouds)
        write_page(given.output, outcome, scene, _heading(given.title))
    except OSError as error:
        print(f"{error.filename or given.output}: {error.strerror or error}", file=sys.stderr)
        return 3
    return 0


if __name__ == "__main__":
    sys.exit(main())
