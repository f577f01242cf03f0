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
    def read_ids(self, path: Path) -> Iterable[str]: ...


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

    def read_ids(self, path: Path) -> Iterable[str]:
        return (row["id"] for row in self.read(path))


class _Parquet:
    """Columns with the types below; needs pyarrow."""

    suffix = ".parquet"

    def write(self, path: Path, rows: list[Fields]) -> None:
        import pyarrow
        import pyarrow.parquet

        table = pyarrow.Table.from_pylist(rows, schema=_schema())
        pyarrow.parquet.write_table(table, path, compression="zstd")

    def read(self, path: Path) -> list[Fields]:
        import pyarrow.parquet

        rows: list[Fields] = pyarrow.parquet.ParquetFile(path).read().to_pylist()
        return rows

    def read_ids(self, path: Path) -> Iterable[str]:
        import pyarrow.parquet

        ids: list[str] = pyarrow.parquet.ParquetFile(path).read(["id"])["id"].to_pylist()
        return ids


def _schema() -> Any:
    import pyarrow as pa

    return pa.schema(
        [
            pa.field("id", pa.string(), nullable=False),
            pa.field("status", pa.string(), nullable=False),
            ("reason", pa.string()),
            ("target_from_source", pa.list_(pa.float64(), 16)),
            ("scale", pa.float64()),
            ("num_correspondences", pa.int64()),
            ("num_inliers", pa.int64()),
            ("max_inliers", pa.int64()),
            ("certified", pa.bool_()),
            ("evidence", pa.float64()),
            ("noise_bound", pa.float64()),
            ("verdict", pa.string()),
            ("verdict_reason", pa.string()),
            ("fitness", pa.float64()),
            ("limits_hit", pa.list_(pa.string())),
            ("inliers", pa.list_(pa.int64())),
            ("seconds", pa.float64()),
            ("read_seconds", pa.float64()),
            ("attempts", pa.int64()),
        ]
    )


def _finite(value: Any) -> Any:
    if isinstance(value, list):
        return [_finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


FORMATS: dict[str, Format] = {"parquet": _Parquet(), "jsonl": _Jsonl()}
