"""A line that says how far the run is, how fast, and how long it will take."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any

from .row import Row

_LOG_SECONDS = 30.0  # between lines where there is no terminal to draw on


class Progress:
    """Bar on stderr with rate and remaining time; lines now and then where that is a file.

    Parameters
    ----------
    num_pairs, num_done : int
        Of the list, and of them those that have a row already.
    is_shown : bool
        False: nothing is printed, and tqdm is not needed.
    """

    def __init__(self, num_pairs: int, num_done: int, is_shown: bool) -> None:
        self._num_errors = 0
        self._bar = _draw_bar(num_pairs, num_done) if is_shown else None

    def add(self, rows: Sequence[Row]) -> None:
        """Counts rows that have come in."""
        if self._bar is None:
            return
        num_errors = sum(row.status == "error" for row in rows)
        if num_errors:
            self._num_errors += num_errors
            self._bar.set_postfix(errors=self._num_errors, refresh=False)
        self._bar.update(len(rows))

    def close(self) -> None:
        """Draws the last state and moves to the next line."""
        if self._bar is not None:
            self._bar.close()


def _draw_bar(num_pairs: int, num_done: int) -> Any:
    from tqdm import tqdm  # type: ignore[import-not-found,import-untyped,unused-ignore]

    return tqdm(
        total=num_pairs,
        initial=num_done,
        unit="pair",
        mininterval=0.2 if sys.stderr.isatty() else _LOG_SECONDS,
        dynamic_ncols=True,
    )
