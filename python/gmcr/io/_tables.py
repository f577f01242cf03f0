"""Rows of numbers, as text or bytes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from ._cloud import CloudFileError


def read_text(path: Path) -> npt.NDArray[np.float64]:
    """First three columns of rows of numbers; ``#`` starts a comment."""
    return _load(path, path.read_text(encoding="utf-8-sig").splitlines(), None, [0, 1, 2])


def read_pts(path: Path) -> npt.NDArray[np.float64]:
    """A line with the number of points, then their rows."""
    lines = path.read_text(encoding="utf-8-sig").splitlines()
    if not lines or not lines[0].strip().isdigit():
        raise CloudFileError(path, "expected the number of points in the first line")
    points = _load(path, lines[1:], None, [0, 1, 2])
    if len(points) != int(lines[0]):
        raise CloudFileError(path, f"{len(points)} points, the first line says {lines[0].strip()}")
    return points


def read_csv(path: Path) -> npt.NDArray[np.float64]:
    """Columns that a header names x, y and z, or the only three."""
    lines = [line for line in path.read_text(encoding="utf-8-sig").splitlines() if line.strip()]
    if not lines:
        return np.empty((0, 3))
    separator = next((mark for mark in ",;" if mark in lines[0]), None)
    cells = [cell.strip().strip('"').lower() for cell in lines[0].split(separator)]
    if {"x", "y", "z"} <= set(cells):
        return _load(path, lines[1:], separator, [cells.index(axis) for axis in "xyz"])
    if len(cells) != 3:
        raise CloudFileError(
            path, f"{len(cells)} columns, expected 3 or a header that names x, y and z"
        )
    return _load(path, lines, separator, [0, 1, 2])


def read_npy(path: Path) -> npt.NDArray[np.float64]:
    """Array of shape (N, 3)."""
    try:
        array = np.load(path, allow_pickle=False)
    except (ValueError, EOFError) as error:
        raise CloudFileError(path, error) from error
    if not isinstance(array, np.ndarray) or array.dtype.kind not in "fiu":
        raise CloudFileError(path, "not an array of numbers")
    return array.astype(np.float64)


def read_kitti(path: Path) -> npt.NDArray[np.float64]:
    """x, y, z and intensity, float32."""
    return _read_rows_of_float32(path, 4)


def read_nuscenes(path: Path) -> npt.NDArray[np.float64]:
    """x, y, z, intensity and ring, float32."""
    return _read_rows_of_float32(path, 5)


def _read_rows_of_float32(path: Path, num_columns: int) -> npt.NDArray[np.float64]:
    data = path.read_bytes()
    if len(data) % (4 * num_columns):
        raise CloudFileError(
            path, f"truncated: {len(data)} bytes are no multiple of {num_columns} float32"
        )
    return np.frombuffer(data, "<f4").reshape(-1, num_columns)[:, :3].astype(np.float64)


def _load(
    path: Path, lines: list[str], separator: str | None, columns: list[int]
) -> npt.NDArray[np.float64]:
    if not any(line.split("#")[0].strip() for line in lines):
        return np.empty((0, 3))
    try:
        return np.loadtxt(lines, np.float64, delimiter=separator, usecols=columns, ndmin=2)
    except ValueError as error:
        raise CloudFileError(path, error) from error
