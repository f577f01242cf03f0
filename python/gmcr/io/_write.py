"""Writing clouds."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from .._arguments import as_points
from ._ply import write_ply
from ._read import PathLike


def write_points(path: PathLike, points: npt.ArrayLike) -> None:
    """Writes points so that reading the file gives the same bits.

    Parameters
    ----------
    path : path-like
        Ends in ``.ply`` (binary float64), ``.npy``, ``.xyz`` or ``.csv``.
    points : array_like, shape (N, 3)
        Metres.

    Raises
    ------
    ValueError
        where the extension or the shape is another.
    """
    path, array = Path(path), as_points(points, "points")
    extension = path.suffix.lower()
    if extension == ".ply":
        write_ply(path, array)
    elif extension == ".npy":
        np.save(path, array)
    elif extension == ".xyz":
        np.savetxt(path, array, "%.17g")
    elif extension == ".csv":
        np.savetxt(path, array, "%.17g", delimiter=",", header="x,y,z", comments="")
    else:
        raise ValueError(f"path: {path.name} does not end in .ply, .npy, .xyz or .csv")
