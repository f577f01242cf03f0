"""The list of pairs, read as a stream."""

from __future__ import annotations

import csv
import dataclasses
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from .options import FRONTEND_NAMES, OPTION_NAMES, advice_on, parse_value

_FILE_NAMES = ("source", "target", "matches")
_FILE_CHOICES = ({"matches"}, {"source", "target"})
_KNOWN_NAMES = OPTION_NAMES | {"id", *_FILE_NAMES}


@dataclasses.dataclass(frozen=True)
class Pair:
    """Two clouds, or a file of matches, and options of its own.

    Attributes
    ----------
    id : str
        Its name in the results.
    source, target : str, optional
        Paths of the two clouds.
    matches : str, optional
        Path of the matches, in place of the clouds.
    options : dict of str to value
        Those of this pair alone, by names of ``gmcr.batch.OPTION_NAMES``.
    """

    id: str
    source: str | None = None
    target: str | None = None
    matches: str | None = None
    options: dict[str, Any] = dataclasses.field(default_factory=dict)


class PairsError(ValueError):
    """The list of pairs is malformed; says in which line."""


def read_pairs(path: str | Path) -> Iterator[Pair]:
    """Pairs of a CSV, JSONL or Parquet file, one at a time.

    Parameters
    ----------
    path : path
        Columns ``id`` and either ``matches`` or ``source`` and ``target``; any other is the name of
        an option (``gmcr.batch.OPTION_NAMES``), empty where the pair has none of its own. Relative
        paths are relative to the folder of the file.

    Yields
    ------
    Pair
        In the order of the file.

    Raises
    ------
    PairsError
        at the first malformed row, with its line.
    """
    path = Path(path)
    folder = path.resolve().parent
    for line, fields in _read_rows(path):
        try:
            yield _to_pair(fields, folder)
        except ValueError as error:
            raise PairsError(f"{path}:{line}: {error}") from None


def count_pairs(path: str | Path) -> int:
    """Number of pairs, after a check of the whole list.

    Raises
    ------
    PairsError
        on a malformed row or an id that occurs twice.

    Notes
    -----
    Holds all ids in memory, about 150 bytes a pair.
    """
    seen: dict[str, int] = {}
    for number, pair in enumerate(read_pairs(path), start=1):
        first = seen.setdefault(pair.id, number)
        if first != number:
            raise PairsError(f"{path}: pair {number} has the id {pair.id!r} of pair {first}")
    return len(seen)


def _read_rows(path: Path) -> Iterator[tuple[int, dict[str, Any]]]:
    readers = {".csv": _read_csv, ".jsonl": _read_jsonl, ".parquet": _read_parquet}
    reader = readers.get(path.suffix)
    if reader is None:
        raise PairsError(f"{path}: expected a file of {', '.join(readers)}")
    return reader(path)


def _read_csv(path: Path) -> Iterator[tuple[int, dict[str, Any]]]:
    with path.open(newline="") as file:
        reader = csv.reader(file)
        header = [name.strip() for name in next(reader, [])]
        for cells in reader:
            if not cells:
                continue
            if len(cells) != len(header):
                raise PairsError(
                    f"{path}:{reader.line_num}: {len(cells)} cells, the header has {len(header)}"
                )
            texts = zip(header, (cell.strip() for cell in cells), strict=True)
            fields = {n: parse_value(t) if n in OPTION_NAMES else t for n, t in texts}
            yield reader.line_num, fields


def _read_jsonl(path: Path) -> Iterator[tuple[int, dict[str, Any]]]:
    with path.open() as file:
        for line, text in enumerate(file, start=1):
            if not text.strip():
                continue
            try:
                fields = json.loads(text)
            except json.JSONDecodeError as error:
                raise PairsError(f"{path}:{line}: no JSON: {error}") from None
            if not isinstance(fields, dict):
                raise PairsError(f"{path}:{line}: expected a JSON object")
            yield line, fields


def _read_parquet(path: Path) -> Iterator[tuple[int, dict[str, Any]]]:
    from . import arrow

    return enumerate(arrow.stream(path), start=1)


def _to_pair(fields: dict[str, Any], folder: Path) -> Pair:
    given = {name: value for name, value in fields.items() if value is not None and value != ""}
    if not fields.keys() <= _KNOWN_NAMES:
        name = min(fields.keys() - _KNOWN_NAMES)
        raise ValueError(f"unknown column {name!r}{advice_on(name, _KNOWN_NAMES)}")
    if "id" not in given:
        raise ValueError("id: is missing")
    files = {name: given.pop(name) for name in _FILE_NAMES if name in given}
    if files.keys() not in _FILE_CHOICES:
        raise ValueError(f"expected matches, or source and target, but got {sorted(files)}")
    unused = FRONTEND_NAMES & given.keys() if "matches" in files else ()
    if unused:
        raise ValueError(f"{min(unused)}: is for clouds, not for matches")
    return Pair(
        id=str(given.pop("id")),
        # five times as fast as Path, in the loop that feeds all workers
        **{name: os.path.join(folder, str(file)) for name, file in files.items()},  # noqa: PTH118
        options=given,
    )
