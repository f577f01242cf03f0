"""How many poses of objects are right to within which error."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.figure import Figure

from paper.figures.registry import figure_of
from paper.figures.style import COLUMN_WIDTH, draw_recall, methods_of, plain_ticks, shared_legend
from paper.scenarios.objects import MAX_SHARE_OF_DIAMETER
from paper.statistics import errors

TITLES = {"random": "random 50 %", "structured": "structured 50 %", "fpfh": "FPFH matches"}


@figure_of(
    "objects",
    "Share of runs whose mean point error (ADD) is at most x per cent of the object's diameter; "
    "the line is the largest of a success",
)
def draw(records: Sequence[dict]) -> Figure:
    figure, panels = pyplot.subplots(
        1, 3, figsize=(COLUMN_WIDTH, 2.3), sharey=True, layout="constrained"
    )
    methods = methods_of(records)
    for panel, (setting, title) in zip(panels, TITLES.items(), strict=True):
        mine = [record for record in records if record["setting"] == setting]
        draw_recall(panel, errors_in_percent, mine, methods)
        panel.axvline(100 * MAX_SHARE_OF_DIAMETER, color="#555555", linewidth=0.6)
        panel.set(title=title, xscale="log", xlim=(0.05, 30), ylim=(-3, 103))
        plain_ticks(panel.xaxis)
    panels[0].set_ylabel("runs, %")
    panels[1].set_xlabel("ADD, % of diameter")
    shared_legend(figure, panels[0])
    return figure


def errors_in_percent(records: Sequence[dict]) -> list[float]:
    """ADD over the diameter, which the criterion is a share of."""
    diameters = [record["criterion"]["mean_point"] / MAX_SHARE_OF_DIAMETER for record in records]
    return [100 * e / d for e, d in zip(errors(records, "mean_point"), diameters, strict=True)]
