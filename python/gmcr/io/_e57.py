"""E57 files of terrestrial laser scanners, by pye57."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from ._cloud import import_extra, reading_with


def read_e57_scans(path: Path) -> Iterator[npt.NDArray[np.float64]]:
    """The scans one by one, (N, 3) each, in the frame of the file.

    Points that the scanner marked invalid are rows of NaN.
    """
    pye57 = import_extra("pye57", "e57", path)
    path.open("rb").close()  # a missing file is the usual error, not one of pye57's
    with reading_with("pye57", path), pye57.E57(str(path)) as file:
        for index in range(file.scan_count):
            yield _read_scan(file, index)


def _read_scan(file: Any, index: int) -> npt.NDArray[np.float64]:
    columns = file.read_scan(index, ignore_missing_fields=True)  # pose applied, invalid left out
    points = np.full((file.get_header(index).point_count, 3), np.nan)
    points[: len(columns["cartesianX"])] = np.column_stack(
        [columns[f"cartesian{axis}"] for axis in "XYZ"]
    )
    return points
