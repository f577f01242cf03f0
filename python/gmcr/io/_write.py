"""Writing clouds."""

from __future__ import annotations

from pathlib import Path

import numpy.typing as npt

from .. import _gmcr
from .._arguments import as_points
from ._read import PathLike


def write_points(path: PathLike, points: npt.ArrayLike) -> None:
    """Writes points, whole or not at all: a file that is there already is replaced at the end.

    Parameters
    ----------
    path : path-like
        Ends in ``.ply`` (binary float64), ``.npy``, ``.xyz``, ``.txt``, ``.asc`` or ``.csv``, which
        read back as the same bits, or in ``.pcd``: float32 unless that would move a point by more
        than a millionth of the extent.
    points : array_like, shape (N, 3)
        Metres.

    Raises
    ------
    ValueError
        where the extension or the shape is another.
    CloudFileError
        where the file cannot be written.
    """
    path, array = Path(path), as_points(points, "points")
    known = _gmcr.written_cloud_extensions()
    if path.suffix.lower() not in known:
        raise ValueError(f"path: {path.name} does not end in {', '.join(known)}")
    _gmcr.write_cloud(path, array)
