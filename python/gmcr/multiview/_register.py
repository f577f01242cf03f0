"""From scans to poses in one call."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from .._arguments import CloudLike
from .._gmcr import FrontendOptions, Options, PreparedCloud
from ._pairs import register_pairs
from ._place import place_scans
from ._result import MultiviewResult
from ._scans import as_scans

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .._keywords import CloudKeywords


def register_scans(
    scans: Sequence[CloudLike],
    pairs: Iterable[tuple[int, int]] | None = None,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    *,
    tolerance: float | None = None,
    **keywords: Unpack[CloudKeywords],
) -> MultiviewResult:
    """Poses of many scans in the frame of the first, from no initial guess.

    Registers the pairs (``register_pairs``), rejects those that contradict the others, and
    optimises the poses of all (``place_scans``).

    Parameters
    ----------
    scans : sequence of array_like, shape (N_i, 3), or paths
        Points, metres, finite; each as a cloud of ``register_clouds``.
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
    >>> result = register_scans(["front.ply", "left.ply", "back.ply"], voxel_size=0.01)
    >>> result.poses[2]  # frame of the first scan from that of the third
    """
    points = as_scans(scans)  # files are read once
    clouds = [
        scan if isinstance(scan, PreparedCloud) else cloud
        for scan, cloud in zip(scans, points, strict=True)
    ]
    edges = register_pairs(clouds, pairs, frontend, options, tolerance=tolerance, **keywords)
    return place_scans(points, edges)
