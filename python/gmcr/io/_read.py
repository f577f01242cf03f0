"""Reading clouds by extension."""

from __future__ import annotations

import os
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Union

import numpy as np
import numpy.typing as npt

from ._cloud import Cloud, finite_rows, to_cloud
from ._e57 import read_e57_scans
from ._las import read_las
from ._open3d import read_with_open3d
from ._pcd import read_pcd
from ._ply import read_ply
from ._rosbag import is_recording, read_recording
from ._tables import read_csv, read_kitti, read_npy, read_nuscenes, read_pts, read_text

PathLike = Union[str, "os.PathLike[str]"]

_READERS = {
    ".ply": read_ply,
    ".pcd": read_pcd,
    ".npy": read_npy,
    ".xyz": read_text,
    ".txt": read_text,
    ".pts": read_pts,
    ".csv": read_csv,
    ".bin": read_kitti,
    ".las": read_las,
    ".laz": read_las,
    ".obj": read_with_open3d,
    ".stl": read_with_open3d,
    ".off": read_with_open3d,
}


def read_points(
    path: PathLike, *, topic: str | None = None, index: int = 0
) -> npt.NDArray[np.float64]:
    """Points of a cloud file: ``read_cloud(...).points``, (N, 3), in the unit of the file."""
    return read_cloud(path, topic=topic, index=index).points


def read_cloud(path: PathLike, *, topic: str | None = None, index: int = 0) -> Cloud:
    """Reads a point cloud; the extension, in any case, says the format.

    Parameters
    ----------
    path : path-like
        ``.ply``, ``.pcd``, ``.npy`` (N, 3), ``.xyz`` and ``.txt`` (three columns and more),
        ``.pts``, ``.csv`` (columns x, y, z by name, or exactly 3), ``.bin`` (KITTI),
        ``.pcd.bin`` (nuScenes), ``.las``, ``.laz``, ``.e57`` (its scans together, in the frame of
        the file), the vertices of ``.obj``, ``.stl`` and ``.off``, or a recording: ``.bag``,
        ``.mcap``, ``.db3`` or the folder of a ROS 2 bag.
    topic : str, optional
        Topic of the recording; not needed where only one has clouds.
    index : int
        Which cloud of the topic, counted from 0.

    Returns
    -------
    Cloud
        Finite points and the number of others. Of a recording a ``StampedCloud``.

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
    return to_cloud(path, _read_whole(path))


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


def _read_whole(path: Path) -> npt.NDArray[np.float64]:
    if path.name.lower().endswith(".pcd.bin"):
        return read_nuscenes(path)
    extension = path.suffix.lower()
    if extension == ".e57":
        return np.concatenate([np.empty((0, 3)), *read_e57_scans(path)])
    if extension not in _READERS:
        known = " ".join([*_READERS, ".pcd.bin", ".e57", ".bag", ".mcap", ".db3"])
        raise ValueError(f"path: {path.name} has none of the extensions {known}")
    return _READERS[extension](path)
