"""Which options a pair can have, and how they reach the solver and the front end."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from typing import Any

import gmcr

from .._arguments import option_names
from .._hints import ELSEWHERE, refuse_memory_in_words

_NO_POSE = "priors on the pose are for single registrations"
_WORKERS = "one thread works on each pair, --workers (num_workers) on as many pairs at a time"

#: Not for a table: one thread works on a pair, so that the cores are shared by the pairs; the
#: others are objects, or go with these.
_EXCLUDED = {
    "num_threads": _WORKERS,
    "progress": "the run itself shows its progress",
    "gravity": _NO_POSE,
    "initial_pose": _NO_POSE,
    "max_rotation_error": _NO_POSE,
    "max_translation_error": _NO_POSE,
    "noise_bounds": "bounds of single matches are the seventh column of their file",
}
_LIKENESS = 0.7  # of a name and the one that it was meant to be

_SOLVER_NAMES = frozenset(option_names(gmcr.Options)) - _EXCLUDED.keys()
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


def advice_on(name: str, known: Iterable[str]) -> str:
    """What to write instead of a name that is none of the known ones; empty where nobody knows."""
    written = ELSEWHERE.get(name, "")
    meant = written.partition("=")[0] or name
    if meant in _EXCLUDED:
        return f"; {_EXCLUDED[meant]}"
    if written:
        return f"; write {written}"
    near = get_close_matches(name, sorted({*known, *_EXCLUDED}), 1, _LIKENESS)
    if not near:
        return ""
    reason = f" But {_EXCLUDED[near[0]]}" if near[0] in _EXCLUDED else ""
    return f"; did you mean {near[0]!r}?{reason}"


def check_options(values: Mapping[str, Any]) -> None:
    """Refuses names and values that no pair could use.

    Raises
    ------
    ValueError
        naming the option and its value.
    """
    unknown = values.keys() - OPTION_NAMES
    if unknown:
        name = min(unknown)
        raise ValueError(f"options: unknown name {name!r}{advice_on(name, OPTION_NAMES)}")
    try:
        refuse_memory_in_words(values)
        frontend_options(values).validate()
        solver = solver_options(values)
    except TypeError as error:
        raise ValueError(f"options: {error}") from None
    if solver.noise_mode == "given" and solver.noise_bound == 0:
        solver.noise_bound = 1  # each pair may bring its own, or take it from its clouds
    solver.validate()
