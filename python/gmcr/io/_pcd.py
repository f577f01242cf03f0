"""PCD files of the Point Cloud Library; compressed ones by Open3D."""

from __future__ import annotations

from pathlib import Path
from typing import BinaryIO

import numpy as np
import numpy.typing as npt

from ._cloud import CloudFileError
from ._fields import read_records
from ._open3d import read_with_open3d

_KINDS = {"F": "f", "I": "i", "U": "u"}


def read_pcd(path: Path) -> npt.NDArray[np.float64]:
    """Coordinates of the points, (N, 3)."""
    with path.open("rb") as file:
        try:
            header = _read_header(file)
            encoding, count = header["DATA"][0], int(header["POINTS"][0])
            if encoding == "binary_compressed":
                return read_with_open3d(path)
            if encoding == "binary":
                return _read_binary(file, header, count)
            if encoding == "ascii":
                return _read_ascii(file, header, count)
        except (ValueError, IndexError, KeyError, TypeError) as error:
            raise CloudFileError(path, f"bad PCD file: {error}") from error
    raise CloudFileError(path, f"unknown PCD data: {encoding}")


def _read_header(file: BinaryIO) -> dict[str, list[str]]:
    header: dict[str, list[str]] = {}
    for line in iter(file.readline, b""):
        words = line.decode("ascii", "replace").split("#")[0].split()
        if words:
            header[words[0]] = words[1:]
            if words[0] == "DATA":
                num_fields = len(header["FIELDS"])
                header.setdefault("COUNT", ["1"] * num_fields)
                for key in ("SIZE", "TYPE", "COUNT"):
                    if len(header[key]) != num_fields:
                        raise ValueError(f"{key} of {len(header[key])} for {num_fields} fields")
                return header
    raise ValueError("the header has no DATA")


def _read_binary(
    file: BinaryIO, header: dict[str, list[str]], count: int
) -> npt.NDArray[np.float64]:
    fields: dict[str, tuple[str, int]] = {}
    size = 0
    for name, kind, width, repeat in zip(
        header["FIELDS"], header["TYPE"], header["SIZE"], header["COUNT"], strict=True
    ):
        fields[name] = (f"<{_KINDS[kind]}{width}", size)
        size += int(width) * int(repeat)
    return read_records(file, fields, size, count)


def _read_ascii(
    file: BinaryIO, header: dict[str, list[str]], count: int
) -> npt.NDArray[np.float64]:
    starts = np.cumsum([0, *map(int, header["COUNT"])])
    columns = [int(starts[header["FIELDS"].index(axis)]) for axis in "xyz"]
    lines = [line for line in file.read().decode("ascii", "replace").splitlines() if line.strip()]
    if len(lines) != count:
        raise ValueError(f"{len(lines)} points, the header says {count}")
    if not lines:
        return np.empty((0, 3))
    return np.loadtxt(lines, np.float64, usecols=columns, ndmin=2)
