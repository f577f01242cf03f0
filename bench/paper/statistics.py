"""Summaries of records in which a run without an answer counts as a failure, never as a gap."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from reports.records import nested, wilson


def quantile(values: Sequence[float], share: float) -> float:
    """Quantile by linear interpolation; infinity counts as a value, nan without values."""
    if not values:
        return math.nan
    ordered = sorted(values)
    position = share * (len(ordered) - 1)
    below = math.floor(position)
    rest = position - below
    if rest == 0:
        return ordered[below]
    return (
        math.inf
        if math.isinf(ordered[below + 1])
        else (ordered[below] + rest * (ordered[below + 1] - ordered[below]))
    )


@dataclass(frozen=True)
class Quartiles:
    low: float
    median: float
    high: float


def quartiles(values: Sequence[float]) -> Quartiles:
    return Quartiles(*(quantile(values, share) for share in (0.25, 0.5, 0.75)))


@dataclass(frozen=True)
class Rate:
    """Successes of runs with their Wilson interval at 95 %; shares in [0, 1]."""

    successes: int
    total: int
    low: float
    high: float

    @property
    def share(self) -> float:
        return self.successes / self.total


def success_rate(records: Sequence[dict]) -> Rate:
    """Rate over all runs: one that timed out or crashed is no success.

    Runs of one real pair are no independent trials: the interval is that of as many trials as there
    are pairs.
    """
    successes, total = sum(bool(record["success"]) for record in records), len(records)
    num_pairs = len({(record["set"], record["pair"]) for record in records if "pair" in record})
    trials = num_pairs or total
    return Rate(successes, total, *wilson(successes * trials / total, trials))


def errors(records: Sequence[dict], name: str) -> list[float]:
    """An error of each run, infinite where it has no pose."""
    values = (nested(record, "errors", name) for record in records)
    return [math.inf if value is None else value for value in values]


def times_ms(records: Sequence[dict]) -> list[float]:
    """Wall time of each run, infinite where it was ended or crashed."""
    return [math.inf if record["wall_ms"] is None else record["wall_ms"] for record in records]


def mean_and_deviation(values: Sequence[float]) -> tuple[float, float]:
    """Over the finite values; nan without any."""
    finite = [value for value in values if math.isfinite(value)]
    if not finite:
        return math.nan, math.nan
    mean = sum(finite) / len(finite)
    return mean, math.sqrt(sum((value - mean) ** 2 for value in finite) / len(finite))
