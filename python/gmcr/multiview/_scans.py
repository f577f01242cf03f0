"""Scans as they are given."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .._arguments import CloudLike, as_cloud
from ._motion import Matrix


def as_scans(scans: Sequence[CloudLike]) -> list[Matrix]:
    """(N_i, 3) float64 arrays in C order.

    Raises
    ------
    ValueError
        where there is none, or one is empty, not finite, or of another shape.
    """
    if len(scans) == 0:
        raise ValueError("scans: expected at least one")
    points = [as_cloud(scan, f"scans[{index}]") for index, scan in enumerate(scans)]
    for index, scan in enumerate(points):
        if len(scan) == 0 or not np.isfinite(scan).all():
            raise ValueError(f"scans[{index}]: expected finite points, at least one")
    return points
