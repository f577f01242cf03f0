"""The run: pairs in, rows out."""

from __future__ import annotations

import collections
import dataclasses
import math
import time
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import gmcr

from .local import LocalBackend
from .options import check_options
from .pairs import count_pairs, read_pairs
from .progress import Progress
from .registration import refuse_hopeless, register_pair
from .row import Row
from .schedule import Backend, schedule
from .sink import Sink
from .work import Register, Work


@dataclasses.dataclass(frozen=True)
class Summary:
    """What a run came to.

    Attributes
    ----------
    num_pairs, num_skipped : int
        Pairs in the list, and those of them that had a row before.
    statuses : dict of str to int
        Status -> pairs, of those of this run.
    seconds : float
        Wall time, without reading and checking the list.
    num_errors : int
        Error rows in the folder, those of earlier runs too; ``retry_errors`` works on them again.
    first_error : str
        ``id: reason`` of the first error row of this run; empty where it has none.
    """

    num_pairs: int
    num_skipped: int
    statuses: dict[str, int]
    seconds: float
    num_errors: int
    first_error: str


def run(
    pairs: str | Path,
    out: str | Path,
    *,
    options: Mapping[str, Any] | None = None,
    format: str = "parquet",
    address: str | None = None,
    num_workers: int = 0,
    chunk_pairs: int = 0,
    retries: int = 2,
    pair_timeout: float | None = None,
    part_seconds: float = 30,
    keep_inliers: bool = False,
    restart: bool = False,
    retry_errors: bool = False,
    register: Register = register_pair,
    show_progress: bool = False,
) -> Summary:
    """Registers many pairs; the same call again goes on where a run was ended.

    A pair that cannot be worked on becomes a row with the status 'error', also where it kills the
    worker. The rows are the same wherever they were made. Call it under
    ``if __name__ == "__main__":``, since local workers import the main module.

    Parameters
    ----------
    pairs : path
        As for ``read_pairs``.
    out : path
        Folder for the rows, see ``Row``: parts in no particular order, for ``read_results`` or any
        reader of data sets.
    options : mapping
        Names of ``OPTION_NAMES`` to values, for all pairs; a pair's own come first.
    format : str
        'parquet' or 'jsonl'.
    address : str, optional
        Of a Ray cluster, whose machines see the files under the same paths; None: this machine.
    num_workers : int
        Processes on this machine; 0: one for each core. Not with an address.
    chunk_pairs : int
        Pairs that a worker gets at a time; 0: about a second of work.
    retries : int
        How often a pair is started again after a worker died or a disk failed.
    pair_timeout : float, optional
        Seconds after which a pair becomes an error row; ``options['time_limit']`` is gentler: the
        best pose so far.
    part_seconds : float
        Rows are written when the first of them is so old: what a crash can cost.
    keep_inliers : bool
        Write the indices of the inliers.
    restart : bool
        Remove the rows of earlier runs first.
    retry_errors : bool
        Work again on the pairs whose row is an error.
    register : callable
        ``(pair, options) -> Row`` instead of ``register_pair``, from a module that workers can
        import.
    show_progress : bool
        Draw a bar on stderr.

    Returns
    -------
    Summary
        Numbers of pairs by status.

    Raises
    ------
    ValueError
        before any work: on a malformed list (``PairsError``), an option out of range, a list of
        which every pair lacks a noise bound, or a folder with rows of other options
        (``SinkError``).
    OSError
        where the list cannot be read or the rows cannot be written.
    ConnectionError
        where no Ray cluster answers at the address.
    RuntimeError
        where no worker can start.
    """
    options = dict(options or {})
    _check(options, num_workers, chunk_pairs, retries, pair_timeout)
    if address is not None and num_workers:
        raise ValueError(f"num_workers: {num_workers} with an address: a cluster has its own")
    num_pairs = count_pairs(pairs)
    if register is register_pair:
        refuse_hopeless(read_pairs(pairs), options)
    setup = {
        "version": gmcr.__version__,
        "register": f"{register.__module__}.{register.__qualname__}",
        "options": options,
        "keep_inliers": keep_inliers,
        "pair_timeout": pair_timeout,
    }
    work = Work(register, options, keep_inliers, pair_timeout, retries)
    with Sink(out, format, setup, restart=restart, part_seconds=part_seconds) as sink:
        if retry_errors:
            sink.drop_errors()
        done = sink.statuses()
        num_errors = sum(status == "error" for status in done.values())
        first_error = ""
        started = time.perf_counter()
        todo = (pair for pair in read_pairs(pairs) if pair.id not in done)
        statuses: collections.Counter[str] = collections.Counter()
        backend = _backend(work, address, num_workers)
        bar = Progress(num_pairs, len(done), show_progress)
        try:
            for rows in schedule(todo, backend, retries, chunk_pairs):
                sink.write(rows)
                bar.add(rows)
                statuses.update(row.status for row in rows)
                first_error = first_error or _first_error(rows)
        finally:
            backend.close()
            bar.close()
        sink.flush()
        seconds = time.perf_counter() - started
    return Summary(
        num_pairs=num_pairs,
        num_skipped=num_pairs - sum(statuses.values()),
        statuses=dict(statuses),
        seconds=seconds,
        num_errors=num_errors + statuses["error"],
        first_error=first_error,
    )


def _first_error(rows: Iterable[Row]) -> str:
    return next((f"{row.id}: {row.reason}" for row in rows if row.status == "error"), "")


def _backend(work: Work, address: str | None, num_workers: int) -> Backend:
    if address is None:
        return LocalBackend(work, num_workers)
    from .cluster import RayBackend

    return RayBackend(work, address)


def _check(
    options: Mapping[str, Any],
    num_workers: int,
    chunk_pairs: int,
    retries: int,
    pair_timeout: float | None,
) -> None:
    check_options(options)
    for name, value in (
        ("num_workers", num_workers),
        ("chunk_pairs", chunk_pairs),
        ("retries", retries),
    ):
        if value < 0:
            raise ValueError(f"{name}: {value} is negative")
    if pair_timeout is not None and not 0 < pair_timeout < math.inf:
        raise ValueError(f"pair_timeout: {pair_timeout} is not positive and finite")
