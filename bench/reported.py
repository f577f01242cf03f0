#!/usr/bin/env python3
"""Runs what people reported to other tools, and says what was expected and what came out.

bench/reported.py [--tool build/release/bin/gmcr] [--docs docs]

Prints a table in Markdown, and writes it into the page. Needs the real data: $GMCR_DATA, else
../shared/data. Exits with 1 where something is not as expected.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from page_block import replace_block
from paper.data import data_root

LEVEL = "--gravity 0 0 -1 --max-tilt 0"
ODOMETRY = "--initial-pose odometry.txt --max-rotation-error 15 --max-translation-error 1.5"


@dataclass(frozen=True)
class Expected:
    """Of a run: a right pose, none, or no trust."""

    truth: str = ""  # file; "": no pose is right
    max_deg: float = 1.0
    max_error: float = 0.0  # mean point error, in the unit of the target
    may_refuse: bool = False  # or say that it is not to be trusted

    def __str__(self) -> str:
        if not self.truth:
            return "no pose, or not trusted"
        right = f"{self.max_deg:g} deg, {self.max_error:g}"
        return f"{right}, or not trusted" if self.may_refuse else right


@dataclass(frozen=True)
class Got:
    exit_code: int
    seconds: float
    answer: dict | None
    words: str  # of an error

    @property
    def verdict(self) -> str:
        return str(self.answer["verdict"]) if self.answer else "-"


def right(max_deg: float, max_error: float, truth: str = "T_truth.txt") -> Expected:
    return Expected(truth, max_deg, max_error)


def right_or_doubted(max_deg: float, max_error: float, truth: str = "T_truth.txt") -> Expected:
    return Expected(truth, max_deg, max_error, may_refuse=True)


NOT_TRUSTED = Expected()

RUNS: dict[str, list[tuple[str, Expected]]] = {
    "01-four-pairs-plane": [
        ("solve matches.csv --noise-bound 10", right(1, 10)),
        ("solve matches.csv --noise-bound auto", right_or_doubted(1, 10)),
    ],
    "03-no-similarity-fits": [
        ("solve matches.csv --noise-bound 1", NOT_TRUSTED),
        ("solve matches.csv --noise-bound 1 --estimate-scale", NOT_TRUSTED),
    ],
    "04-three-collinear": [("solve matches.csv --noise-bound 0.01", NOT_TRUSTED)],
    "05-coincident-targets": [
        ("solve matches.csv --noise-bound 0.01", NOT_TRUSTED),
        ("solve matches.csv --noise-bound 1", NOT_TRUSTED),
    ],
    "06-three-rough-pairs": [
        ("solve matches.csv --noise-bound 0.3", NOT_TRUSTED),
        ("solve matches.csv --noise-bound auto", NOT_TRUSTED),
    ],
    "07-nine-gcp-national-grid": [
        ("solve matches.csv --noise-bound 0.3", right(0.1, 0.1)),
        *(
            (
                f"solve matches_two_swapped.csv --noise-bound {bound}",
                right(0.1, 0.1, "T_truth_swapped.txt"),
            )
            for bound in ("0.3", "auto")
        ),
    ],
    "08-xyz-commas-utm": [
        ("register source.xyz target.xyz", right(0.1, 0.004)),
        ("register local/source.xyz local/target.xyz", right(0.1, 0.004, "local/T_truth.txt")),
    ],
    "09-cloudcompare-ascii": [
        (f"register source{name} target{name}", right(0.1, 0.01))
        for name in (".xyz", ".pts", "_hdr.xyz", "_cc.txt")
    ],
    "10-pts-without-count": [("register source.pts target.pts", right(0.1, 0.02))],
    "11-pcd-organised-zeros": [
        (f"register {a}.pcd {b}.pcd", right(0.3, 0.02))
        for a, b in (
            ("source", "target"),
            ("source_nan", "target_nan"),
            ("source_c", "target_c"),
            ("n0.89_s", "n0.89_t"),
            ("n0.905_s", "n0.905_t"),
        )
    ],
    "12-ply-quirks": [
        (f"register {name} target.ply", right(0.1, 0.005))
        for name in (
            *(
                f"{n}.ply"
                for n in (
                    "order_double",
                    "big_endian",
                    "crlf_binary",
                    "crlf_ascii_faces",
                    "extra_elements",
                    "faces_first",
                    "float32_names",
                    "ascii_nan_inf",
                    "scalar_inf",
                    "scalar_qnan",
                    "trailing_blanks",
                )
            ),
            *(f"{n}.pcd" for n in ("no_version", "no_points", "dbl_compressed", "stored_raw")),
            *(f"{n}.xyz" for n in ("qnan", "decimal_comma", "fortran_D", "off")),
        )
    ],
    "13-bin-three-columns": [("register source.bin target.bin", right_or_doubted(0.2, 0.02))],
    "14-mesh-vertices-as-model": [
        (f"register {clouds}", right_or_doubted(2, 1.0))
        for clouds in (
            "model_mesh.ply scan.ply",
            "model_sampled.ply scan.ply",
            "model_sampled.ply scan_all_sides.ply",
            "model_sampled.ply scan_all_sides.ply --orientation outward",
        )
    ],
    "17-scan-to-map": [
        ("register scan.ply map.ply", right(0.3, 0.1)),
        ("register scan.ply submap.ply", right(0.3, 0.1)),
        ("register scan.ply submap.ply --voxel 0.5", right(0.3, 0.1)),
    ],
    "19-float32-utm-quantised": [
        ("register source_f64.ply target_f64.ply", right(0.1, 0.03)),
        ("register source_f32.ply target_f32.ply", right_or_doubted(0.5, 0.1)),
        ("register source_local.ply target_local.ply", right(0.1, 0.03, "T_local.txt")),
        ("register source_6digits.csv target_6digits.csv", right_or_doubted(0.5, 0.1)),
    ],
    "20-real-matches-4138": [
        (f"solve matches.csv --noise-bound {bound}", right(2, 0.09))
        for bound in ("0.03", "0.05", "auto")
    ],
    "21-few-outliers-dense-graph": [
        ("solve matches_1889_170.csv --noise-bound 0.05", right(0.5, 0.05)),
        ("solve matches_30000_3000.npy --noise-bound auto", right(0.5, 0.05)),
        ("solve matches_50000_0.npy --noise-bound auto", right(0.5, 0.05)),
        ("solve nn_20000.npy --noise-bound 0.02", right(0.5, 0.05, "T_nn.txt")),
    ],
    "22-raw-clouds-as-matches": [
        (f"solve matches_{rest}", NOT_TRUSTED)
        for rest in (
            "500.csv --noise-bound 0.01",
            "5000.csv --noise-bound 0.05",
            "5000.csv --noise-bound 0.05 --estimate-scale",
            "500.csv --noise-bound auto",
        )
    ],
    "23-planar-2d": [
        (f"solve matches.csv --noise-bound 0.05 {LEVEL}", right(1, 0.05)),
    ],
    "25-millimetres-against-metres": [
        ("register source_mm.ply target_m.ply", NOT_TRUSTED),
        ("register source_mm.ply target_m.ply --estimate-scale", right(0.3, 0.01)),
        (
            "register source_m.ply target_mm.ply --estimate-scale --scale-range 900 1100",
            right(0.3, 10, "T_truth_mm.txt"),
        ),
    ],
    "26-corridor-repeated-doors": [
        ("register source.ply target.ply", right_or_doubted(1, 0.05)),
        (f"register source.ply target.ply {ODOMETRY}", right(0.5, 0.02)),
    ],
    "28-2d-laser-scans": [
        (f"register source.xyz target.xyz {LEVEL}", right_or_doubted(1, 0.1)),
        ("register source_ex.xyz target_ex.xyz", right_or_doubted(1, 0.1)),
        ("register source2.csv target.xyz", right_or_doubted(1, 0.1)),
    ],
    "30-two-pairs-level": [
        (f"solve matches2.csv --noise-bound 0.02 {LEVEL}", right(1, 0.02)),
        ("solve matches3.csv --noise-bound 0.02", right(1, 0.02)),
        (
            f"solve matches1.csv --noise-bound 0.02 {LEVEL} --initial-pose T_truth.txt"
            " --max-rotation-error 0",
            right(0.01, 0.02),
        ),
    ],
    "32-seventh-column-is-a-score": [
        ("solve score.csv", right_or_doubted(1, 0.03)),
        ("solve score.csv --noise-bound 0.03", right_or_doubted(1, 0.03)),
        ("solve score_header.csv --noise-bound 0.03", right(1, 0.03)),
        ("solve index_first.csv --noise-bound 0.03", right_or_doubted(1, 0.03)),
    ],
    "34-degenerate-and-extreme-clouds": [
        *(
            (f"register {a}.xyz {b}.xyz", NOT_TRUSTED)
            for a in ("one", "two", "same", "line", "plane", "empty")
            for b in ("one", "plane2")
        ),
        *(
            (f"register s_{k}.ply t_{k}.ply", right(0.2, 0.02 * 10.0**k, f"T_{k}.txt"))
            for k in (-9, -6, 6, 9, 15)
        ),
    ],
    "35-bare-ground-two-cameras": [
        ("register right_0.ply left_0.ply", NOT_TRUSTED),
        ("register right_1.ply left_1.ply", NOT_TRUSTED),
        ("register right_bumps.ply left_bumps.ply", right_or_doubted(1, 0.02)),
        ("register edge_a.ply edge_b.ply", NOT_TRUSTED),
    ],
    "37-fine-voxels-dense-rooms": [
        ("register source.ply target.ply --voxel 0.03 --time-limit 5", right_or_doubted(1, 0.05)),
    ],
}


def run(tool: Path, folder: Path, words: str) -> Got:
    begin = time.monotonic()
    process = subprocess.run(
        [tool.resolve(), *words.split(), "--json"], cwd=folder, capture_output=True, text=True
    )
    seconds = time.monotonic() - begin
    answer = json.loads(process.stdout) if process.stdout.startswith("{") else None
    said = process.stderr.strip().splitlines()
    return Got(process.returncode, seconds, answer, said[-1] if said else "")


def sources_of(matches: Path) -> np.ndarray:
    if matches.suffix == ".npy":
        return np.asarray(np.load(matches), dtype=float)[:, :3]
    first = 1 if matches.name.startswith("index") else 0
    rows = [re.split(r"[,;\s]+", line.strip()) for line in matches.read_text().splitlines()]
    numbers = [row[first : first + 3] for row in rows if re.match(r"[-+.\d]", row[0])]
    return np.array(numbers, dtype=float)


def errors(tool: Path, folder: Path, words: str, got: Got, truth: str) -> tuple[float, float]:
    """Degrees, and the mean distance of the points of the source from where the truth puts them."""
    source = folder / words.split()[1]
    with tempfile.TemporaryDirectory() as scratch:
        if words.startswith("solve"):
            matches, source = source, Path(scratch) / "source.xyz"
            np.savetxt(source, sources_of(matches), fmt="%.17g")
        found = Path(scratch) / "found.txt"
        np.savetxt(found, got.answer["target_from_source"], fmt="%.17g")
        words_of_eval = ["eval", found, folder / truth, "--points", source, "--json"]
        process = subprocess.run(
            [tool.resolve(), *words_of_eval], capture_output=True, text=True, check=True
        )
    said = json.loads(process.stdout)
    return said["rotation_error_deg"], said["mean_point_error"]


def outcome(tool: Path, folder: Path, words: str, wanted: Expected) -> tuple[bool, str, Got]:
    """Whether it is as expected, and what came out in words."""
    got = run(tool, folder, words)
    has_pose = got.answer is not None and got.answer.get("target_from_source") is not None
    if not has_pose:
        is_refused = got.exit_code in (1, 2, 3)
        said = got.answer["status"] if got.answer else got.words[:90]
        return is_refused and (wanted.may_refuse or not wanted.truth), f"refused: {said}", got
    if not wanted.truth:
        return got.verdict != "trusted", "a pose", got
    degrees, error = errors(tool, folder, words, got, wanted.truth)
    is_right = degrees <= wanted.max_deg and error <= wanted.max_error
    is_doubted = wanted.may_refuse and got.verdict != "trusted"
    return is_right or is_doubted, f"{degrees:.2g} deg, {error:.2g}", got


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tool", type=Path, default=Path("build/release/bin/gmcr"))
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    parser.add_argument("--reports", default="", help="those whose names match")
    given = parser.parse_args()
    rows = [["report", "run", "expected", "got", "verdict", "s", ""], ["---"] * 7]
    num_failed = 0
    for name, runs in RUNS.items():
        if not re.search(given.reports, name):
            continue
        for words, wanted in runs:
            is_met, said, got = outcome(given.tool, data_root() / "reports" / name, words, wanted)
            num_failed += not is_met
            mark = "" if is_met else "**no**"
            row = [name, f"`{words}`", str(wanted), said, got.verdict, f"{got.seconds:.2g}", mark]
            rows.append(row)
            print("| " + " | ".join(row) + " |", flush=True)
    table = "".join("| " + " | ".join(row) + " |\n" for row in rows)
    num_runs = len(rows) - 2
    text = (
        f"`bench/reported.py`: {num_runs - num_failed} of {num_runs} as expected; errors are those "
        f"of the rotation and of the points, in the unit of the target.\n\n{table}"
    )
    print(f"{num_runs - num_failed} of {num_runs} as expected")
    if given.docs:
        replace_block(given.docs, "reported", text)
    return int(num_failed > 0)


if __name__ == "__main__":
    raise SystemExit(main())
