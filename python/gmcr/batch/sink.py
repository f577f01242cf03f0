"""The folder of the results: parts that appear whole or not at all, and are never changed."""

from __future__ import annotations

import fcntl
import json
import os
import time
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

from .parts import FORMATS
from .row import Row

_SETUP_NAME = "_run.json"  # a leading _ hides it from readers of the data set
_LOCK_NAME = "_lock"


class SinkError(ValueError):
    """The folder holds the results of another run, or another run writes to it."""


class Sink:
    """Writes rows, and knows which pairs have one.

    A part is written aside, brought to disk and then renamed, so that the parts are the record of
    what is done: no other can disagree with them, whenever the process ends.

    Parameters
    ----------
    folder : path
        Made where it does not exist.
    format : str
        'parquet' or 'jsonl'.
    setup : dict
        What the rows depend on, for JSON. A folder with rows of another setup is refused.
    restart : bool
        Remove what is there instead.
    part_rows, part_seconds : int, float
        A part is written when it has so many rows, or the first of them is so old.
    """

    def __init__(
        self,
        folder: str | Path,
        format: str,
        setup: dict[str, Any],
        *,
        restart: bool = False,
        part_rows: int = 10_000,
        part_seconds: float = 30,
    ) -> None:
        if format not in FORMATS:
            raise ValueError(f"format: {format!r} is none of {', '.join(FORMATS)}")
        self._folder = Path(folder)
        self._format = FORMATS[format]
        self._part_rows = part_rows
        self._part_seconds = part_seconds
        self._rows: list[Row] = []
        self._first_time = 0.0
        self._folder.mkdir(parents=True, exist_ok=True)
        self._lock = (self._folder / _LOCK_NAME).open("w")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._lock.close()
            raise SinkError(f"{folder}: another run writes to it") from None
        try:
            self._prepare(json.loads(json.dumps({"format": format, **setup})), restart)
        except BaseException:
            self._lock.close()
            raise
        self._next_part = 1 + max((_number_of(part) for part in self._parts()), default=-1)

    def __enter__(self) -> Sink:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            self.flush()
        finally:
            self._lock.close()

    def statuses(self) -> dict[str, str]:
        """Id -> status of the pairs that have a row on disk."""
        parts = self._parts()
        return {id: status for part in parts for id, status in self._format.read_statuses(part)}

    def drop_errors(self) -> int:
        """Removes the error rows, so that their pairs are worked on again; how many."""
        num_dropped = 0
        for part in self._parts():
            rows = self._format.read(part)
            kept = [row for row in rows if row["status"] != "error"]
            if len(kept) < len(rows):
                self._write_part(part, kept)
                num_dropped += len(rows) - len(kept)
        return num_dropped

    def write(self, rows: Sequence[Row]) -> None:
        """Takes rows, none or more; a part is written when it is due."""
        if rows and not self._rows:
            self._first_time = time.monotonic()
        self._rows += rows
        age = time.monotonic() - self._first_time
        if len(self._rows) >= self._part_rows or (self._rows and age >= self._part_seconds):
            self.flush()

    def flush(self) -> None:
        """Writes what there is."""
        if not self._rows:
            return
        path = self._folder / f"part-{self._next_part:06d}{self._format.suffix}"
        self._write_part(path, [vars(row) for row in self._rows])
        self._next_part += 1
        self._rows = []

    def _write_part(self, path: Path, rows: list[dict[str, Any]]) -> None:
        self._replace(path, lambda temporary: self._format.write(temporary, rows))

    def _prepare(self, setup: dict[str, Any], restart: bool) -> None:
        for temporary in self._folder.glob(".*.tmp"):
            temporary.unlink()
        path = self._folder / _SETUP_NAME
        if restart:
            for part in self._parts(any_format=True):
                part.unlink()
        elif path.exists():
            _check_same(self._folder, json.loads(path.read_text()), setup)
            return
        text = json.dumps(setup, indent=2, sort_keys=True) + "\n"
        self._replace(path, lambda temporary: temporary.write_text(text))

    def _replace(self, path: Path, write: Any) -> None:
        temporary = path.with_name(f".{path.name}.tmp")
        write(temporary)
        _sync(temporary)
        temporary.replace(path)
        _sync(self._folder)

    def _parts(self, any_format: bool = False) -> Iterable[Path]:
        suffixes = [f.suffix for f in FORMATS.values()] if any_format else [self._format.suffix]
        return sorted(part for s in suffixes for part in self._folder.glob(f"part-*{s}"))


def read_results(folder: str | Path) -> Iterator[Row]:
    """Rows of a folder of results, part by part.

    Parameters
    ----------
    folder : path
        As given to ``run``.

    Yields
    ------
    Row
        In the order in which they were written, which depends on the workers.
    """
    for part in sorted(Path(folder).glob("part-*")):
        for format in FORMATS.values():
            if part.suffix == format.suffix:
                yield from (Row(**fields) for fields in format.read(part))


def _number_of(part: Path) -> int:
    return int(part.stem.split("-")[1])


def _sync(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _check_same(folder: Path, before: dict[str, Any], now: dict[str, Any]) -> None:
    different = sorted(k for k in before.keys() | now.keys() if before.get(k) != now.get(k))
    if different:
        changes = "; ".join(f"{k} was {before.get(k)!r}, is {now.get(k)!r}" for k in different)
        raise SinkError(f"{folder}: holds results of another run ({changes}); restart removes them")
