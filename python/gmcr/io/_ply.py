"""PLY files: the x, y, z of their vertices, whatever else they hold."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import BinaryIO

import numpy as np
import numpy.typing as npt

from ._cloud import CloudFileError
from ._fields import read_records

_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
    "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8",
}  # fmt: skip
_BYTE_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass
class _Element:
    name: str
    count: int
    types: dict[str, str | None] = field(default_factory=dict)  # of its properties; None: a list


def read_ply(path: Path) -> npt.NDArray[np.float64]:
    """Coordinates of the vertices, (N, 3); faces and further elements are skipped."""
    with path.open("rb") as file:
        try:
            byte_order, elements = _read_header(file)
            for element in elements:
                read = _read_binary if byte_order else _read_ascii
                points = read(file, byte_order, element)
                if element.name == "vertex":
                    return points
        except ValueError as error:
            raise CloudFileError(path, error) from error
    raise CloudFileError(path, "no vertices")


def _read_header(file: BinaryIO) -> tuple[str, list[_Element]]:
    if file.readline().strip() != b"ply":
        raise ValueError("not a PLY file")
    byte_order = None
    elements: list[_Element] = []
    for line in iter(file.readline, b""):
        words = line.decode("ascii", "replace").split()
        keyword = words[0] if words else "comment"
        try:
            if keyword == "end_header":
                break
            if keyword == "format":
                byte_order = _BYTE_ORDERS[words[1]]
            elif keyword == "element":
                if not words[2].isdigit():
                    raise ValueError
                elements.append(_Element(words[1], int(words[2])))
            elif keyword == "property":
                is_list = words[1] == "list"
                elements[-1].types[words[-1]] = None if is_list else _TYPES[words[1]]
            elif keyword not in ("comment", "obj_info"):
                raise ValueError
        except (KeyError, IndexError, ValueError):
            raise ValueError(f"bad line in the header: {' '.join(words)}") from None
    else:
        raise ValueError("the header has no end")
    if byte_order is None:
        raise ValueError("the header names no format")
    return byte_order, elements


def _read_binary(file: BinaryIO, byte_order: str, element: _Element) -> npt.NDArray[np.float64]:
    fields: dict[str, tuple[str, int]] = {}
    size = 0
    for name, code in element.types.items():
        if code is None:
            raise ValueError(f"lists of {element.name} before the end of the vertices")
        fields[name] = (byte_order + code, size)
        size += np.dtype(code).itemsize
    if element.name == "vertex":
        return read_records(file, fields, size, element.count)
    file.seek(element.count * size, os.SEEK_CUR)
    return np.empty((0, 3))


def _read_ascii(file: BinaryIO, _: str, element: _Element) -> npt.NDArray[np.float64]:
    lines = [line.decode("ascii", "replace") for line in islice(file, element.count)]
    if element.name != "vertex":
        return np.empty((0, 3))
    names = list(element.types)
    if not {"x", "y", "z"} <= set(names):
        raise ValueError("the vertices have no x, y and z")
    if len(lines) < element.count or not all(line.strip() for line in lines):
        raise ValueError(f"truncated: fewer than {element.count} points")
    if not lines:
        return np.empty((0, 3))
    return np.loadtxt(lines, np.float64, usecols=[names.index(axis) for axis in "xyz"], ndmin=2)


def write_ply(path: Path, points: npt.NDArray[np.float64]) -> None:
    """Writes (N, 3) points as binary float64, which read back as the same bits."""
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n"
    properties = "".join(f"property double {axis}\n" for axis in "xyz")
    path.write_bytes(f"{header}{properties}end_header\n".encode() + points.astype("<f8").tobytes())
