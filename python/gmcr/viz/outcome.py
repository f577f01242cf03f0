"""What a result says, whether it comes from Python or from the JSON of the tool."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from .. import CloudResult, Options, Result, __version__, instruction_set


@dataclass(frozen=True)
class Bounds:
    """What was achieved, and what was proven to be the most."""

    lower: float
    upper: float
    certified: bool


@dataclass(frozen=True)
class Surfaces:
    """How the surfaces of two clouds meet; shares in [0, 1], lengths in metres."""

    num_source_points: int
    num_target_points: int
    fitness: float
    target_fitness: float
    overlap_rmse: float
    verdict: str
    verdict_reason: str


@dataclass(frozen=True)
class Outcome:
    """What a result says.

    Attributes
    ----------
    rotation, translation : ndarray, shapes (3, 3) and (3,)
        With ``scale``, the transform x_target = scale * rotation @ x_source + translation, metres.
    inliers : ndarray of int64, shape (m,)
        Indices of correspondences, ascending.
    num_instances : int
        Instances that were found; the outcome is that of the first.
    scale_range : tuple of float
        Scales that were searched; equal: it was known.
    noise_bound : float or None
        Metres; None where it is not known, or each correspondence has its own.
    stages : dict
        Stage -> seconds, in order.
    covariance : ndarray, shape (6, 6) or (7, 7), or None
        Rotation (radians), translation (metres), relative scale.
    options : dict
        Option -> value, as used.
    """

    status: str
    status_reason: str
    scale: float
    rotation: npt.NDArray[np.float64]
    translation: npt.NDArray[np.float64]
    inliers: npt.NDArray[np.int64]
    num_correspondences: int
    num_used: int
    evidence: Bounds
    certificate: Bounds
    scale_range: tuple[float, float]
    covariance: npt.NDArray[np.float64] | None
    num_alternatives: int
    runner_up_ratio: float
    noise_bound: float | None
    is_noise_estimated: bool
    stages: dict[str, float]
    total_seconds: float
    num_threads: int
    instruction_set: str
    version: str
    limits_hit: list[str]
    num_instances: int = 1
    surfaces: Surfaces | None = None
    options: dict[str, Any] = field(default_factory=dict)

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
    is_cloud = isinstance(result, CloudResult)
    registration = result.registration if isinstance(result, CloudResult) else result
    diagnostics = registration.diagnostics
    certificate = registration.certificate
    covariance = registration.covariance
    return Outcome(
        status=str(registration.status),
        status_reason=registration.status_reason,
        scale=registration.scale,
        rotation=np.asarray(registration.rotation),
        translation=np.asarray(registration.translation),
        inliers=np.asarray(registration.inliers),
        num_correspondences=diagnostics.num_correspondences,
        num_used=diagnostics.num_used,
        evidence=_bounds(certificate.evidence),
        certificate=_bounds(certificate),
        scale_range=_pair(diagnostics.scale_range),
        covariance=None if covariance is None else np.asarray(covariance.matrix),
        num_alternatives=len(registration.alternatives),
        runner_up_ratio=registration.runner_up_ratio,
        noise_bound=_noise_bound(result, registration, options),
        is_noise_estimated=registration.noise_estimate is not None,
        stages=dict(diagnostics.stages),
        total_seconds=diagnostics.total_seconds,
        num_threads=diagnostics.num_threads,
        instruction_set=instruction_set(),
        version=__version__,
        limits_hit=list(diagnostics.limits_hit),
        surfaces=_surfaces(result) if is_cloud else None,
        options=_values_of(options),
    )


def outcome_of_json(fields: dict[str, Any]) -> Outcome:
    """Outcome of the JSON object that ``gmcr register`` or ``gmcr solve`` writes.

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
    covariance = fields["covariance"]
    return Outcome(
        status=fields["status"],
        status_reason=fields["status_reason"],
        scale=fields["scale"],
        rotation=np.array(fields["rotation"]),
        translation=np.array(fields["translation"]),
        inliers=np.array(fields["inliers"], dtype=np.int64),
        num_correspondences=fields["num_correspondences"],
        num_used=fields["num_used"],
        evidence=Bounds(**certificate["evidence"]),
        certificate=Bounds(*(certificate[name] for name in ("lower", "upper", "certified"))),
        scale_range=tuple(fields["scale_range"]),
        covariance=None if covariance is None else np.array(covariance["matrix"]),
        num_alternatives=len(fields.get("alternatives", [])),
        runner_up_ratio=fields.get("runner_up_ratio", 0.0),
        noise_bound=fields.get("noise_bound"),
        is_noise_estimated="noise_estimate" in fields,
        stages=times,
        total_seconds=total_seconds,
        num_threads=fields["threads"],
        instruction_set=fields["isa"],
        version=fields["version"],
        limits_hit=fields["limits_hit"],
        num_instances=_num_instances(fields),
        surfaces=_surfaces_of_json(fields) if "verdict" in fields else None,
        options=fields.get("options", {}),
    )


def _pair(limits: Any) -> tuple[float, float]:
    least, most = limits
    return float(least), float(most)


def _bounds(certificate: Any) -> Bounds:
    return Bounds(certificate.lower, certificate.upper, certificate.certified)


def _noise_bound(
    result: Result | CloudResult, registration: Result, options: Options
) -> float | None:
    if registration.noise_estimate is not None:
        return registration.noise_estimate.noise_bound
    if isinstance(result, CloudResult):
        return result.matches.noise_bound or None
    return options.noise_bound or None


def _surfaces(result: Any) -> Surfaces:
    names = Surfaces.__dataclass_fields__
    return Surfaces(**{name: getattr(result, name) for name in names})


def _num_instances(fields: dict[str, Any]) -> int:
    instances = fields.get("instances", [fields])
    return sum(instance["status"] == "ok" for instance in instances)


def _surfaces_of_json(fields: dict[str, Any]) -> Surfaces:
    return Surfaces(**{name: fields[name] for name in Surfaces.__dataclass_fields__})


def _values_of(options: Options) -> dict[str, Any]:
    names = [name for name in dir(options) if not name.startswith("_") and name != "progress"]
    values = {name: getattr(options, name) for name in names}
    return {name: value for name, value in values.items() if not callable(value)}
