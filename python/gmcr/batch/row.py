"""What is written about one pair."""

from __future__ import annotations

import dataclasses


@dataclasses.dataclass
class Row:
    """One line of the results. Fields that do not apply are None; pairs without a pose have none.

    All fields but the times and ``attempts`` are the same bits on every machine and for every
    number of workers, unless ``limits_hit`` says that a time limit ended the search.
    """

    id: str
    #: 'ok', 'too_few_correspondences', 'no_consensus', 'degenerate', or 'error', see reason.
    status: str
    #: Why not 'ok', one sentence.
    reason: str = ""
    #: Homogeneous matrix [s R, t; 0 0 0 1], 16 numbers, row by row: x_target = s R x_source + t.
    target_from_source: list[float] | None = None
    scale: float | None = None
    num_correspondences: int | None = None
    num_inliers: int | None = None
    #: Proven: no transform has more inliers.
    max_inliers: int | None = None
    #: num_inliers == max_inliers.
    certified: bool | None = None
    evidence: float | None = None
    #: Metres; None where every correspondence had its own.
    noise_bound: float | None = None
    #: 'trusted', 'doubtful' or 'untrusted', with the reason, of two clouds.
    verdict: str | None = None
    verdict_reason: str | None = None
    #: Share of the source that meets the target, of two clouds.
    fitness: float | None = None
    #: One sentence for each limit that made the work less than complete.
    limits_hit: list[str] | None = None
    #: Indices of the correspondences that agree; only where they were asked for.
    inliers: list[int] | None = None
    #: Wall time of the pair, its time on a core, and the wall time of reading its files.
    seconds: float | None = None
    cpu_seconds: float | None = None
    read_seconds: float | None = None
    #: How often the pair was started.
    attempts: int = 1


def error_row(id: str, reason: str, attempts: int = 1) -> Row:
    """Row of a pair that could not be worked on."""
    return Row(id=id, status="error", reason=reason, attempts=attempts)
