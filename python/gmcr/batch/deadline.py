"""A time limit on Python and native code that lets signals through."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from types import FrameType


@contextlib.contextmanager
def deadline(seconds: float | None) -> Iterator[None]:
    """Raises ``TimeoutError`` in the block when its time is up; only in the main thread.

    Parameters
    ----------
    seconds : float, optional
        Wall time, > 0; None for no limit.
    """
    if seconds is None:
        yield
        return

    def end(signal_number: int, frame: FrameType | None) -> None:
        raise TimeoutError(f"the pair took longer than {seconds:g} s")

    previous = signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)
