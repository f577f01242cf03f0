"""What is written beside the pictures: the report of the library, and what is drawn of how much."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from .. import Options, register_correspondences
from .outcome import Line, Outcome
from .scene import Scene

Rows = list[tuple[str, str]]

# Labels of the report that are about the transform.
_POSE = ("scale", "rotation", "translation", "uncertainty")
# Labels of which only the first line is taken: the others are drawn, or written as a matrix.
_SHOWN_ELSEWHERE = ("rotation", "time", "instances")


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


def headline(outcome: Outcome) -> Line:
    """The verdict on a pose of two clouds, or else what the registration came to."""
    label = "verdict" if outcome.verdict is not None and outcome.status == "ok" else "status"
    tone = next((line.tone for line in outcome.report if line.label == label), "bad")
    if label == "verdict":
        return Line(label, str(outcome.verdict), tone)
    found = outcome.status == "ok"
    return Line(label, "pose found" if found else outcome.status.replace("_", " "), tone)


def reason(outcome: Outcome) -> str:
    """Why the headline says what it says."""
    if outcome.status == "ok" and outcome.verdict_reason:
        return outcome.verdict_reason
    line = next((line for line in outcome.report if line.label == "status"), None)
    return line.text if line else outcome.status


def pose_rows(outcome: Outcome) -> Rows:
    """The transform: label and text of each line."""
    return _rows(outcome, about_pose=True) or [("pose", "none")]


def result_rows(outcome: Outcome) -> Rows:
    """What was found, but for the verdict where that is the headline: label and text."""
    rows = _rows(outcome, about_pose=False)
    return [row for row in rows if row[0] != "verdict" or headline(outcome).label != "verdict"]


def in_use_rows(outcome: Outcome) -> Rows:
    """What was chosen, searched or given: name and value of each."""
    given = [(name, _value(outcome.options[name])) for name in _given(outcome)]
    return [*outcome.in_use.items(), *(row for row in given if row[0] not in outcome.in_use)]


def default_rows(outcome: Outcome) -> Rows:
    """The options at their defaults: name and value of each."""
    given = _given(outcome)
    return [
        (name, _value(value))
        for name, value in outcome.options.items()
        if name not in given and name not in outcome.in_use
    ]


def _given(outcome: Outcome) -> list[str]:
    """Names of the options that are not as they are by default."""
    nothing = np.empty((0, 3))
    options = Options(noise_bound=1)  # which has no default
    defaults = json.loads(register_correspondences(nothing, nothing, options).to_json(options))
    defaults = defaults["options"] | {"noise_bound": None}
    return [
        name
        for name, value in outcome.options.items()
        if name not in defaults or defaults[name] != value
    ]


def weak_rows(outcome: Outcome) -> Rows:
    """What the surfaces determine, and what they leave open."""
    if not outcome.weak_directions:
        return [("determined", "all motions: the surfaces leave none open")]
    return [("left open", direction.words) for direction in outcome.weak_directions]


def distances(scene: Scene) -> str:
    """How far the source lies from the target after alignment."""
    values = scene.distances
    if values is None or not len(values):
        return ""
    middle, most = np.percentile(values, [50, 95])
    return (
        f"Half of the source lies within {middle:.3g} m of a point of the target, 95 % within "
        f"{most:.3g} m; {len(values):,} points"
    )


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


def _rows(outcome: Outcome, about_pose: bool) -> Rows:
    rows: Rows = []
    about = ""
    for line in outcome.report:
        about = line.label or about
        if (about in _POSE) == about_pose and (line.label or about not in _SHOWN_ELSEWHERE):
            rows.append((line.label, line.text))
    return rows


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
