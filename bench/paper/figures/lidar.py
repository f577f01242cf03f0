"""How many LiDAR poses are right to within which error."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from matplotlib import pyplot
from matplotlib.figure import Figure

from paper.figures.registry import figure_of
from paper.figures.style import COLUMN_WIDTH, draw_recall, methods_of, shared_legend
from paper.statistics import errors


@figure_of("lidar", "Share of LiDAR runs whose rotation and translation errors are at most x")
def draw(records: Sequence[dict]) -> Figure:
    figure, (rotation, translation) = pyplot.subplots(
        1, 2, figsize=(COLUMN_WIDTH, 2.4), sharey=True, layout="constrained"
    )
    methods = methods_of(records)
    draw_recall(rotation, partial(errors, name="rotation_deg"), records, methods)
    draw_recall(translation, partial(errors, name="translation"), records, methods)
    rotation.set(xlim=(0, 0.6), ylim=(-3, 103), xlabel="rotation error, degrees", ylabel="runs, %")
    translation.set(xlim=(0, 0.1), xlabel="translation error, m")
    translation.set_xticks([0, 0.05, 0.1])
    shared_legend(figure, rotation)
    return figure
