"""From scans to poses in one call."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy.typing as npt

from .._gmcr import FrontendOptions, Options
from ._pairs import register_pairs
from ._place import place_scans
from ._result import MultiviewResult


def register_scans(
    scans: Sequence[npt.ArrayLike],
    pairs: Iterable[tuple[int, int]] | None = None,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    *,
    tolerance: float | None = None,
    **keywords: Any,
) -> MultiviewResult:
    """Poses of many scans in the frame of the first, from no initial guess.

    Registers the pairs (``register_pairs``), rejects those that contradict the others, and
    optimises the poses of all (``place_scans``).

    Parameters
    ----------
    scans : sequence of array_like, shape (N_i, 3)
        Points, metres, finite.
    pairs, frontend, options, tolerance, **keywords
        As for ``register_pairs``.

    Returns
    -------
    MultiviewResult
        Poses, groups of connected scans, and what became of each pair.

    Raises
    ------
    ValueError, ImportError
        as ``register_pairs`` and ``place_scans``.

    Examples
    --------
    >>> result = register_scans([front, left, back, right])
    >>> result.poses[2]  # frame of the first scan from that of the third
    """
    edges = register_pairs(scans, pairs, frontend, options, tolerance=tolerance, **keywords)
    return place_scans(scans, edges)
