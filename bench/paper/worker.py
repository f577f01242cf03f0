"""A process of its own for each method: one that hangs or crashes is killed and started anew.

The time of a solve is measured inside that process, around `Method.solve` alone.
"""

from __future__ import annotations

import multiprocessing
import time
from dataclasses import dataclass, field
from multiprocessing.connection import Connection

from paper.methods import METHODS
from paper.methods.registry import Method, Outcome
from paper.problem import Problem, easy_problem

START_LIMIT = 120.0  # seconds to import a method's modules and to warm up
SLACK = 0.5  # seconds beyond the limit for preparation and transfer
REPEAT_BELOW = 0.05  # seconds; shorter solves are repeated for their median
MAX_SOLVES = 3


@dataclass
class Timed:
    """An outcome with the seconds of each of its solves."""

    outcome: Outcome
    seconds: list[float] = field(default_factory=list)


def time_solves(method: Method, problem: Problem, time_limit: float) -> Timed:
    """Solve a problem, several times where that is quick. The outcome is that of the last solve."""
    method.prepare(problem, time_limit)
    seconds: list[float] = []
    while len(seconds) < MAX_SOLVES and sum(seconds) < REPEAT_BELOW:
        start = time.perf_counter()
        result = method.solve()
        seconds.append(time.perf_counter() - start)
    if seconds[0] > time_limit:
        return Timed(Outcome("time_limit", reason=f"more than {time_limit:g} s"), seconds)
    return Timed(method.outcome(result), seconds)


def serve(connection: Connection, name: str) -> None:
    """Body of the process: says whether the method is available, then solves what it is sent."""
    method_type = METHODS[name]
    reason = method_type.unavailable_reason()
    if reason is None:
        method = method_type()
        for _ in range(2):  # thread pools and lazy imports are not what is timed
            time_solves(method, easy_problem(), START_LIMIT)
    connection.send(reason)
    while reason is None:
        try:
            problem, time_limit = connection.recv()
        except EOFError:
            return
        try:
            timed = time_solves(method, problem, time_limit)
        except Exception as error:  # a rival may raise anything; the record says what
            timed = Timed(Outcome("error", reason=f"{type(error).__name__}: {error}"))
        connection.send(timed)


class Worker:
    """Runs one method under a time limit."""

    def __init__(self, name: str):
        self.name = name
        self._process: multiprocessing.process.BaseProcess | None = None
        self._connection: Connection | None = None

    def unavailable_reason(self) -> str | None:
        """Why the method cannot run, None where it can; starts the process where there is none."""
        if self._process is not None:
            return None
        context = multiprocessing.get_context("spawn")
        self._connection, child = context.Pipe()
        self._process = context.Process(target=serve, args=(child, self.name), daemon=True)
        self._process.start()
        child.close()
        try:
            if not self._connection.poll(START_LIMIT):
                reason = f"did not start within {START_LIMIT:g} s"
            else:
                reason = self._connection.recv()
        except EOFError:
            reason = "crashed at its start"
        if reason is not None:
            self.stop()
        return reason

    def solve(self, problem: Problem, time_limit: float) -> Timed:
        """Outcome and times; "time_limit" or "crashed" where the process had to be ended."""
        reason = self.unavailable_reason()
        if reason is not None:
            return Timed(Outcome("error", reason=reason))
        assert self._connection is not None
        try:
            self._connection.send((problem, time_limit))
            if self._connection.poll(time_limit * 1.1 + SLACK):
                return self._connection.recv()
        except (EOFError, BrokenPipeError, ConnectionResetError):
            self.stop()
            return Timed(Outcome("crashed", reason="the process of the method ended"))
        self.stop()
        return Timed(Outcome("time_limit", reason=f"more than {time_limit:g} s"))

    def stop(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join()
            self._connection.close()
        self._process = self._connection = None
