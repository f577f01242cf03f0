"""Where another method beats this library's default, from the records only."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from reports.markdown import milliseconds, table
from reports.records import group_by

from paper.figures.style import methods_of
from paper.statistics import errors, quantile, success_rate, times_ms
from paper.tables import label_of, number, of_method

GROUPS = {
    # experiment: fields that split it into groups worth comparing, and the error that tells who is
    # more accurate
    "synthetic": (("num_correspondences", "outlier_rate"), "mean_point"),
    "structured": (("kind", "outlier_rate"), "mean_point"),
    "objects": (("setting", "set"), "mean_point"),
    "lidar": (("scan",), "translation"),
    "real": (("set",), "rotation_deg"),
    "noise": (("set", "bound_factor"), "rotation_deg"),
    "scaling": (("num_correspondences", "outlier_rate"), "mean_point"),
}
OURS = "gmcr"
NO_RIVALS = ("gmcr", "gmcr-exact", "least-squares")
OWN = ("gmcr-count", "gmcr-paper")  # of this library: their time is no loss
MORE_ACCURATE = 0.8  # of our median error: what is nearer to ours is not worth a row


@dataclass(frozen=True)
class Summary:
    """What a method reached on a group of problems; medians are over all runs."""

    success: float  # share in [0, 1]
    milliseconds: float
    error: float


def loss_rows(experiment: str, records: Sequence[dict]) -> list[list[str]]:
    """A row for each group and method that beats ours there."""
    rows = []
    fields, error = GROUPS[experiment]
    for values, group in sorted(group_by(records, *fields).items()):
        ours = of_method(group, OURS)
        if not ours:
            continue
        place = ", ".join(f"{field} {value}" for field, value in zip(fields, values, strict=True))
        for method in methods_of(group, NO_RIVALS):
            theirs = of_method(group, method)
            cells = _compare(_summary(ours, error), _summary(theirs, error), method in OWN)
            if cells:
                rows.append([experiment, place, label_of(method), *cells])
    return rows


def _summary(records: Sequence[dict], error: str) -> Summary:
    return Summary(
        success_rate(records).share,
        median(times_ms(records)),
        quantile(errors(records, error), 0.5),
    )


def _compare(ours: Summary, theirs: Summary, is_own: bool) -> list[str]:
    ways = []
    if theirs.success > ours.success:
        ways.append("right more often")
    elif theirs.success == ours.success > 0:
        if theirs.milliseconds < ours.milliseconds and not is_own:
            ways.append("faster")
        if theirs.error < MORE_ACCURATE * ours.error:
            ways.append("more accurate")
    if not ways:
        return []
    return [
        ", ".join(ways),
        f"{100 * theirs.success:.0f} against {100 * ours.success:.0f}",
        f"{milliseconds(theirs.milliseconds)} against {milliseconds(ours.milliseconds)}",
        f"{number(theirs.error)} against {number(ours.error)}",
    ]


def losses(experiments: dict[str, Sequence[dict]]) -> str:
    """Table of all such groups; "" where there is none."""
    rows = [row for name, records in experiments.items() for row in loss_rows(name, records)]
    header = ["experiment", "where", "method", "how", "success %", "median ms", "median error"]
    return table(header, rows) if rows else ""
