"""The list of all figures, to which each file adds its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from matplotlib.figure import Figure

Draw = Callable[[Sequence[dict]], Figure]

FIGURES: dict[str, tuple[str, Draw]] = {}  # experiment: caption, drawing


def figure_of(experiment: str, caption: str) -> Callable[[Draw], Draw]:
    """Decorator that adds the drawing of an experiment's records to the list."""

    def add(draw: Draw) -> Draw:
        FIGURES[experiment] = (caption, draw)
        return draw

    return add
