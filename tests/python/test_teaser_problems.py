"""TEASER++'s own test problems, with exact truth: unknown scale, at their own bounds."""

from __future__ import annotations

import os
from pathlib import Path

import gmcr
import gmcr.io
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("GMCR_DATA", ROOT.parent / "shared" / "data")) / "teaser"
INLIERS = {1: 10, 2: 9, 3: 7, 4: 25, 5: 10, 6: 10}


def numbers(path: Path) -> np.ndarray:
    rows = [line.replace(",", " ").split() for line in path.read_text().splitlines()]
    return np.array([[float(word) for word in row] for row in rows if row])


@pytest.mark.parametrize("number", INLIERS)
def test_is_solved_exactly_and_proven(number: int) -> None:
    folder = DATA / f"benchmark_{number}"
    if not folder.exists():
        pytest.skip(f"needs {folder}")
    lines = (folder / "parameters.txt").read_text().splitlines()
    parameters = dict(line.split(":") for line in lines if ":" in line)
    source, target = (gmcr.io.read_points(folder / f"{name}.ply") for name in ("src", "dst"))
    result = gmcr.register_correspondences(
        source,
        target,
        noise_bound=float(parameters["Noise Bound"]),
        scale_mode="estimated",
        certify=True,
    )
    assert result.status == "ok"
    assert len(result.inliers) == result.certificate.lower == INLIERS[number]
    assert result.certificate.certified
    tolerance = 1e-2 if number == 6 else 1e-5
    assert result.scale == pytest.approx(float(numbers(folder / "s_ref.csv")[0, 0]), abs=tolerance)
    assert result.rotation == pytest.approx(numbers(folder / "R_ref.csv"), abs=tolerance)
    assert result.translation == pytest.approx(numbers(folder / "t_ref.csv").ravel(), abs=tolerance)
