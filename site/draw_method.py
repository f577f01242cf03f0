"""Draws the pictures of docs/pictures.md from what the library returns.

site/draw_method.py [FOLDER]    writes them into FOLDER, docs/images by default
"""

from __future__ import annotations

import sys
from pathlib import Path

import gmcr
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure

Floats = npt.NDArray[np.float64]

GOOD, BAD, GREY, BLUE = "#188038", "#c5221f", "#9aa0a6", "#1a73e8"
NOISE_BOUND = 0.02


def problem(num: int, outlier_rate: float, scale: float = 1) -> gmcr.SyntheticProblem:
    """Random points of which some are matched wrongly."""
    return gmcr.make_synthetic(
        num_correspondences=num, outlier_rate=outlier_rate, noise_bound=NOISE_BOUND,
        noise_extent=0.01, seed=3,
        scale_range=(scale, scale),
    )  # fmt: skip


def draw_graph(axes: Axes, outlier_rate: float) -> None:
    """Matches on a circle, those that are right together, and who agrees with whom."""
    made = problem(40, outlier_rate)
    graph = gmcr.consistency_graph(made.source, made.target, noise_bound=NOISE_BOUND)
    order = np.argsort(~made.is_inlier, kind="stable")
    graph, is_right = graph[np.ix_(order, order)], made.is_inlier[order]
    angles = np.linspace(0, 2 * np.pi, len(graph), endpoint=False)
    places = np.column_stack([np.cos(angles), np.sin(angles)])
    for both, colour in ((False, GREY), (True, GOOD)):
        pairs = [
            (places[i], places[j])
            for i, j in zip(*np.nonzero(np.triu(graph)), strict=True)
            if (is_right[i] and is_right[j]) == both
        ]
        axes.add_collection(LineCollection(pairs, colors=colour, linewidths=0.6, alpha=0.7))
    axes.scatter(places[:, 0], places[:, 1], c=np.where(is_right, GOOD, BAD), s=26, zorder=3)
    result = gmcr.register_correspondences(made.source, made.target, noise_bound=NOISE_BOUND)
    axes.set_title(
        f"{outlier_rate:.0%} wrong: {int(is_right.sum())} right, {len(result.inliers)} found"
    )
    axes.set_aspect("equal")
    axes.axis("off")


def scale_votes(made: gmcr.SyntheticProblem, scales: Floats) -> Floats:
    """How many pairs of matches can be right at each scale."""
    i, j = np.triu_indices(len(made.source), 1)
    before = np.linalg.norm(made.source[i] - made.source[j], axis=1)
    after = np.linalg.norm(made.target[i] - made.target[j], axis=1)
    low, high = (after - 2 * NOISE_BOUND) / before, (after + 2 * NOISE_BOUND) / before
    begun = np.searchsorted(np.sort(low), scales, side="right")
    ended = np.searchsorted(np.sort(high), scales, side="left")
    votes: Floats = (begun - ended).astype(float)
    return votes


def draw_sweep(axes: Axes, outlier_rate: float) -> None:
    """The votes over the scale, and the scale of the answer."""
    made = problem(200, outlier_rate, scale=2)
    scales = np.linspace(0.2, 4, 2000)
    axes.plot(scales, scale_votes(made, scales), color=BLUE, lw=1)
    result = gmcr.register_correspondences(
        made.source, made.target, noise_bound=NOISE_BOUND, scale_mode="estimated"
    )
    axes.axvline(result.scale, color=GOOD, lw=1, ls="--")
    axes.set_title(f"{outlier_rate:.0%} wrong: scale {result.scale:.3f}")
    axes.set_xlabel("scale")
    axes.set_ylabel("pairs that agree")


