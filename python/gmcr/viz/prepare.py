"""From what users have, a result or the tool's files, to an outcome and its scene."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from .. import CloudLike, CloudResult, Options, Result
from .._arguments import as_cloud, as_points
from .outcome import Outcome, outcome_of_json, outcome_of_result
from .scene import DrawLimits, Floats, Scene, make_scene


def scene_of_result(
    result: Result | CloudResult,
    source: CloudLike,
    target: CloudLike,
    options: Options | None,
    limits: DrawLimits | None,
) -> tuple[Outcome, Scene]:
    """Outcome and scene of a result, its points, and its options where they are known."""
    if not isinstance(result, (Result, CloudResult)):
        raise TypeError(f"result: expected Result or CloudResult, got {type(result).__name__}")
    outcome = outcome_of_result(result, options)
    as_given = as_cloud if isinstance(result, CloudResult) else as_points
    clouds = as_given(source, "source"), as_given(target, "target")
    matched = clouds
    if isinstance(result, CloudResult):
        _check_sizes(result, clouds)
        matched = np.asarray(result.matches.source), np.asarray(result.matches.target)
    bounds = np.asarray(() if options is None else options.noise_bounds, dtype=float)
    limit = _limit(outcome, bounds if bounds.size else None)
    return outcome, make_scene(outcome, clouds, matched, limit, limits)


def scene_of_files(
    result: Path, matches: Path, clouds: tuple[Path, Path] | None
) -> tuple[Outcome, Scene]:
    """Outcome and scene of the files that the tool writes.

    Parameters
    ----------
    result : Path
        JSON object of ``gmcr register`` or ``gmcr solve``.
    matches : Path
        ``.npy`` of shape (N, 6) or, with noise bounds, (N, 7).
    clouds : pair of Path, optional
        ``.npy`` of shape (N, 3) each; the matched points where there are none.

    Returns
    -------
    tuple of Outcome and Scene
    """
    outcome = outcome_of_json(json.loads(result.read_text(encoding="utf-8")))
    rows = np.load(matches)
    matched = rows[:, :3].astype(float), rows[:, 3:6].astype(float)
    drawn = matched if clouds is None else (np.load(clouds[0]), np.load(clouds[1]))
    bounds = rows[:, 6] if rows.shape[1] > 6 else None
    limit = _limit(outcome, bounds)
    return outcome, make_scene(outcome, drawn, matched, limit)


def _check_sizes(result: CloudResult, clouds: tuple[Floats, Floats]) -> None:
    expected = result.num_source_points, result.num_target_points
    for name, cloud, size in zip(("source", "target"), clouds, expected, strict=True):
        if len(cloud) != size:
            raise ValueError(f"{name}: {len(cloud)} points, but the result is about {size}")


def _limit(outcome: Outcome, bounds: Floats | None) -> Floats | None:
    if bounds is not None:
        return bounds
    if outcome.noise_bound is None:
        return None
    return np.full(outcome.num_correspondences, outcome.noise_bound)
