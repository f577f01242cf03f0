"""Workers that are tasks of a Ray cluster."""

from __future__ import annotations

import socket
import time
from typing import Any

import ray  # type: ignore[import-not-found,unused-ignore]
import ray.exceptions  # type: ignore[import-not-found,unused-ignore]

from .row import Row
from .schedule import Lost
from .work import Chunk, Work, process

_CHUNKS_PER_CORE = 2  # one that runs, one that waits
_CONNECT_SECONDS = 10.0  # until a machine that does not answer is one that is not there
_COUNT_SECONDS = 5.0  # between looks at the size of the cluster, which may grow and shrink


class RayBackend:
    """One task for each chunk, on one core each.

    Ray places the tasks and notices workers and machines that die. It does not start a task again
    by itself: ``schedule`` does, which then tells the pair that kills workers from the others.

    Parameters
    ----------
    work : Work
        Picklable, by modules that every machine can import.
    address : str
        Of the cluster: ``auto``, ``HOST:PORT`` or ``ray://HOST:PORT``. A connection that exists
        already (``ray.init``) is used as it is.

    Raises
    ------
    ConnectionError
        No cluster answers there, or it refuses this client.
    """

    def __init__(self, work: Work, address: str) -> None:
        self._is_ours = not ray.is_initialized()
        if self._is_ours:
            _connect(address)
        self._process = ray.remote(num_cpus=1, max_retries=0)(process)
        self._work = ray.put(work)
        self._running: dict[Any, Chunk] = {}
        self._capacity = 0
        self._counted = -_COUNT_SECONDS

    def num_free(self) -> int:
        now = time.monotonic()
        if now - self._counted >= _COUNT_SECONDS:
            resources = ray.cluster_resources()  # type: ignore[no-untyped-call,unused-ignore]
            num_cores = int(resources.get("CPU", 0))
            self._capacity = _CHUNKS_PER_CORE * max(1, num_cores)
            self._counted = now
        return self._capacity - len(self._running)

    def num_running(self) -> int:
        return len(self._running)

    def submit(self, chunk: Chunk) -> None:
        self._running[self._process.remote(chunk, self._work)] = chunk

    def wait(self, seconds: float) -> list[tuple[Chunk, list[Row] | Lost]]:
        tasks = list(self._running)
        ready, _ = ray.wait(tasks, num_returns=1, timeout=seconds)
        if ready:
            ready, _ = ray.wait(tasks, num_returns=len(tasks), timeout=0)
        return [(self._running.pop(task), _outcome(task)) for task in ready]

    def close(self) -> None:
        for task in self._running:
            ray.cancel(task, force=True)
        self._running.clear()
        if self._is_ours:
            ray.shutdown()


def _connect(address: str) -> None:
    hint = ""
    host, colon, port = address.removeprefix("ray://").rpartition(":")
    if colon and port.isdigit():
        try:  # Ray itself waits for minutes where nothing listens
            socket.create_connection((host, int(port)), _CONNECT_SECONDS).close()
        except OSError as error:
            raise ConnectionError(f"Ray cluster {address}: {error.strerror or error}") from error
        hint = " (where the cluster wants a token: set RAY_AUTH_MODE=token)"
    try:
        ray.init(address=address, log_to_driver=False)
    except (ConnectionError, ray.exceptions.RayError, RuntimeError) as error:
        raise ConnectionError(f"Ray cluster {address}: {error}{hint}") from error


def _outcome(task: Any) -> list[Row] | Lost:
    try:
        rows: list[Row] = ray.get(task)
        return rows
    except ray.exceptions.RayTaskError:
        raise  # of the program, not of the cluster: process() lets no exception of a pair through
    except ray.exceptions.RayError as error:
        return Lost(f"the worker died ({type(error).__name__})")
