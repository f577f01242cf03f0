"""LAS and LAZ files of airborne and mobile laser scanners, by laspy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from ._cloud import file_error, import_extra, reading_with


def read_las(path: Path) -> npt.NDArray[np.float64]:
    """Coordinates with scale and offset of the header applied in double, (N, 3)."""
    laspy = import_extra("laspy", "las", path)
    with path.open("rb") as file, reading_with("laspy", path):
        las = laspy.read(file)
        if las.header.are_points_compressed and not laspy.LazBackend.detect_available():
            raise ImportError(f"{path}: this needs lazrs; pip install 'gmcr[las]'")
        if len(las.points) < las.header.point_count:
            raise file_error(
                path, f"truncated: {len(las.points)} points of {las.header.point_count}"
            )
        return np.asarray(las.xyz, dtype=np.float64)
