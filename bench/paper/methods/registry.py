"""What a method is, and the list of all of them, to which each file adds its own."""

from __future__ import annotations

import importlib
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from importlib import metadata
from typing import Any

import numpy as np

from paper.problem import Pose, Problem


@dataclass
class Outcome:
    """What a method made of a problem."""

    status: str  # "ok", "no_pose", "time_limit", "crashed" or "error"
    pose: Pose | None = None
    reason: str = ""
    stages: dict[str, float] = field(default_factory=dict)  # seconds
    certificate: dict | None = None
    limits_hit: list[str] = field(default_factory=list)
    threads: int | None = None


@dataclass(frozen=True)
class Look:
    """How a method looks in tables and figures."""

    label: str
    place: int  # in legends and tables, ascending; fits to inliers that are known come last
    colour: str = "#555555"
    marker: str = "h"  # "": a line without marks
    dashes: Any = (0, (3, 1))


class Method(ABC):
    """A method under test. Only `solve` is timed; it is called several times for one `prepare`."""

    name = ""  # in records and tables
    look: Look | None = None  # None: its name, in grey, after those that have one
    is_everywhere = True  # False: only in the experiments that name it
    settings = ""  # one sentence for the reader
    modules: tuple[str, ...] = ()  # that have to be installed
    distribution: str | None = None  # whose version is recorded
    needs_known_scale = False
    max_time_limit = float("inf")  # seconds; a method that uses all it is given gets no more

    @classmethod
    def unavailable_reason(cls) -> str | None:
        """Why the method cannot run here, None where it can."""
        for module in cls.modules:
            try:
                importlib.import_module(module)
            except ImportError as error:
                return f"{module} cannot be imported: {error}"
        return None

    @classmethod
    def version(cls) -> str | None:
        try:
            return metadata.version(cls.distribution) if cls.distribution else None
        except metadata.PackageNotFoundError:
            return "unknown"

    @abstractmethod
    def prepare(self, problem: Problem, time_limit: float) -> None:
        """Turn the problem into the method's own containers."""

    @abstractmethod
    def solve(self) -> Any:
        """Solve the prepared problem; the result goes to `outcome`."""

    @abstractmethod
    def outcome(self, result: Any) -> Outcome:
        """Read the result of `solve`."""


METHODS: dict[str, type[Method]] = {}
_PLACE_WITHOUT_A_LOOK = 80


def look_of(name: str) -> Look:
    return METHODS[name].look or Look(name, _PLACE_WITHOUT_A_LOOK)


def in_order(*, is_scale_known: bool) -> tuple[str, ...]:
    """Names of the methods that solve such problems in any experiment, as tables list them."""
    able = (
        name
        for name, method in METHODS.items()
        if method.is_everywhere and (is_scale_known or not method.needs_known_scale)
    )
    return tuple(sorted(able, key=lambda name: (look_of(name).place, name)))


def register(method: type[Method]) -> type[Method]:
    """Class decorator that adds a method to the list."""
    if method.name in METHODS:
        raise ValueError(f"method: {method.name} is registered twice")
    METHODS[method.name] = method
    return method


def outcome_of_pose(rotation: np.ndarray, translation: np.ndarray, scale: float = 1.0) -> Outcome:
    """Outcome of a solver that always returns a pose; one that is no similarity is none."""
    values = [*np.ravel(rotation), *np.ravel(translation), scale]
    if not np.isfinite(values).all() or scale <= 0:
        return Outcome("no_pose", reason="the transform is not a similarity")
    return Outcome(
        "ok", Pose(float(scale), np.array(rotation), np.ravel(translation).astype(float))
    )
