"""What the pictures need of a result: read from its JSON, whoever wrote that."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from .. import CloudResult, Options, Result
from .motion import angle_axis


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
class OtherPose:
    """Another pose that much speaks for: ``words`` say how much, and how far away it is."""

    words: str
    scale: float
    rotation: npt.NDArray[np.float64]
    translation: npt.NDArray[np.float64]


@dataclass(frozen=True)
class WeakDirection:
    """A motion that the surfaces leave open: about, or along, ``axis``, (3,), unit."""

    words: str
    axis: npt.NDArray[np.float64]


@dataclass(frozen=True)
class Outcome:
    """What a result says.

    Attributes
    ----------
    rotation, translation : ndarray, shapes (3, 3) and (3,)
        With ``scale``, the transform x_target = scale * rotation @ x_source + translation, metres.
    inliers : ndarray of int64, shape (m,)
        Indices of correspondences, ascending.
    pose_evidence : float
        Evidence of the pose; ``evidence.lower`` is the most that any found pose has.
    noise_bound : float or None
        Metres; None where it is not known, or each correspondence has its own.
    stages : dict
        Stage -> seconds, in order.
    verdict : str or None
        'trusted', 'doubtful' or 'untrusted'.
    verdict_reason : str
        One sentence.
    options : dict
        Option -> value, as given and by default; empty where they are not known.
    in_use : dict
        What was chosen from the data or searched, such as the voxel size, in words.
    consensus : str
        Evidence and number of inliers of the pose, in words.
    others : tuple of OtherPose
        Alternatives of the matches, then rivals of the surfaces.
    weak_directions : tuple of WeakDirection
        What the surfaces of two clouds leave open.
    is_of_clouds : bool
        Whether it is of two clouds, whose surfaces meet, rather than of matches alone.
    report : tuple of Line
        The result in words.
    """

    status: str
    scale: float
    rotation: npt.NDArray[np.float64]
    translation: npt.NDArray[np.float64]
    inliers: npt.NDArray[np.int64]
    num_correspondences: int
    pose_evidence: float
    evidence: Bounds
    certificate: Bounds
    noise_bound: float | None
    stages: dict[str, float]
    total_seconds: float
    num_threads: int
    instruction_set: str
    version: str
    verdict: str | None
    verdict_reason: str
    options: dict[str, Any]
    in_use: dict[str, str]
    consensus: str
    others: tuple[OtherPose, ...]
    weak_directions: tuple[WeakDirection, ...]
    is_of_clouds: bool
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


def outcome_of_result(result: Result | CloudResult, options: Options | None) -> Outcome:
    """Outcome of a result of ``register_correspondences`` or ``register_clouds``.

    Parameters
    ----------
    result : Result or CloudResult
        The result.
    options : Options or None
        Those that it was computed with, where they are known.

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
        pose_evidence=fields["evidence"],
        evidence=_bounds(certificate["evidence"]),
        certificate=_bounds(certificate),
        noise_bound=fields.get("noise_bound") or None,
        stages=times,
        total_seconds=total_seconds,
        num_threads=fields["threads"],
        instruction_set=fields["isa"],
        version=fields["version"],
        verdict=fields.get("verdict"),
        verdict_reason=fields.get("verdict_reason", ""),
        options=fields.get("options") or {},
        in_use=_in_use(fields),
        consensus=_consensus(fields),
        others=_others(fields),
        weak_directions=tuple(
            _weak_direction(entry)
            for entry in fields.get("surfaces", {}).get("weak_directions", ())
        ),
        is_of_clouds="fitness" in fields,
        report=_report(fields),
    )


def _bounds(entry: dict[str, Any]) -> Bounds:
    # by name: later versions may write more
    return Bounds(entry["lower"], entry["upper"], entry["certified"])


def _in_use(fields: dict[str, Any]) -> dict[str, str]:
    """What the result itself knows of how it came about."""
    known = {}
    for name in ("voxel_size", "source_voxel_size", "noise_bound"):
        if fields.get(name):
            known[name] = f"{fields[name]:.4g} m"
    if known.get("source_voxel_size") == known.get("voxel_size"):
        known.pop("source_voxel_size", None)
    low, high = fields.get("scale_range", (1, 1))
    known["scale"] = f"known: {low:.6g}" if low == high else f"searched, {low:.4g} to {high:.4g}"
    if fields.get("num_attempts", 1) > 1:
        known["settings tried"] = str(fields["num_attempts"])
    known["threads"] = str(fields["threads"])
    return known


def _others(fields: dict[str, Any]) -> tuple[OtherPose, ...]:
    others = []
    is_best = _is_best(fields)
    for entry in fields.get("alternatives", ()):
        said = _consensus(entry)
        if is_best:
            share = entry["evidence"] / fields["evidence"]
            said = f"{100 * share:.0f} % of the evidence, {_inliers(entry)}"
        others.append(_other(said, entry, fields))
    for entry in fields.get("rivals", ()):
        said = f"the surfaces meet {100 * entry['overlap']:.0f} % as much"
        said += ", a symmetry" if entry["is_symmetry"] else ""
        others.append(_other(said, entry, fields))
    return tuple(others)


def _is_best(fields: dict[str, Any]) -> bool:
    """Whether the pose has the most evidence; one that the surfaces chose may have none at all."""
    most = max((entry["evidence"] for entry in fields.get("alternatives", ())), default=0)
    return bool(0 < fields["evidence"] >= most)


def _consensus(entry: dict[str, Any]) -> str:
    return f"evidence {entry['evidence']:.1f}, {_inliers(entry)}"


def _inliers(entry: dict[str, Any]) -> str:
    return f"{entry['num_inliers']} inlier" + ("" if entry["num_inliers"] == 1 else "s")


def _report(fields: dict[str, Any]) -> tuple[Line, ...]:
    """The lines as they are, but no shares of the evidence of a pose that has not the most."""
    lines = [Line(*(line[name] for name in Line._fields)) for line in fields["report"]]
    alternatives = fields.get("alternatives")
    if not alternatives or _is_best(fields):
        return tuple(lines)
    others = [other.words for other in _others(fields)[: len(alternatives)]]
    about = ""
    for index, line in enumerate(lines):
        about = line.label or about
        if about == "alternatives" and others:
            lines[index] = line._replace(text=others.pop(0))
        elif about == "ambiguous" and "of the evidence" in line.text:
            lines[index] = line._replace(text="the matches speak more for other poses")
    return tuple(lines)


def _other(said: str, entry: dict[str, Any], fields: dict[str, Any]) -> OtherPose:
    rotation, translation = np.array(entry["rotation"]), np.array(entry["translation"])
    angle, _ = angle_axis(rotation @ np.array(fields["rotation"]).T)
    away = np.linalg.norm(translation - fields["translation"])
    said += f"; {np.degrees(angle):.3g} deg and {away:.3g} m away"
    return OtherPose(said, entry["scale"], rotation, translation)


def _weak_direction(entry: dict[str, Any]) -> WeakDirection:
    motion = "a turn about" if entry["kind"] == "turn" else "a shift along"
    said = ", ".join(f"{value:.2f}" for value in entry["direction"])
    return WeakDirection(f"{motion} ({said})", np.array(entry["direction"], dtype=float))
