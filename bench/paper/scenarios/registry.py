"""What an experiment is, and the list of all of them, to which each file adds its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from paper.methods import in_order
from paper.problem import Problem


@dataclass(frozen=True)
class Case:
    """One problem of an experiment, made when it is needed."""

    fields: dict  # what tells it from the others of the experiment; part of the record
    make: Callable[[], Problem]
    criterion: dict[str, float]  # largest errors of a success, by the names of `errors_of`
    methods: tuple[str, ...]


@dataclass(frozen=True)
class Experiment:
    name: str
    title: str
    protocol: str  # for the reader: what is drawn and judged, and where the paper is silent
    cases: Callable[[bool], Iterator[Case]]  # argument: whether a quick run is asked for


EXPERIMENTS: dict[str, Experiment] = {}

UNKNOWN_SCALE = in_order(is_scale_known=False)
KNOWN_SCALE = in_order(is_scale_known=True)


def experiment(name: str, title: str, protocol: str) -> Callable:
    """Decorator that adds a generator of cases to the list.

    The generator takes whether a quick run is asked for, and may raise `DataAbsent`.
    """

    def add(cases: Callable[[bool], Iterator[Case]]) -> Callable[[bool], Iterator[Case]]:
        EXPERIMENTS[name] = Experiment(name, title, protocol, cases)
        return cases

    return add


def is_success(errors: dict[str, float] | None, criterion: dict[str, float]) -> bool:
    """Whether there is a pose and all its errors are within the criterion."""
    return errors is not None and all(errors[name] <= limit for name, limit in criterion.items())
