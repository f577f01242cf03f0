"""Recall against time on the real matches."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.figure import Figure

from paper.figures.registry import figure_of
from paper.figures.style import (
    COLUMN_WIDTH,
    FITS,
    line_style,
    methods_of,
    plain_ticks,
    shared_legend,
)
from paper.statistics import quartiles, success_rate, times_ms

TITLES = {"kitti_fpfh": "KITTI, FPFH", "gore": "GORE, PFH"}


@figure_of(
    "real",
    "Real matches: success with its Wilson interval against time (median and quartiles); "
    "time-outs count as the time limit",
)
def draw(records: Sequence[dict]) -> Figure:
    figure, panels = pyplot.subplots(
        1, 2, figsize=(COLUMN_WIDTH, 2.5), sharex=True, sharey=True, layout="constrained"
    )
    for panel, (set_name, title) in zip(panels, TITLES.items(), strict=True):
        group = [record for record in records if record["set"] == set_name]
        for method in methods_of(group, FITS):
            mine = [record for record in group if record["method"] == method]
            limit = 1e3 * mine[0]["time_limit"]
            time = quartiles([min(value, limit) for value in times_ms(mine)])
            rate = success_rate(mine)
            style = line_style(method) | {"linestyle": "none"}
            panel.errorbar(
                time.median,
                100 * rate.share,
                xerr=[[time.median - time.low], [time.high - time.median]],
                yerr=[
                    [100 * max(rate.share - rate.low, 0)],
                    [100 * max(rate.high - rate.share, 0)],
                ],
                elinewidth=0.5,
                **style,
            )
        panel.set(title=title, xscale="log", xlabel="time, ms", ylim=(-4, 104))
        plain_ticks(panel.xaxis)
    panels[0].set_ylabel("success, %")
    shared_legend(figure, panels[0])
    return figure
