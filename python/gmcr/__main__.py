"""``python -m gmcr``: the command-line tool where the wheel holds it, else what needs no Open3D."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt

import gmcr

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
    matches = _read_matches(arguments.matches)
    names = ("scale", "method", "evidence", "num_threads", "time_limit")
    given = {name: getattr(arguments, name) for name in names}
    options = gmcr.Options(**{name: value for name, value in given.items() if value is not None})
    if arguments.estimate_scale:
        options.scale_mode = "estimated"
    if arguments.noise_bound == "auto":
        options.noise_mode = "estimated"
    else:
        options.noise_bound = float(arguments.noise_bound)
    result = gmcr.register_correspondences(matches[:, :3], matches[:, 3:], options)
    print(result.to_json(options, indent=2))
    return 0 if result.status == "ok" else 1


def _read_matches(path: Path) -> npt.NDArray[np.float64]:
    if path.suffix == ".npy":
        matches = np.load(path, allow_pickle=False)
    else:
        lines = path.read_text().splitlines()
        has_header = bool(lines) and any(letter.isalpha() for letter in lines[0].replace("e", ""))
        matches = np.loadtxt(lines[has_header:], delimiter=",", ndmin=2)
    if matches.ndim != 2 or matches.shape[1] != 6:
        raise ValueError(f"{path}: expected 6 columns, but the shape is {matches.shape}")
    return np.asarray(matches, dtype=np.float64)


if __name__ == "__main__":
    sys.exit(main())
