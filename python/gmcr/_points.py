"""Points as people have them, as arrays (N, 3)."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt


class HasPoints(Protocol):
    """A cloud of Open3D or of ``gmcr.io``."""

    @property
    def points(self) -> Any: ...


class HasPositions(Protocol):
    """A cloud of Open3D's tensors."""

    @property
    def point(self) -> Any: ...


PointsLike = npt.ArrayLike | HasPoints | HasPositions
CloudLike = PointsLike | str | os.PathLike[str]
Floats = npt.NDArray[np.float64]


def as_points(values: CloudLike, name: str) -> Floats:
    """(N, 3) float64 array in C order; the very same array where it is one already.

    Parameters
    ----------
    values : CloudLike
        (N, 3) of numbers of any library; an Open3D cloud; a structured array with the fields x, y
        and z, of any shape, as ROS gives it. A path is refused with what to call.
    name : str
        Of the argument, for the messages.

    Raises
    ------
    ValueError
        naming the argument, where the shape is another or these are no numbers, with what to write
        instead.
    """
    if isinstance(values, (str, os.PathLike)):
        raise ValueError(
            f"{name}: expected points, but it is a path; read points by "
            f"gmcr.io.read_points({os.fspath(values)!r}), or a table of matches by "
            f"gmcr.batch.read_matches"
        )
    array = _numbers_of(values, name)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(
            f"{name}: expected shape (N, 3), but it is {array.shape}{_advice_on_shape(array, name)}"
        )
    return np.ascontiguousarray(array, dtype=np.float64)


def as_cloud(values: CloudLike, name: str) -> Floats:
    """``as_points`` of a cloud, which may be a file, and whose points may have more than x, y, z.

    Of (N, 4) and wider arrays the first three columns are read, where there are more points than
    columns: intensities, normals and colours come after x, y, z in every format of clouds.

    Raises
    ------
    ValueError, OSError, ImportError
        as ``as_points`` and ``gmcr.io.read_points``.
    """
    if isinstance(values, (str, os.PathLike)):
        from .io import read_points  # not for those who have arrays

        return read_points(values)
    array = _numbers_of(values, name)
    if array.ndim == 2 and len(array) > array.shape[1] > 3:
        array = array[:, :3]
    return as_points(array, name)


def _numbers_of(values: Any, name: str) -> npt.NDArray[Any]:
    """Numbers of any shape; of structured arrays (N, 3)."""
    array = np.asarray(as_array_like(values))
    if array.dtype.names is not None:
        return _coordinates_of(array, name)
    if array.dtype.kind not in "fiu":
        what = f"the dtype is {array.dtype}" if array.shape else f"it is a {type(values).__name__}"
        raise ValueError(f"{name}: expected numbers, but {what}{_advice_on_object(values, name)}")
    return array


def as_array_like(values: Any) -> Any:
    """What numpy can read, of a cloud or a tensor of another library."""
    if isinstance(values, (np.ndarray, list, tuple)):
        return values
    if hasattr(values, "point"):  # Open3D, tensors
        values = values.point["positions"]
    elif hasattr(values, "points"):  # Open3D, gmcr.io
        values = values.points
    for step in ("detach", "cpu"):  # torch: with a gradient, on a GPU
        values = getattr(values, step, lambda same=values: same)()
    return values if hasattr(values, "__array__") else getattr(values, "numpy", lambda: values)()


def _coordinates_of(array: npt.NDArray[Any], name: str) -> Floats:
    missing = {"x", "y", "z"} - set(array.dtype.names or ())
    if missing:
        raise ValueError(
            f"{name}: expected the fields x, y and z, but there are "
            f"{', '.join(array.dtype.names or ())}"
        )
    return np.column_stack([np.asarray(array[axis], np.float64).ravel() for axis in "xyz"])


def _advice_on_shape(array: npt.NDArray[Any], name: str) -> str:
    if array.ndim != 2:
        return f"; write {name}.reshape(-1, 3)" if array.shape[-1:] == (3,) and array.size else ""
    if array.shape == (4, 4) and np.array_equal(array[3], [0, 0, 0, 1]):
        return "; it looks like a pose, which comes before the points of functions that take one"
    if array.shape[0] == 3:
        return f"; where each column is a point, write {name}.T"
    if array.shape[1] == 6:
        return f"; where these are matches, write source={name}[:, :3], target={name}[:, 3:]"
    if array.shape[1] > 3:
        return f"; where x, y, z come first, write {name}[:, :3]"
    return ""


def _advice_on_object(values: Any, name: str) -> str:
    if isinstance(values, Mapping):
        columns = ", ".join(f"{name}[{axis!r}]" for axis in "xyz")
        key = next((key for key in ("points", "xyz", "positions") if key in values), None)
        return f"; write {name}[{key!r}]" if key else f"; write np.column_stack([{columns}])"
    if hasattr(values, "point_step"):
        return "; of a ROS message: sensor_msgs_py.point_cloud2.read_points(message)"
    if hasattr(values, "vertices"):
        return (
            "; of a mesh sample the surface: mesh.sample_points_uniformly(10000) of Open3D, "
            "mesh.sample(10000) of trimesh"
        )
    return ""
