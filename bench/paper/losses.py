"""Where another method beats this library's default, from the records only."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median

from reports.markdown import milliseconds, table
from reports.records import group_by

from paper.figures.style import methods_of
from paper.statistics import success_rate, times_ms
from paper.tables import label_of, of_method

GROUPS = {
    # experiment: fields that split it into groups worth comparing
    "synthetic": ("num_correspondences", "outlier_rate"),
    "structured": ("kind", "outlier_rate"),
    "objects": ("setting",),
    "lidar": ("scan",),
    "real": ("set",),
    "noise": ("set", "bound_factor"),
    "scaling": ("num_correspondences", "outlier_rate"),
}
OURS = "gmcr"
NO_RIVALS = ("gmcr", "gmcr-exact", "least-squares")
MORE_OFTEN, FASTER = "right more often", "as often, faster"
OWN = ("gmcr-count", "gmcr-paper")  # other choices of this library: to be right is what counts


def loss_rows(experiment: str, records: Sequence[dict]) -> list[list[str]]:
    """Groups in which a method is right more often, or a rival as often and faster: a row each."""
    rows = []
    fields = GROUPS[experiment]
    for values, group in sorted(group_by(records, *fields).items()):
        ours = of_method(group, OURS)
        if not ours:
            continue
        place = ", ".join(f"{field} {value}" for field, value in zip(fields, values, strict=True))
        for method in methods_of(group, NO_RIVALS):
            theirs = of_method(group, method)
            cells = _compare(ours, theirs)
            if cells and not (method in OWN and cells[0] == FASTER):
                rows.append([experiment, place, label_of(method), *cells])
    return rows


def _compare(ours: Sequence[dict], theirs: Sequence[dict]) -> list[str]:
    our_share, their_share = success_rate(ours).share, success_rate(theirs).share
    our_time, their_time = median(times_ms(ours)), median(times_ms(theirs))
    more_often = their_share > our_share
    faster = their_share == our_share > 0 and their_time < our_time
    if not (more_often or faster):
        return []
    return [
        MORE_OFTEN if more_often else FASTER,
        f"{100 * their_share:.0f} against {100 * our_share:.0f}",
        f"{milliseconds(their_time)} against {milliseconds(our_time)}",
    ]


def losses(experiments: dict[str, Sequence[dict]]) -> str:
    """Table of all such groups; "" where there is none."""
    rows = [row for name, records in experiments.items() for row in loss_rows(name, records)]
    header = ["experiment", "where", "method", "how", "success %", "median ms"]
    return table(header, rows) if rows else ""