def draw_certificate(axes: Axes) -> None:
    """The largest consensus that was found, and how many inliers are not excluded above it."""
    rates = [0.5, 0.7, 0.8, 0.9]
    places = np.arange(len(rates))
    for shift, certify, colour in ((-0.18, False, GREY), (0.18, True, GOOD)):
        bounds = []
        for rate in rates:
            made = gmcr.make_synthetic(
                num_correspondences=120,
                outlier_rate=rate,
                noise_bound=0.2,
                noise_extent=0.2,
                seed=3,
            )
            result = gmcr.register_correspondences(
                made.source, made.target, noise_bound=0.2, evidence="count", certify=certify
            )
            bounds.append((result.certificate.lower, result.certificate.upper))
        lower, upper = np.transpose(bounds)
        label = "with certify" if certify else "as it comes"
        axes.bar(places + shift, lower, 0.32, color=colour, label=f"found, {label}")
        axes.errorbar(
            places + shift, lower, [0 * lower, upper - lower], fmt="none", ecolor=BAD, capsize=4,
            label=None if certify else "what is not excluded",
        )  # fmt: skip
    axes.set_xticks(places, [f"{rate:.0%}" for rate in rates])
    axes.set_xlabel("wrong, of 120, noise of a fifth of the radius")
    axes.set_ylabel("inliers")
    axes.legend(frameon=False)


def copies() -> tuple[Floats, Floats, npt.NDArray[np.bool_]]:
    """8 right matches, and 14 wrong ones that are three wrong matches said again and again."""
    random = np.random.default_rng(5)
    right = random.uniform(-1, 1, (8, 3))
    seen = random.uniform(-1, 1, (3, 3))
    turn = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    moved = seen @ turn.T + [0.5, -0.3, 0.8]  # the three agree with each other on a wrong pose
    copy = np.arange(14) % 3
    jitter = random.uniform(-1, 1, (2, 14, 3)) * 0.004
    source = np.vstack([right, seen[copy] + jitter[0]])
    target = np.vstack([right + np.array([0.1, 0.2, 0.3]), moved[copy] + jitter[1]])
    return source, target, np.arange(22) < 8


def draw_copies(axes: Axes) -> None:
    """Which matches the pose holds, by count and by distinct evidence."""
    source, target, is_right = copies()
    bars = {}
    for evidence in ("count", "distinct"):
        result = gmcr.register_correspondences(
            source,
            target,
            noise_bound=NOISE_BOUND,
            evidence=evidence,
        )
        held = is_right[result.inliers]
        bars[evidence] = (int(held.sum()), int((~held).sum()), result.evidence)
    for place, (right, wrong, _) in enumerate(bars.values()):
        axes.barh(place, right, color=GOOD)
        axes.barh(place, wrong, left=right, color=BAD)
    axes.set_yticks(
        range(len(bars)), [f"evidence='{name}'\n{row[2]:.1f} votes" for name, row in bars.items()]
    )
    axes.set_xlabel("matches that the returned pose holds (right: green, wrong: red)")


def write(figure: Figure, path: Path) -> None:
    """Saves a figure, and forgets it."""
    figure.savefig(path, dpi=110, bbox_inches="tight", metadata={"Software": None})
    plt.close(figure)
    print(path)


def draw_all(folder: Path) -> None:
    """Writes every picture of the page."""
    figure, axes = plt.subplots(1, 3, figsize=(12, 4.2))
    for place, rate in zip(axes, (0.1, 0.5, 0.9), strict=True):
        draw_graph(place, rate)
    write(figure, folder / "method_graph.png")
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.2), layout="constrained")
    for place, rate in zip(axes, (0.1, 0.5, 0.9), strict=True):
        draw_sweep(place, rate)
    write(figure, folder / "method_scale.png")
    for draw, name, size in (
        (draw_certificate, "method_certificate.png", (7.5, 3.6)),
        (draw_copies, "method_copies.png", (7.5, 2.2)),
    ):
        figure, place = plt.subplots(figsize=size, layout="constrained")
        draw(place)
        write(figure, folder / name)


if __name__ == "__main__":
    draw_all(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parents[1] / "docs/images")
