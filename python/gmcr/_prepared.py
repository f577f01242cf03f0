"""Clouds that are prepared once for many pairs."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from . import _gmcr
from ._arguments import as_cloud, cloud_options
from ._gmcr import FrontendOptions, PreparedCloud

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._arguments import CloudLike
    from ._keywords import CloudKeywords

_NUM_START_BYTES = 64  # that tell whether a file is of a prepared cloud


def prepare(
    points: CloudLike,
    frontend: FrontendOptions | None = None,
    **keywords: Unpack[CloudKeywords],
) -> PreparedCloud:
    """A cloud with its voxels, normals and features, for ``register_clouds`` and ``match``.

    Copies share what was made. What another setting needs is made when it is first asked for, and
    kept too. Pairs are matched at one voxel size, the smaller one of the two clouds unless it is
    given: prepare the clouds of many pairs with the same one.

    Parameters
    ----------
    points : array_like, shape (N, 3), or path
        As for ``register_clouds``.
    frontend : FrontendOptions, optional
        ``voxel_size``, ``normal_radius``, ``feature_radius``, ``orientation`` and
        ``source_viewpoint``, which is that of this cloud, are read.
    **keywords
        Fields of ``FrontendOptions``, and ``num_threads``, instead.

    Returns
    -------
    PreparedCloud
        Which can be saved, loaded and pickled.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, or an option out of range.

    Examples
    --------
    >>> scans = [gmcr.prepare(path, voxel_size=0.1) for path in paths]
    >>> result = gmcr.register_clouds(scans[1], scans[0])
    >>> scans[0].save("map.prepared.ply")
    >>> gmcr.PreparedCloud.load("map.prepared.ply").voxel_size
    0.1
    """
    matching, solver = cloud_options(frontend, None, **keywords)
    return _gmcr.prepare(as_cloud(points, "points"), matching, solver.num_threads)


def is_prepared_file(path: str | os.PathLike[str]) -> bool:
    """Whether a file is there and holds something prepared, of whatever version."""
    if not Path(path).is_file():
        return False
    with Path(path).open("rb") as file:
        return PreparedCloud.is_prepared(file.read(_NUM_START_BYTES))


def as_prepared(cloud: CloudLike) -> PreparedCloud | None:
    """A prepared cloud, or that of a file which holds one; else nothing."""
    if isinstance(cloud, PreparedCloud):
        return cloud
    if isinstance(cloud, (str, os.PathLike)) and is_prepared_file(cloud):
        return PreparedCloud.load(cloud)
    return None


def as_prepared_pair(
    source: CloudLike, target: CloudLike, frontend: FrontendOptions
) -> tuple[PreparedCloud, PreparedCloud] | None:
    """Both clouds prepared where one of them is, else nothing."""
    a, b = as_prepared(source), as_prepared(target)
    if a is None and b is not None:
        a = b.beside(as_cloud(source, "source"), frontend, True)
    elif b is None and a is not None:
        b = a.beside(as_cloud(target, "target"), frontend, False)
    return None if a is None or b is None else (a, b)
