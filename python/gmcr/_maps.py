"""Where in a map a scan was taken."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from . import _gmcr
from ._arguments import as_cloud, cloud_options
from ._gmcr import CloudResult, FrontendOptions, Options, PreparedCloud, PreparedMap
from ._prepared import is_prepared_file

if TYPE_CHECKING:
    import numpy.typing as npt
    from typing_extensions import Unpack

    from ._arguments import CloudLike
    from ._keywords import CloudKeywords

_UP = (0.0, 0.0, 1.0)


def prepare_map(
    points: CloudLike,
    frontend: FrontendOptions | None = None,
    *,
    up: npt.ArrayLike = _UP,
    **keywords: Unpack[CloudKeywords],
) -> PreparedMap:
    """A map with what ``localise_scan`` needs, made once and used often, by several threads too.

    Parameters
    ----------
    points : array_like, shape (N, 3), or path
        As for ``register_clouds``, N >= 1; or a file that ``PreparedMap.save`` or
        ``gmcr prepare --map`` wrote, which brings its voxel size.
    frontend : FrontendOptions, optional
        ``voxel_size`` is read, metres; 0 chooses it so that a voxel has about 16 points.
    up : array_like, shape (3,)
        Which way is up in the map, any length > 0.
    **keywords
        Fields of ``FrontendOptions``, and ``num_threads``, instead.

    Returns
    -------
    PreparedMap
        Which can be saved and loaded.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, an option out of range, no points, or points
        that spread over more than 10^8 cells of two voxels, seen from above.

    Examples
    --------
    >>> town = gmcr.prepare_map("map.ply", voxel_size=0.5)
    >>> town.save("town.map.ply")
    """
    matching, solver = cloud_options(frontend, None, **keywords)
    if isinstance(points, (str, os.PathLike)) and is_prepared_file(points):
        loaded = PreparedMap.load(points, up)
        if matching.voxel_size not in (0, loaded.voxel_size):
            raise ValueError("voxel_size: the map was prepared with another one")
        return loaded
    return _gmcr.prepare_map(as_cloud(points, "points"), matching, up, solver.num_threads)


def localise_scan(
    scan: CloudLike,
    map: PreparedMap | CloudLike,
    frontend: FrontendOptions | None = None,
    options: Options | None = None,
    **keywords: Unpack[CloudKeywords],
) -> CloudResult:
    """Where in a map a scan was taken, from no initial pose.

    Scan and map are laid level, and what stands on the ground is compared, seen from above, at all
    positions on the ground of the map and in all headings. The best places are refined and compared
    by how much of the scan the map covers. The verdict speaks of the scan alone; other places at
    which it fits about as well are ``rivals``.

    Parameters
    ----------
    scan : array_like, shape (N, 3), or path
        One sweep of a sensor, metres, finite; the sensor at ``source_viewpoint``, the origin by
        default.
    map : PreparedMap, array_like or path
        The map; what is no ``PreparedMap`` is made one, as ``prepare_map`` does.
    frontend : FrontendOptions, optional
        ``source_viewpoint``, ``noise_bound_voxels`` and ``refine`` are read, and ``voxel_size`` for
        a map that is not prepared.
    options : Options, optional
        The priors, ``scale``, ``num_threads`` and ``time_limit`` are read. Without ``gravity`` the
        z axis of the scan points up, to 15 degrees.
    **keywords
        Fields of ``Options`` and ``FrontendOptions``, instead of these, as for
        ``register_clouds``.

    Returns
    -------
    CloudResult
        ``matches`` are pairs of voxels that meet under the pose.

    Raises
    ------
    ValueError
        on a wrong shape, a value that is not finite, an option out of range, a scale that is to be
        estimated, or a gravity prior whose axis is not the vertical of the map.
    OSError
        where a file cannot be read.

    Examples
    --------
    >>> town = gmcr.prepare_map("map.ply")
    >>> result = gmcr.localise_scan("scan.ply", town)
    >>> result.verdict, result.matrix()
    """
    matching, solver = cloud_options(frontend, options, **keywords)
    if isinstance(map, PreparedCloud):
        raise ValueError("map: a PreparedCloud is for pairs of clouds; give its points")
    prepared = map if isinstance(map, PreparedMap) else prepare_map(map, matching)
    return _gmcr.localise_scan(as_cloud(scan, "scan"), prepared, matching, solver)
