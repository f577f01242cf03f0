"""Reading clouds by extension."""

from __future__ import annotations

import os
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Union

import numpy as np
import numpy.typing as npt

from .. import _gmcr
from ._cloud import Cloud, finite_rows, to_cloud
from ._e57 import read_e57_scans
from ._las import read_las
from ._rosbag import is_recording, read_recording

PathLike = Union[str, "os.PathLike[str]"]


def read_points(
    path: PathLike,
    *,
    topic: str | None = None,
    index: int = 0,
    mesh_points: int | None = None,
    bin_columns: int | None = None,
) -> npt.NDArray[np.float64]:
    """Points of a cloud file: ``read_cloud(...).points``.

    Parameters
    ----------
    path, topic, index, mesh_points, bin_columns
        As for ``read_cloud``.

    Returns
    -------
    ndarray of float64, shape (N, 3)
        N >= 1, finite, in the order and the unit of the file.

    Raises
    ------
    CloudFileError, ImportError, ValueError
        as ``read_cloud``.
    """
    return read_cloud(
        path, topic=topic, index=index, mesh_points=mesh_points, bin_columns=bin_columns
    ).points


def read_cloud(
    path: PathLike,
    *,
    topic: str | None = None,
    index: int = 0,
    mesh_points: int | None = None,
    bin_columns: int | None = None,
) -> Cloud:
    """Reads a point cloud; the extension, in any case, says the format.

    Parameters
    ----------
    path : path-like
        ``.ply``, ``.pcd``, ``.npy`` (N, 3 or more), text tables (``.xyz``, ``.txt``, ``.asc``,
        ``.pts``, ``.csv``: columns x, y, z by name, or the first three), ``.bin`` (KITTI),
        ``.pcd.bin`` (nuScenes), meshes (``.obj``, ``.off``, ``.stl``, ``.ply`` with faces),
        ``.las``, ``.laz``, ``.e57`` (its scans together, in the frame of the file), or a
        recording: ``.bag``, ``.mcap``, ``.db3`` or the folder of a ROS 2 bag.
    topic : str, optional
        Topic of the recording; not needed where only one has clouds.
    index : int
        Which cloud of the topic, counted from 0.
    mesh_points : int, optional
        Points to spread evenly over the surface of a mesh, 100,000 by default; 0: its vertices.
    bin_columns : int, optional
        Float32 numbers of a point in a ``.bin`` file; told by size and content by default.

    Returns
    -------
    Cloud
        Finite points, the number of others, and what had to be decided. Of a recording a
        ``StampedCloud``.

    Raises
    ------
    CloudFileError
        where the file is malformed or has no finite point; another OSError where it cannot be read.
    ImportError
        where the format needs an extra of the package that is not installed; it says which.
    ValueError
        where the extension is unknown, or ``topic`` or ``index`` does not fit the file.

    Examples
    --------
    >>> cloud = read_cloud("drive.mcap", topic="/lidar/points", index=10)
    """
    path = Path(path)
    if index < 0:
        raise ValueError(f"index: {index} is negative")
    if is_recording(path):
        cloud = next(islice(read_recording(path, topic), index, None), None)
        if cloud is None:
            raise ValueError(f"index: {path} has no {index + 1} clouds with finite points")
        return cloud
    if topic is not None or index != 0:
        raise ValueError(f"topic and index are for recordings, which {path} is not")
    extension = path.suffix.lower()
    if extension in (".las", ".laz"):
        return to_cloud(path, read_las(path))
    if extension == ".e57":
        return to_cloud(path, np.concatenate([np.empty((0, 3)), *read_e57_scans(path)]))
    known = _gmcr.cloud_extensions()
    if extension not in known:
        others = [".las", ".laz", ".e57", ".bag", ".mcap", ".db3"]
        raise ValueError(f"path: {path.name} has none of the extensions {' '.join(known + others)}")
    path.open("rb").close()  # a missing file is the usual error
    points, num_dropped, notes = _gmcr.read_cloud(path, mesh_points, bin_columns)
    return Cloud(points, num_dropped, notes=tuple(notes))


def read_clouds(path: PathLike, *, topic: str | None = None) -> Iterator[Cloud]:
    """Reads the clouds of a file one by one: messages of a recording, scans of an ``.e57`` file.

    Parameters
    ----------
    path, topic
        As for ``read_cloud``; other files are one cloud.

    Yields
    ------
    Cloud
        In the order of the file, those without a finite point left out. Of a recording a
        ``StampedCloud``.

    Raises
    ------
    CloudFileError, ImportError, ValueError
        as ``read_cloud``.
    """
    path = Path(path)
    if is_recording(path):
        return read_recording(path, topic)
    if topic is not None:
        raise ValueError(f"topic is for recordings, which {path} is not")
    if path.suffix.lower() == ".e57":
        return _scans_with_points(path)
    return iter([read_cloud(path)])


def _scans_with_points(path: Path) -> Iterator[Cloud]:
    for points in read_e57_scans(path):
        if len(finite_rows(points)):
            yield to_cloud(path, points)
