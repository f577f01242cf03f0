"""What a worker does with a chunk of pairs. Whatever happens, every pair comes to a row."""

from __future__ import annotations

import dataclasses
import errno
import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from .deadline import deadline
from .pairs import Pair
from .row import Row, error_row

#: Faults of networks and shared disks, which may have gone a moment later.
_TRANSIENT = {
    errno.EAGAIN,
    errno.EBUSY,
    errno.ECONNABORTED,
    errno.ECONNRESET,
    errno.EIO,
    errno.ENOTCONN,
    errno.ESTALE,
    errno.ETIMEDOUT,
}
_FIRST_PAUSE = 0.1  # seconds; doubles with every attempt

Register = Callable[[Pair, Mapping[str, Any]], Row]


@dataclasses.dataclass(frozen=True)
class Work:
    """How pairs become rows; what the workers need to know."""

    register: Register
    options: Mapping[str, Any]
    keep_inliers: bool = False
    pair_timeout: float | None = None
    retries: int = 2


@dataclasses.dataclass(frozen=True)
class Chunk:
    """Pairs that one worker takes at a time."""

    pairs: Sequence[Pair]
    #: How often they were started, this time included.
    attempt: int = 1
    #: How often a worker died with the pair while it was alone in its chunk.
    deaths: int = 0


def process(chunk: Chunk, work: Work) -> list[Row]:
    """Rows of the pairs of a chunk, in their order."""
    return [_process_pair(pair, work, chunk.attempt) for pair in chunk.pairs]


def _process_pair(pair: Pair, work: Work, attempt: int) -> Row:
    started, cpu_started = time.perf_counter(), time.process_time()
    try:
        with deadline(work.pair_timeout):
            row = work.register(pair, work.options)
        row.id, row.attempts = pair.id, attempt
    except Exception as error:
        if _is_transient(error) and attempt <= work.retries:
            time.sleep(_FIRST_PAUSE * 2 ** (attempt - 1))
            return _process_pair(pair, work, attempt + 1)
        row = error_row(pair.id, f"{type(error).__name__}: {error}", attempt)
    if not work.keep_inliers:
        row.inliers = None
    row.seconds = time.perf_counter() - started
    row.cpu_seconds = time.process_time() - cpu_started
    return row


def _is_transient(error: Exception) -> bool:
    return isinstance(error, OSError) and error.errno in _TRANSIENT
