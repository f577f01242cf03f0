"""Recall over the noise bound that the methods are told."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib import pyplot
from matplotlib.figure import Figure

from paper.figures.real import TITLES
from paper.figures.registry import figure_of
from paper.figures.structured import success_summary
from paper.figures.style import COLUMN_WIDTH, FITS, draw_curves, methods_of, shared_legend


@figure_of("noise", "Pairs registered over the noise bound, as a multiple of the customary one")
def draw(records: Sequence[dict]) -> Figure:
    figure, panels = pyplot.subplots(
        1, 2, figsize=(COLUMN_WIDTH, 2.5), sharey=True, layout="constrained"
    )
    for panel, (set_name, title) in zip(panels, TITLES.items(), strict=True):
        group = [record for record in records if record["set"] == set_name]
        draw_curves(panel, group, "bound_factor", success_summary, methods_of(group, FITS))
        panel.set(title=title, xscale="log", xlabel="noise bound / customary", ylim=(-4, 104))
        factors = sorted({record["bound_factor"] for record in group})
        panel.set_xticks(factors, [f"{factor:g}" for factor in factors])
        panel.minorticks_off()
    panels[0].set_ylabel("success, %")
    shared_legend(figure, panels[0])
    return figure
