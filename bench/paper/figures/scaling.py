"""Time against the number of matches and against the outlier rate."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from reports.records import group_by

from paper.figures.registry import figure_of
from paper.figures.style import (
    COLUMN_WIDTH,
    FITS,
    draw_curves,
    line_style,
    methods_of,
    plain_ticks,
    shared_legend,
)
from paper.figures.synthetic import time_summary
from paper.scenarios.scaling import RATES_SIZE, SIZE_RATES
from paper.statistics import success_rate


@figure_of(
    "scaling",
    "Time against N at two outlier rates (a, b) and against the outlier rate at N = 1,000 (c), "
    "known scale; hollow: most runs are wrong or were ended at the time limit",
)
def draw(records: Sequence[dict]) -> Figure:
    figure, panels = pyplot.subplots(3, 1, figsize=(COLUMN_WIDTH, 5.6), layout="constrained")
    for panel, rate, letter in zip(panels[:2], SIZE_RATES, "ab", strict=True):
        mine = [record for record in records if record["outlier_rate"] == rate]
        _draw_times(panel, mine, "num_correspondences")
        panel.set(xscale="log", title=f"({letter}) {100 * rate:g} % outliers", xlabel="N")
        sizes = sorted({record["num_correspondences"] for record in mine})
        panel.set_xticks(sizes, [f"{size:,}" for size in sizes])
        panel.minorticks_off()
    mine = [record for record in records if record["num_correspondences"] == RATES_SIZE]
    _draw_times(panels[2], mine, "outlier_rate", 100)
    panels[2].set(title=f"(c) N = {RATES_SIZE:,}", xlabel="outliers, %")
    shared_legend(figure, panels[0])
    return figure


def _draw_times(axis: Axes, records: Sequence[dict], field: str, factor: float = 1.0) -> None:
    methods = methods_of(records, FITS)
    limit = 1e3 * max(record["time_limit"] for record in records)
    draw_curves(axis, records, field, time_summary, methods, factor, limit)
    for method in methods:
        mine = [record for record in records if record["method"] == method]
        for (value,), group in group_by(mine, field).items():
            if success_rate(group).share < 0.5:
                time = min(time_summary(group)[1], limit)
                style = line_style(method) | {"label": None, "zorder": 5}
                axis.plot(factor * value, time, markerfacecolor="white", **style)
    axis.set(yscale="log", ylabel="time, ms")
    plain_ticks(axis.yaxis)
