"""Which options a pair can have, and how they reach the solver and the front end."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import gmcr

from .._arguments import option_names

#: Not for a table: one thread works on a pair, so that the cores are shared by the pairs; the
#: others are objects.
_EXCLUDED = {"num_threads", "progress", "gravity", "initial_pose", "noise_bounds"}


_SOLVER_NAMES = frozenset(option_names(gmcr.Options)) - _EXCLUDED
FRONTEND_NAMES = frozenset(option_names(gmcr.FrontendOptions))

#: Fields of ``gmcr.Options`` and ``gmcr.FrontendOptions`` that pairs and runs can set.
OPTION_NAMES = _SOLVER_NAMES | FRONTEND_NAMES


def parse_value(text: str) -> Any:
    """Value of an option: JSON (``0.05``, ``true``, ``[0.5, 2]``), or else a word."""
    try:
        return json.loads(text)
    except json.JSONDecodeError:
        return text


def solver_options(values: Mapping[str, Any]) -> gmcr.Options:
    """Options of the solver among the values, on one thread."""
    options = {name: value for name, value in values.items() if name in _SOLVER_NAMES}
    if isinstance(options.get("scale_range"), list):
        options["scale_range"] = tuple(options["scale_range"])
    return gmcr.Options(num_threads=1, **options)


def frontend_options(values: Mapping[str, Any]) -> gmcr.FrontendOptions:
    """Options of the front end among the values."""
    return gmcr.FrontendOptions(
        **{name: value for name, value in values.items() if name in FRONTEND_NAMES}
    )


def check_options(values: Mapping[str, Any]) -> None:
    """Refuses names and values that no pair could use.

    Raises
    ------
    ValueError
        naming the option and its value.
    """
    unknown = values.keys() - OPTION_NAMES
    if unknown:
        raise ValueError(f"options: unknown name {min(unknown)!r}")
    try:
        frontend_options(values).validate()
        solver = solver_options(values)
    except TypeError as error:
        raise ValueError(f"options: {error}") from None
    if solver.noise_mode == "given" and solver.noise_bound == 0:
        solver.noise_bound = 1  # each pair may bring its own, or take it from its clouds
    solver.validate()
