"""One look for all figures: at column width, told apart in grey by markers and dashes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from io import BytesIO
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter
from PIL import Image
from paper.methods import look_of
from reports.records import group_by

COLUMN_WIDTH = 3.5  # inches
FITS = ("least-squares",)  # to inliers that are known: no search to be compared

pyplot.rcParams.update(
    {
        "font.size": 7,
        "axes.titlesize": 7,
        "axes.labelsize": 7,
        "legend.fontsize": 6.5,
        "xtick.labelsize": 6.5,
        "ytick.labelsize": 6.5,
        "lines.linewidth": 1.0,
        "lines.markersize": 3.2,
        "axes.grid": True,
        "grid.alpha": 0.3,
        "grid.linewidth": 0.4,
        "axes.linewidth": 0.6,
    }
)

Summary = Callable[[Sequence[dict]], tuple[float, float, float]]  # low, middle, high


def methods_of(records: Iterable[dict], but: Iterable[str] = ()) -> list[str]:
    """Methods of the records in the order of the legend."""
    present = {record["method"] for record in records} - set(but)
    return sorted(present, key=lambda name: (look_of(name).place, name))


def line_style(method: str) -> dict:
    look = look_of(method)
    return {
        "label": look.label,
        "color": look.colour,
        "marker": look.marker or None,
        "linestyle": look.dashes,
        "zorder": 4 if method == "gmcr" else 3,
    }


def draw_curves(
    axis: Axes,
    records: Sequence[dict],
    field: str,
    summary: Summary,
    methods: Sequence[str],
    factor: float = 1.0,
    ceiling: float = math.inf,
    band: bool = False,
) -> None:
    """A curve a method over a field of the records.

    The summary gives low, middle and high of the records of one point; `factor` multiplies the
    field's values, such as 100 for per cent. Values beyond the ceiling, infinity too, are drawn at
    it, and infinite ones not at all without one. A band is the shade from low to high.
    """
    for method in methods:
        mine = [record for record in records if record["method"] == method]
        places, lows, middles, highs = [], [], [], []
        for (value,), group in sorted(group_by(mine, field).items()):
            low, middle, high = (min(x, ceiling) for x in summary(group))
            if math.isfinite(middle):
                places.append(factor * value)
                lows.append(low)
                middles.append(middle)
                highs.append(high if math.isfinite(high) else middle)
        style = line_style(method)
        axis.plot(places, middles, **style)
        if band:
            axis.fill_between(places, lows, highs, color=style["color"], alpha=0.12, linewidth=0)


def draw_recall(
    axis: Axes,
    values: Callable[[list[dict]], list[float]],
    records: Sequence[dict],
    methods: Sequence[str],
) -> None:
    """Share of the runs, in per cent, whose error is at most x, a step curve a method."""
    for method in methods:
        mine = [record for record in records if record["method"] == method]
        finite = sorted(value for value in values(mine) if math.isfinite(value))
        shares = [100 * (k + 1) / len(mine) for k in range(len(finite))]
        style = line_style(method) | {"markevery": max(1, len(finite) // 6)}
        last = shares[-1] if shares else 0
        axis.plot([1e-9, *finite, 1e9], [0, *shares, last], drawstyle="steps-post", **style)


def shared_legend(figure: Figure, axis: Axes, columns: int = 3) -> None:
    """One legend below all panels."""
    handles, labels = axis.get_legend_handles_labels()
    figure.legend(
        handles,
        labels,
        loc="outside lower center",
        ncols=columns,
        frameon=False,
        handlelength=2.8,
        columnspacing=1.0,
    )


def plain_ticks(*axes: Axis) -> None:
    """Labels of logarithmic axes as plain numbers, at the decades only."""
    for axis in axes:
        axis.set_major_formatter("{x:g}")
        axis.set_minor_formatter(NullFormatter())


def save(figure: Figure, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    pixels = BytesIO()
    figure.savefig(pixels, dpi=200)
    pyplot.close(figure)
    # a palette, since the pictures are kept in the repository
    Image.open(pixels).convert("RGB").quantize(256).save(path, optimize=True)
