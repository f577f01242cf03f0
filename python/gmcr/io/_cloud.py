"""What reading a file gives, and what can go wrong."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._gmcr import CloudFileError


def file_error(path: Path, reason: object) -> CloudFileError:
    """A file that is not the cloud that its extension promises; the message is 'path: reason'."""
    return CloudFileError(f"{path}: {reason}")


@dataclass(frozen=True)
class Cloud:
    """A cloud as it was read.

    Attributes
    ----------
    points : ndarray of float64, shape (N, 3)
        N >= 1, finite, in the order and the unit of the file.
    num_dropped : int
        Points of the file that are not finite, a billion times as far as the others, mark no
        return, or that the file calls invalid.
    notes : tuple of str
        What was dropped or had to be decided to read the file, as sentences.
    """

    points: npt.NDArray[np.float64]
    num_dropped: int
    notes: tuple[str, ...] = field(default=(), kw_only=True)


@dataclass(frozen=True)
class StampedCloud(Cloud):
    """A cloud of a recording.

    Attributes
    ----------
    topic : str
        Topic of the message.
    frame : str
        Frame of the points, as in the message's header.
    time_ns : int
        Time of the message's header, nanoseconds.
    """

    topic: str
    frame: str
    time_ns: int


def finite_rows(points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """The rows of (N, 3) points whose coordinates are finite, in C order."""
    is_finite = np.isfinite(points).all(axis=1)
    return np.ascontiguousarray(points if is_finite.all() else points[is_finite])


def to_cloud(path: Path, points: npt.NDArray[np.float64]) -> Cloud:
    """The cloud of what was read.

    Raises
    ------
    CloudFileError
        where there is no finite point, or the shape is not (N, 3).
    """
    if points.ndim != 2 or points.shape[1] != 3:
        raise file_error(path, f"expected points of shape (N, 3), but it is {points.shape}")
    kept = finite_rows(points)
    if len(kept) == 0:
        raise file_error(path, f"no finite point among {len(points)}")
    return Cloud(kept, len(points) - len(kept))


def import_extra(module: str, extra: str, purpose: object) -> Any:
    """A library that an extra of the package installs.

    Raises
    ------
    ImportError
        where it is absent, naming what needs it and the extra.
    """
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        if (error.name or "").split(".")[0] != module.split(".")[0]:
            raise
        raise ImportError(
            f"{purpose}: this needs {module.split('.')[0]}; pip install 'gmcr[{extra}]'"
        ) from error


@contextmanager
def reading_with(library: str, path: Path) -> Iterator[None]:
    """What a library raises on a file that it cannot read, as a ``CloudFileError``.

    Malformed bytes make such libraries raise anything from ``struct.error`` to ``KeyError``.
    """
    try:
        yield
    except (OSError, ImportError, MemoryError):
        raise
    except Exception as error:
        raise file_error(path, f"{library} cannot read it: {error}") from error
