"""The two formats of a part of the results."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Protocol

Fields = dict[str, Any]


class Format(Protocol):
    suffix: str

    def write(self, path: Path, rows: list[Fields]) -> None: ...
    def read(self, path: Path) -> list[Fields]: ...
    def read_statuses(self, path: Path) -> Iterable[tuple[str, str]]: ...


class _Jsonl:
    """One JSON object a line; numbers that are not finite are null."""

    suffix = ".jsonl"

    def write(self, path: Path, rows: list[Fields]) -> None:
        with path.open("w") as file:
            for row in rows:
                file.write(json.dumps({k: _finite(v) for k, v in row.items()}) + "\n")

    def read(self, path: Path) -> list[Fields]:
        with path.open() as file:
            return [json.loads(line) for line in file]

    def read_statuses(self, path: Path) -> Iterable[tuple[str, str]]:
        return ((row["id"], row["status"]) for row in self.read(path))


class _Parquet:
    """Columns with the types of ``arrow``, which is imported where it is needed."""

    suffix = ".parquet"

    def write(self, path: Path, rows: list[Fields]) -> None:
        from . import arrow

        arrow.write_rows(path, rows)

    def read(self, path: Path) -> list[Fields]:
        from . import arrow

        return list(arrow.stream(path))

    def read_statuses(self, path: Path) -> Iterable[tuple[str, str]]:
        from . import arrow

        return arrow.read_statuses(path)


def _finite(value: Any) -> Any:
    if isinstance(value, list):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


FORMATS: dict[str, Format] = {"parquet": _Parquet(), "jsonl": _Jsonl()}
