"""Files of correspondences, by the rules of the tool."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import numpy.typing as npt

_POINT_NAMES = (
    ("ax", "ay", "az", "bx", "by", "bz"),
    ("sx", "sy", "sz", "tx", "ty", "tz"),
    ("source_x", "source_y", "source_z", "target_x", "target_y", "target_z"),
    ("src_x", "src_y", "src_z", "dst_x", "dst_y", "dst_z"),
)
_BOUND_NAMES = ("noise_bound", "bound", "beta")
_SEPARATORS = re.compile(r"[,;\s]+")

Floats = npt.NDArray[np.float64]


def read_matches(path: str | Path) -> tuple[Floats, Floats, Floats | None]:
    """Correspondences of a CSV or .npy file.

    Parameters
    ----------
    path : path
        (N, 6) numbers ax,ay,az,bx,by,bz, or (N, 7) with a noise bound each; metres. A CSV may have
        a header, which then says which columns these are.

    Returns
    -------
    source, target : ndarray, shape (N, 3)
        Metres.
    noise_bounds : ndarray, shape (N,), or None
        Metres, where the file has them.

    Raises
    ------
    OSError
        where the file cannot be read.
    ValueError
        where it is malformed.
    """
    path = Path(path)
    if path.suffix == ".npy":
        table = np.load(path, allow_pickle=False)
        columns = _choose_columns([], table.shape[1] if table.ndim == 2 else 0)
    elif path.suffix == ".csv":
        names, table = _read_csv(path)
        columns = _choose_columns(names, table.shape[1])
    else:
        raise ValueError(f"{path}: expected a file of .csv, .npy")
    table = np.ascontiguousarray(table, dtype=np.float64)[:, columns]
    source, target = table[:, :3].copy(), table[:, 3:6].copy()
    return source, target, table[:, 6].copy() if len(columns) == 7 else None


def _read_csv(path: Path) -> tuple[list[str], Floats]:
    with path.open() as file:
        first_line = file.readline().strip()
    cells = _SEPARATORS.split(first_line)
    has_header = not _is_number(cells[0])
    delimiter = "," if "," in first_line else None
    table = np.loadtxt(path, delimiter=delimiter, skiprows=int(has_header), ndmin=2)
    return (cells if has_header else []), table


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _choose_columns(names: list[str], num_columns: int) -> list[int]:
    bound = next((names.index(name) for name in _BOUND_NAMES if name in names), None)
    if not names and num_columns == 7:
        bound = 6
    for known in _POINT_NAMES:
        if set(known) <= set(names):
            columns = [names.index(name) for name in known]
            break
    else:
        columns = [column for column in range(num_columns) if column != bound]
        if len(columns) != 6:
            raise ValueError(
                f"{num_columns} columns, expected 6 (ax,ay,az,bx,by,bz) or 7 (and noise_bound), or "
                "a header that names these"
            )
    return columns if bound is None else [*columns, bound]
