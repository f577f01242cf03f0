"""Scans as they are given."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from .._arguments import as_points
from ._motion import Matrix


def as_scans(scans: Sequence[npt.ArrayLike]) -> list[Matrix]:
    """(N_i, 3) float64 arrays in C order.

    Raises
    ------
    ValueError
        where there is none, or one is empty, not finite, or of another shape.
    """
    if len(scans) == 0:
        raise ValueError("scans: expected at least one")
    points = [as_points(scan, f"scans[{index}]") for index, scan in enumerate(scans)]
    for index, scan in enumerate(points):
        if len(scan) == 0 or not np.isfinite(scan).all():
            raise ValueError(f"scans[{index}]: expected finite points, at least one")
    return points
