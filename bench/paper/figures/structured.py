"""The four panels of the paper's figure on structured outliers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import mean

from matplotlib import pyplot
from matplotlib.figure import Figure
from reports.records import values_of

from paper.figures.registry import figure_of
from paper.figures.style import (
    COLUMN_WIDTH,
    FITS,
    draw_curves,
    methods_of,
    plain_ticks,
    shared_legend,
)
from paper.figures.synthetic import error_summary
from paper.scenarios.synthetic import MAX_MEAN_POINT_ERROR
from paper.statistics import errors, quantile, success_rate

WORST = 10.0  # metres: where errors beyond it are drawn


@figure_of(
    "structured",
    "Structured outliers, N = 90: (a) difference of the median error to random outliers, where "
    "both are successes, (b) mean share of true inliers in the returned consensus set, (c) median "
    "error, (d) success (error < 0.3 m)",
)
def draw(records: Sequence[dict]) -> Figure:
    structured = [record for record in records if record["kind"] == "structured"]
    figure, panels = pyplot.subplots(
        2, 2, figsize=(COLUMN_WIDTH, 3.9), sharex=True, layout="constrained"
    )
    (difference, share), (error, success) = panels
    rivals = methods_of(structured, FITS)
    draw_curves(difference, records, "outlier_rate", difference_summary, rivals, 100)
    draw_curves(share, structured, "outlier_rate", share_summary, rivals, 100)
    draw_curves(
        error, structured, "outlier_rate", error_summary, methods_of(structured), 100, WORST
    )
    draw_curves(success, structured, "outlier_rate", success_summary, rivals, 100, band=False)
    difference.set(title="(a) difference to random, m")
    difference.set_yscale("symlog", linthresh=0.01)
    share.set(title="(b) inliers in consensus, %", ylim=(-3, 103))
    error.set(title="(c) mean point error, m", yscale="log", xlabel="outliers, %")
    error.axhline(MAX_MEAN_POINT_ERROR, color="#555555", linewidth=0.6)
    success.set(title="(d) success, %", ylim=(-3, 103), xlabel="outliers, %")
    error.set_xticks(range(0, 101, 25))
    plain_ticks(error.yaxis, difference.yaxis)
    shared_legend(figure, error)
    return figure


def difference_summary(records: Sequence[dict]) -> tuple[float, float, float]:
    """Median error with structured less that with random outliers, where both are successes."""
    medians = []
    for kind in ("structured", "random"):
        values = errors([record for record in records if record["kind"] == kind], "mean_point")
        median = quantile(values, 0.5)
        medians.append(median if median < MAX_MEAN_POINT_ERROR else math.nan)
    difference = medians[0] - medians[1]
    return difference, difference, difference


def share_summary(records: Sequence[dict]) -> tuple[float, float, float]:
    """Mean inlier share, 0 for a run without a consensus set."""
    shares = values_of(records, "inlier_share")
    middle = 100 * mean([*shares, *[0.0] * (len(records) - len(shares))])
    return middle, middle, middle


def success_summary(records: Sequence[dict]) -> tuple[float, float, float]:
    rate = success_rate(records)
    return 100 * rate.low, 100 * rate.share, 100 * rate.high
