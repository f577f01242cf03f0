"""What the pictures need of a result: read from its JSON, whoever wrote that."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from .. import CloudResult, Options, Result


class Line(NamedTuple):
    """A line of the report in words; its tone is '', 'good', 'fair' or 'bad'."""

    label: str
    text: str
    tone: str = ""


@dataclass(frozen=True)
class Bounds:
    """What was achieved, and what was proven to be the most."""

    lower: float
    upper: float
    certified: bool


@dataclass(frozen=True)
class Outcome:
    """What a result says.

    Attributes
    ----------
    rotation, translation : ndarray, shapes (3, 3) and (3,)
        With ``scale``, the transform x_target = scale * rotation @ x_source + translation, metres.
    inliers : ndarray of int64, shape (m,)
        Indices of correspondences, ascending.
    noise_bound : float or None
        Metres; None where it is not known, or each correspondence has its own.
    stages : dict
        Stage -> seconds, in order.
    verdict : str or None
        'trusted', 'doubtful' or 'untrusted', of two clouds.
    options : dict
        Option -> value, as used.
    report : tuple of Line
        The result in words.
    """

    status: str
    scale: float
    rotation: npt.NDArray[np.float64]
    translation: npt.NDArray[np.float64]
    inliers: npt.NDArray[np.int64]
    num_correspondences: int
    evidence: Bounds
    certificate: Bounds
    noise_bound: float | None
    stages: dict[str, float]
    total_seconds: float
    num_threads: int
    instruction_set: str
    version: str
    verdict: str | None
    options: dict[str, Any]
    report: tuple[Line, ...]

    @property
    def has_pose(self) -> bool:
        """Whether there is a transform to show."""
        return self.status in ("ok", "degenerate")

    def matrix(self) -> npt.NDArray[np.float64]:
        """Homogeneous matrix of the transform, (4, 4)."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.scale * self.rotation
        matrix[:3, 3] = self.translation
        return matrix


def outcome_of_result(result: Result | CloudResult, options: Options) -> Outcome:
    """Outcome of a result of ``register_correspondences`` or ``register_clouds``.

    Parameters
    ----------
    result : Result or CloudResult
        The result.
    options : Options
        Those that it was computed with.

    Returns
    -------
    Outcome
    """
    return outcome_of_json(json.loads(result.to_json(options)))


def outcome_of_json(fields: dict[str, Any]) -> Outcome:
    """Outcome of the JSON object of a result, docs/json.md.

    Parameters
    ----------
    fields : dict
        The object.

    Returns
    -------
    Outcome
    """
    certificate = fields["certificate"]
    times = {stage: milliseconds / 1000 for stage, milliseconds in fields["time_ms"].items()}
    total_seconds = times.pop("total")
    return Outcome(
        status=fields["status"],
        scale=fields["scale"],
        rotation=np.array(fields["rotation"]),
        translation=np.array(fields["translation"]),
        inliers=np.array(fields["inliers"], dtype=np.int64),
        num_correspondences=fields["num_correspondences"],
        evidence=Bounds(**certificate["evidence"]),
        certificate=Bounds(*(certificate[name] for name in ("lower", "upper", "certified"))),
        noise_bound=fields.get("noise_bound") or None,
        stages=times,
        total_seconds=total_seconds,
        num_threads=fields["threads"],
        instruction_set=fields["isa"],
        version=fields["version"],
        verdict=fields.get("verdict"),
        options=fields.get("options", {}),
        report=tuple(Line(**line) for line in fields["report"]),
    )
