"""Time and accuracy over the outlier rate, over all N, as in the paper's figure."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.figure import Figure

from paper.figures.registry import figure_of
from paper.figures.style import (
    COLUMN_WIDTH,
    FITS,
    draw_curves,
    methods_of,
    plain_ticks,
    shared_legend,
)
from paper.statistics import errors, quartiles, times_ms


@figure_of(
    "synthetic",
    "Time (a) and mean point error (b) over the outlier rate, all N together; medians; the line is "
    "the largest error of a success",
)
def draw(records: Sequence[dict]) -> Figure:
    figure, (time, error) = pyplot.subplots(
        2, 1, figsize=(COLUMN_WIDTH, 4.4), sharex=True, layout="constrained"
    )
    limit = 1e3 * max(record["time_limit"] for record in records)
    draw_curves(
        time,
        records,
        "outlier_rate",
        time_summary,
        methods_of(records, FITS),
        100,
        limit,
    )
    draw_curves(error, records, "outlier_rate", error_summary, methods_of(records), 100, 10.0)
    time.set(yscale="log", ylabel="(a) time, ms")
    error.set(yscale="log", ylabel="(b) mean point error, m", xlabel="outliers, %")
    plain_ticks(time.yaxis, error.yaxis)
    error.axhline(0.3, color="#555555", linewidth=0.6)
    shared_legend(figure, error, columns=3)
    return figure


def time_summary(records: Sequence[dict]) -> tuple[float, float, float]:
    summary = quartiles(times_ms(records))
    return summary.low, summary.median, summary.high


def error_summary(records: Sequence[dict]) -> tuple[float, float, float]:
    summary = quartiles(errors(records, "mean_point"))
    return summary.low, summary.median, summary.high
