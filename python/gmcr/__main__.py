"""``python -m gmcr``: the command-line tool where the wheel holds it, else what needs no Open3D."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import gmcr

from . import _gmcr

TOOL = Path(__file__).parent / "bin" / "gmcr"
EPILOG = """The whole tool (register, match, clique, synth, eval) needs Open3D's
C++ library where the package is built, and is then part of it:
  pip install . --config-settings=cmake.define.GMCR_BUILD_APPS=ON"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the tool; 0 pose found, 1 no pose, 2 bad usage or input, 3 file cannot be read."""
    given = sys.argv[1:] if arguments is None else list(arguments)
    if TOOL.exists():
        # reports are drawn by the Python that runs this
        environment = {"GMCR_PYTHON": sys.executable, **os.environ}
        return subprocess.call([str(TOOL), *given], env=environment)
    options = _parser().parse_args(given)
    try:
        return _info() if options.command == "info" else _solve(options)
    except OSError as error:
        print(f"gmcr: {error}", file=sys.stderr)
        return 3
    except ValueError as error:
        print(f"gmcr: {error}", file=sys.stderr)
        return 2


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="gmcr", epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("info", help="version, instruction set, threads, as JSON")
    solve = commands.add_parser("solve", help="pose from a file of putative matches, as JSON")
    solve.add_argument("matches", type=Path, help=".csv or .npy: source point, target point, a row")
    solve.add_argument("--noise-bound", required=True, help="metres, or auto")
    solve.add_argument("--estimate-scale", action="store_true")
    solve.add_argument("--scale", type=float)
    solve.add_argument("--method", choices=[method.value for method in gmcr.Method])
    solve.add_argument("--evidence", choices=[evidence.value for evidence in gmcr.Evidence])
    solve.add_argument("--threads", type=int, dest="num_threads")
    solve.add_argument("--time-limit", type=float)
    solve.add_argument("--json", action="store_true", help="accepted; the output is always JSON")
    return parser


def _info() -> int:
    fields = {
        "version": gmcr.__version__,
        "isa": gmcr.instruction_set(),
        "supported_isas": gmcr.instruction_sets(),
        "threads": gmcr.hardware_threads(),
    }
    print(json.dumps(fields, indent=2))
    return 0


def _solve(arguments: argparse.Namespace) -> int:
    source, target, noise_bounds, notes = _gmcr.read_matches(arguments.matches)
    for note in notes:
        print(f"gmcr: {arguments.matches}: {note}", file=sys.stderr)
    names = ("scale", "method", "evidence", "num_threads", "time_limit")
    given = {name: getattr(arguments, name) for name in names}
    options = gmcr.Options(**{name: value for name, value in given.items() if value is not None})
    if arguments.estimate_scale:
        options.scale_mode = "estimated"
    if arguments.noise_bound == "auto":
        options.noise_mode = "estimated"
    else:
        options.noise_bound = float(arguments.noise_bound)
    if noise_bounds is not None:
        raise ValueError(f"{arguments.matches}: has noise bounds, and so has --noise-bound")
    result = gmcr.register_correspondences(source, target, options)
    print(result.to_json(options, indent=2))
    return 0 if result.status == "ok" else 1


if __name__ == "__main__":
    sys.exit(main())
