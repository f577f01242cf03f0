"""Workers that are processes of this machine."""

from __future__ import annotations

import contextlib
import multiprocessing
import signal
from multiprocessing import connection
from multiprocessing.connection import Connection

import gmcr

from .row import Row
from .schedule import Lost
from .work import Chunk, Work, process

# fork would copy the threads' locks but not the threads
_CONTEXT = multiprocessing.get_context("spawn")


class LocalBackend:
    """One process for each core; a process that dies is replaced.

    Parameters
    ----------
    work : Work
        Must be picklable.
    num_workers : int
        0: one for each core.
    """

    def __init__(self, work: Work, num_workers: int = 0) -> None:
        self._work = work
        self._num_workers = num_workers or gmcr.hardware_threads()
        self._idle: list[_Worker] = []
        self._busy: dict[Connection, tuple[_Worker, Chunk]] = {}
        self._has_started = False

    def num_free(self) -> int:
        return self._num_workers - len(self._busy)

    def num_running(self) -> int:
        return len(self._busy)

    def submit(self, chunk: Chunk) -> None:
        worker = self._idle.pop() if self._idle else _Worker(self._work)
        # a worker that has died meanwhile is seen by wait()
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            worker.pipe.send(chunk)
        self._busy[worker.pipe] = (worker, chunk)

    def wait(self, seconds: float) -> list[tuple[Chunk, list[Row] | Lost]]:
        ended: list[tuple[Chunk, list[Row] | Lost]] = []
        for pipe in connection.wait(list(self._busy), seconds):
            assert isinstance(pipe, Connection)
            worker, chunk = self._busy[pipe]
            try:
                rows = pipe.recv()
            except (EOFError, ConnectionResetError):
                how = worker.end()
                self._check_start(how)
                rows = Lost(f"the worker died ({how})")
            else:
                self._has_started = True
                if rows is None:  # it is up, and now takes the chunk
                    continue
                self._idle.append(worker)
            del self._busy[pipe]
            ended.append((chunk, rows))
        return ended

    def _check_start(self, how: str) -> None:
        """Where no worker could ever start, that is the program's fault, not that of the pairs."""
        if not self._has_started:
            raise RuntimeError(
                f"the first worker ended before it could work ({how}): can it import the main "
                'module, is the call under `if __name__ == "__main__":`?'
            )

    def close(self) -> None:
        for worker in [*self._idle, *(worker for worker, _ in self._busy.values())]:
            worker.end()
        self._idle.clear()
        self._busy.clear()


class _Worker:
    """A process and the pipe to it, whose end the process sees when this one is gone."""

    def __init__(self, work: Work) -> None:
        self.pipe, other_end = _CONTEXT.Pipe()
        self._process = _CONTEXT.Process(target=_serve, args=(other_end, work), daemon=True)
        self._process.start()
        other_end.close()

    def end(self) -> str:
        """Kills the process where it lives; says how it ended."""
        self.pipe.close()
        self._process.join(timeout=0.1)
        self._process.kill()
        self._process.join()
        code = self._process.exitcode
        return f"signal {-code}" if code is not None and code < 0 else f"exit code {code}"


def _serve(pipe: Connection, work: Work) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent, which ends this one
    with contextlib.suppress(EOFError, ConnectionResetError, BrokenPipeError):
        pipe.send(None)
        while True:
            pipe.send(process(pipe.recv(), work))
