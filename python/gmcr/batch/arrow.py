"""Parquet files; the only module that needs pyarrow."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pyarrow as pa  # type: ignore[import-not-found,import-untyped,unused-ignore]
import pyarrow.parquet  # type: ignore[import-not-found,import-untyped,unused-ignore]

Fields = dict[str, Any]

_ROW_SCHEMA = pa.schema(
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
        ("cpu_seconds", pa.float64()),
        ("read_seconds", pa.float64()),
        ("attempts", pa.int64()),
    ]
)


def stream(path: Path) -> Iterator[Fields]:
    """Rows of a file of any columns, a batch in memory at a time."""
    for batch in pyarrow.parquet.ParquetFile(path).iter_batches():
        yield from batch.to_pylist()


def read_statuses(path: Path) -> Iterator[tuple[str, str]]:
    """The columns ``id`` and ``status`` of a part of the results."""
    table = pyarrow.parquet.ParquetFile(path).read(["id", "status"])
    yield from zip(table["id"].to_pylist(), table["status"].to_pylist(), strict=True)


def write_rows(path: Path, rows: list[Fields]) -> None:
    """A part of the results: the fields of ``Row``."""
    table = pa.Table.from_pylist(rows, schema=_ROW_SCHEMA)
    pyarrow.parquet.write_table(table, path, compression="zstd")
