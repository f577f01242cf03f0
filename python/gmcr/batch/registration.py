"""The work on one pair: files in, row out."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from typing import Any

import gmcr

from .matches import read_matches
from .options import frontend_options, solver_options
from .pairs import Pair
from .row import Row, row_of


def register_pair(pair: Pair, options: Mapping[str, Any]) -> Row:
    """Registers the matches, or the two clouds, of a pair on one thread.

    Parameters
    ----------
    pair : Pair
        Its files and its own options.
    options : mapping
        Options of all pairs; those of the pair come first.

    Returns
    -------
    Row
        As from ``gmcr.register_correspondences`` or ``gmcr.register_clouds``.

    Raises
    ------
    OSError, ValueError, TypeError
        as of reading and registering.
    """
    values = {**options, **pair.options}
    return _of_clouds(pair, values) if pair.matches is None else _of_matches(pair, values)


def refuse_hopeless(pairs: Iterable[Pair], options: Mapping[str, Any]) -> None:
    """Refuses a list no pair of which can come to a pose: none has a noise bound.

    Parameters
    ----------
    pairs : iterable of Pair
        Read until the first that may succeed.
    options : mapping
        Options of all pairs.

    Raises
    ------
    ValueError
        where each pair is of matches, and none of those that can be read has a bound.
    """
    num_pairs = num_without = 0
    for pair in pairs:
        values = {**options, **pair.options}
        if pair.matches is None or _is_bounded(values):
            return
        num_pairs += 1
        try:
            noise_bounds = read_matches(pair.matches)[2]
        except (OSError, ValueError):
            continue  # for the row to say; the workers may see files that this machine does not
        if noise_bounds is not None:
            return
        num_without += 1
    if num_without:
        raise ValueError(
            f"noise_bound: is missing, so that each of the {num_pairs} pairs would fail; give one "
            "to all (noise_bound=0.05, metres, or 'auto'), a column noise_bound to the list of "
            "pairs, or a seventh column to the matches"
        )


def _is_bounded(values: Mapping[str, Any]) -> bool:
    return values.get("noise_mode") == "estimated" or values.get("noise_bound", 0) != 0


def _of_matches(pair: Pair, values: dict[str, Any]) -> Row:
    assert pair.matches is not None
    started = time.perf_counter()
    source, target, noise_bounds = read_matches(pair.matches)
    read_seconds = time.perf_counter() - started
    solver = solver_options(values)
    if noise_bounds is not None:
        solver.noise_bound, solver.noise_mode, solver.noise_bounds = 0, "given", noise_bounds
    result = gmcr.register_correspondences(source, target, solver)
    return row_of(pair.id, result, solver, read_seconds)


def _of_clouds(pair: Pair, values: dict[str, Any]) -> Row:
    from gmcr._prepared import as_prepared
    from gmcr.io import read_points

    assert pair.source is not None and pair.target is not None
    started = time.perf_counter()
    source, target = (as_prepared(path) or read_points(path) for path in (pair.source, pair.target))
    read_seconds = time.perf_counter() - started
    solver = solver_options(values)
    result = gmcr.register_clouds(source, target, frontend_options(values), solver)
    return row_of(pair.id, result, solver, read_seconds)
