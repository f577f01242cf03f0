"""Which worker gets which pairs when, and what becomes of the pairs of a worker that died."""

from __future__ import annotations

import collections
import itertools
from collections.abc import Iterable, Iterator
from typing import Protocol

from .pairs import Pair
from .row import Row, error_row
from .work import Chunk

_CHUNK_SECONDS = 1.0  # of an automatic chunk: long against the cost of sending it
_MAX_CHUNK_PAIRS = 512
_WAIT_SECONDS = 1.0


class Lost(str):
    """Why a chunk has no rows: its worker died, or its machine."""


class Backend(Protocol):
    """Workers: processes of this machine, or a cluster."""

    def num_free(self) -> int:
        """How many chunks can be submitted now."""

    def num_running(self) -> int:
        """How many are on their way."""

    def submit(self, chunk: Chunk) -> None:
        """Hands a chunk to a worker."""

    def wait(self, seconds: float) -> list[tuple[Chunk, list[Row] | Lost]]:
        """Chunks that have ended; waits for one, but not longer than this."""

    def close(self) -> None:
        """Ends all workers at once."""


def schedule(
    pairs: Iterable[Pair], backend: Backend, retries: int, chunk_pairs: int = 0
) -> Iterator[list[Row]]:
    """Rows of all pairs, as they come: each pair once.

    The pairs are read only as fast as they are worked on. The pairs of a chunk whose worker died
    are started again one by one, so that the one which kills workers is told from the others. A
    pair whose worker dies more than ``retries`` times while it is alone is given up as an error
    row.

    Parameters
    ----------
    pairs : iterable of Pair
        Consumed lazily.
    backend : Backend
        Who works.
    retries : int
        How often a pair that was alone with a worker that died is started again.
    chunk_pairs : int
        Pairs that a worker gets at a time; 0: about a second of work, by the pairs so far.

    Yields
    ------
    list of Row
        What ended within about a second; may be empty.
    """
    queue = _Queue(iter(pairs), chunk_pairs)
    while True:
        while backend.num_free() > 0 and (chunk := queue.next_chunk()) is not None:
            backend.submit(chunk)
        if backend.num_running() == 0:
            return
        rows: list[Row] = []
        for chunk, outcome in backend.wait(_WAIT_SECONDS):
            if isinstance(outcome, Lost):
                rows += queue.take_back(chunk, outcome, retries)
            else:
                queue.learn(outcome)
                rows += outcome
        yield rows


class _Queue:
    """Pairs to be worked on: those of lost chunks first."""

    def __init__(self, pairs: Iterator[Pair], chunk_pairs: int) -> None:
        self._pairs = pairs
        self._lost: collections.deque[Chunk] = collections.deque()
        self._is_automatic = chunk_pairs == 0
        self._chunk_pairs = chunk_pairs or 1

    def next_chunk(self) -> Chunk | None:
        if self._lost:
            return self._lost.popleft()
        pairs = tuple(itertools.islice(self._pairs, self._chunk_pairs))
        return Chunk(pairs) if pairs else None

    def take_back(self, chunk: Chunk, reason: str, retries: int) -> list[Row]:
        """Queues the pairs of a lost chunk again, or returns the error row of a pair given up."""
        deaths = chunk.deaths + (len(chunk.pairs) == 1)
        if deaths > retries:
            return [error_row(chunk.pairs[0].id, reason, chunk.attempt)]
        self._lost.extend(Chunk((pair,), chunk.attempt + 1, deaths) for pair in chunk.pairs)
        return []

    def learn(self, rows: list[Row]) -> None:
        """Adapts the size of the chunks to the time that pairs take."""
        if not self._is_automatic:
            return
        seconds = sum(row.seconds or 0 for row in rows) / len(rows)
        wanted = int(_CHUNK_SECONDS / max(seconds, _CHUNK_SECONDS / _MAX_CHUNK_PAIRS))
        # at most double, so that one quick pair does not make a chunk of hundreds of slow ones
        self._chunk_pairs = max(1, min(wanted, 2 * self._chunk_pairs))
