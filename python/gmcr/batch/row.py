"""What is written about one pair."""

from __future__ import annotations

import dataclasses
import json
from itertools import chain
from typing import Any

import gmcr


@dataclasses.dataclass
class Row:
    """One line of the results. Fields that do not apply are None; pairs without a pose have none.

    All fields but the times and ``attempts`` are the same bits on every machine and for every
    number of workers, unless ``limits_hit`` says that a time limit ended the search.

    Attributes
    ----------
    id : str
        Of the pair, as the list has it.
    status : str
        'ok', 'too_few_correspondences', 'no_consensus', 'degenerate', or 'error', see ``reason``.
    reason : str
        Why not 'ok', one sentence.
    target_from_source : list of float
        Homogeneous matrix [s R, t; 0 0 0 1], 16 numbers, row by row: x_target = s R x_source + t.
    scale : float
        s, > 0.
    num_correspondences, num_inliers : int
        Matches of the pair, and those that agree with the transform.
    max_inliers : int
        Proven: no transform has more inliers.
    certified : bool
        ``num_inliers == max_inliers``.
    evidence : float
        What was maximised: inliers that are near copies of each other share one vote.
    noise_bound : float
        Metres; None where every correspondence had its own.
    verdict, verdict_reason : str
        'trusted', 'doubtful' or 'untrusted', and why, one sentence.
    fitness : float
        Share of the source that meets the target, in [0, 1]; of two clouds.
    limits_hit : list of str
        One sentence for each limit that made the work less than complete.
    inliers : list of int
        Indices of the correspondences that agree; only where they were asked for.
    seconds, cpu_seconds, read_seconds : float
        Wall time of the pair, its time on a core, and the wall time of reading its files.
    attempts : int
        How often the pair was started.
    """

    id: str
    status: str
    reason: str = ""
    target_from_source: list[float] | None = None
    scale: float | None = None
    num_correspondences: int | None = None
    num_inliers: int | None = None
    max_inliers: int | None = None
    certified: bool | None = None
    evidence: float | None = None
    noise_bound: float | None = None
    verdict: str | None = None
    verdict_reason: str | None = None
    fitness: float | None = None
    limits_hit: list[str] | None = None
    inliers: list[int] | None = None
    seconds: float | None = None
    cpu_seconds: float | None = None
    read_seconds: float | None = None
    attempts: int = 1


def row_of(
    id: str, result: gmcr.Result | gmcr.CloudResult, options: gmcr.Options, read_seconds: float
) -> Row:
    """Row of a result and of the options that it was computed with, read from its JSON."""
    fields: dict[str, Any] = json.loads(result.to_json(options))
    has_pose = fields["status"] in ("ok", "degenerate")
    return Row(
        id=id,
        status=fields["status"],
        reason=fields["status_reason"],
        target_from_source=[*chain(*fields["target_from_source"])] if has_pose else None,
        scale=fields["scale"] if has_pose else None,
        num_correspondences=fields["num_correspondences"],
        num_inliers=fields["num_inliers"],
        max_inliers=fields["certificate"]["upper"],
        certified=fields["certificate"]["certified"],
        evidence=fields["evidence"],
        noise_bound=fields.get("noise_bound"),
        verdict=fields.get("verdict"),
        verdict_reason=fields.get("verdict_reason"),
        fitness=fields.get("fitness"),
        limits_hit=fields["limits_hit"],
        inliers=fields["inliers"],
        read_seconds=read_seconds,
    )


def error_row(id: str, reason: str, attempts: int = 1) -> Row:
    """Row of a pair that could not be worked on."""
    return Row(id=id, status="error", reason=reason, attempts=attempts)
