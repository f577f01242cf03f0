"""What a result says, in words."""

from __future__ import annotations

from typing import Any

import numpy as np

from .motion import angle_axis
from .outcome import Bounds, Outcome
from .scene import Scene

Rows = list[tuple[str, str]]

# A runner-up with a larger share of the evidence makes the answer ambiguous.
_AMBIGUOUS = 0.8


def count(number: int, noun: str) -> str:
    """Such as '1 inlier' or '5,344 matches'."""
    plural = noun + ("es" if noun.endswith("ch") else "s")
    return f"{number:,} {noun if number == 1 else plural}"


def share(part: int, whole: int) -> str:
    """Such as '44 of 5,344 (0.8 %)'."""
    return f"{part:,} of {whole:,}" + (f" ({100 * part / whole:.1f} %)" if whole else "")


def duration(seconds: float) -> str:
    """Such as '1.23 ms' or '45.6 s'."""
    return f"{1000 * seconds:.3g} ms" if seconds < 1 else f"{seconds:.3g} s"


def vector(values: Any) -> str:
    """Such as '(1.5, 0, -2)'."""
    return "(" + ", ".join(f"{value:.6g}" for value in values) + ")"


def status(outcome: Outcome) -> str:
    """One line on what the registration came to."""
    if outcome.status == "ok":
        return "pose found"
    return f"{outcome.status.replace('_', ' ')}: {outcome.status_reason}"


def certificate(outcome: Outcome) -> str:
    """How far the consensus can be from the best possible."""
    bounds = outcome.certificate
    inliers = count(int(bounds.lower), "inlier")
    if bounds.certified:
        return f"{inliers}; no pose has more: proven optimal{_where(outcome)}"
    return f"{inliers}; no pose has more than {int(bounds.upper):,}{_where(outcome)}"


def evidence(bounds: Bounds) -> str:
    """How far the evidence can be from the best possible."""
    most = "no pose has more" if bounds.certified else f"no pose has more than {bounds.upper:,.1f}"
    return f"{bounds.lower:,.1f}; {most}"


def uncertainty(outcome: Outcome) -> str | None:
    """Standard deviations of the transform, or None where there is no covariance."""
    matrix = outcome.covariance
    if matrix is None:
        return None
    rotation, translation = _deviation(matrix[:3, :3]), _deviation(matrix[3:6, 3:6])
    text = f"rotation {np.degrees(rotation):.2g}°, translation {translation:.2g} m"
    if len(matrix) > 6:
        text += f", scale {100 * _deviation(matrix[6:, 6:]):.2g} %"
    return text + " (one standard deviation, worst axis)"


def pose_rows(outcome: Outcome) -> Rows:
    """The transform: label and text of each line."""
    if not outcome.has_pose:
        return [("pose", "none")]
    angle, axis = angle_axis(outcome.rotation)
    length = float(np.linalg.norm(outcome.translation))
    rows = [
        ("scale", f"{outcome.scale:.6g}"),
        ("rotation", f"{np.degrees(angle):.3f}° about {vector(np.round(axis, 4))}"),
        ("translation", f"{vector(outcome.translation)}, length {length:.6g} m"),
    ]
    deviations = uncertainty(outcome)
    return rows + ([("uncertainty", deviations)] if deviations else [])


def result_rows(outcome: Outcome) -> Rows:
    """What was found: label and text of each line."""
    total = outcome.num_correspondences
    rows = [("status", status(outcome))]
    surfaces = outcome.surfaces
    if surfaces is not None:
        rows.append(("verdict", f"{surfaces.verdict}: {surfaces.verdict_reason}"))
    rows.append(("inliers", share(len(outcome.inliers), total)))
    if outcome.num_used != total:
        rows.append(("used", share(outcome.num_used, total) + ", those that the priors admit"))
    rows += [("certificate", certificate(outcome)), ("evidence", evidence(outcome.evidence))]
    if outcome.num_instances > 1:
        rows.append(("instances", f"{outcome.num_instances} were found; this is the first"))
    if outcome.num_alternatives:
        rows.append(("alternatives", _alternatives(outcome)))
    if outcome.noise_bound is not None:
        chosen = ", chosen from the matches" if outcome.is_noise_estimated else ""
        rows.append(("noise bound", f"{outcome.noise_bound:.4g} m{chosen}"))
    if surfaces is not None:
        rows += [
            ("fitness", f"{100 * surfaces.fitness:.1f} % of the source meets the target"),
            ("", f"{100 * surfaces.target_fitness:.1f} % of the target meets the source"),
            ("overlap RMSE", f"{surfaces.overlap_rmse:.4g} m"),
        ]
    threads = count(outcome.num_threads, "thread")
    rows.append(("time", f"{duration(outcome.total_seconds)} with {threads}"))
    rows.append(("limits hit", "; ".join(outcome.limits_hit) or "none"))
    return rows


def option_rows(outcome: Outcome) -> Rows:
    """The options that were used: name and value of each."""
    return [(name, _value(value)) for name, value in outcome.options.items()]


def drawn(outcome: Outcome, scene: Scene) -> list[str]:
    """What is drawn of how much, one sentence each."""
    sentences = []
    for name, sample in (("source", scene.source_points), ("target", scene.target_points)):
        shown = f"{len(sample.indices):,}"
        kept = f"all {shown}" if len(sample.indices) == sample.total else f"{shown} of "
        kept += "" if len(sample.indices) == sample.total else f"{sample.total:,}"
        sentences.append(f"{name.capitalize()}: showing {kept} points")
    sentences.append(
        f"Lines: {scene.inliers.words('inliers')} and {scene.outliers.words('outliers')}"
    )
    if scene.origin.any():
        sentences.append(f"Axes relative to {vector(scene.origin)}")
    if not outcome.has_pose:
        sentences.append("No pose was found: both clouds are where they were given")
    return sentences


def agreement(scene: Scene) -> str:
    """How many pairs of the drawn part of the consensus graph agree."""
    if scene.graph is None:
        return "not drawn: " + (
            "the noise bound is not known; give the options of the registration"
            if scene.bounds is None
            else "there is no pose"
        )
    graph = scene.graph
    k = len(graph.inliers.indices)
    inside = graph.adjacency[:k, :k].sum() // 2
    others = graph.adjacency.sum() // 2 - inside
    n = len(graph.adjacency)
    num_inside, num_others = k * (k - 1) // 2, n * (n - 1) // 2 - k * (k - 1) // 2
    text = f"{share(int(inside), num_inside)} pairs of inliers agree"
    if num_others:
        text += f"; of the other pairs {share(int(others), num_others)}"
    return text


def _where(outcome: Outcome) -> str:
    least, most = outcome.scale_range
    return f", at scales from {least:.4g} to {most:.4g}" if least < most else ""


def _deviation(block: Any) -> float:
    return float(np.sqrt(max(0.0, np.linalg.eigvalsh(block)[-1])))


def _alternatives(outcome: Outcome) -> str:
    ratio = outcome.runner_up_ratio
    warning = "ambiguous: " if ratio > _AMBIGUOUS else ""
    return f"{outcome.num_alternatives}; {warning}the best has {100 * ratio:.0f} % of the evidence"


def _value(value: Any) -> str:
    if value is None:
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (list, tuple, np.ndarray)):
        numbers = np.asarray(value, dtype=float).ravel()
        if not len(numbers):
            return "none"
        return vector(numbers) if len(numbers) <= 7 else f"{len(numbers):,} values"
    if isinstance(value, int):
        return f"{value:,}"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
