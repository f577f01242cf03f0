"""Plotly figures of a scene."""

from __future__ import annotations

from base64 import b64encode
from typing import Any

import numpy as np
import numpy.typing as npt
import plotly.graph_objects as go  # type: ignore[import-untyped]

from .colours import BOUND, INLIER, OUTLIER, SOURCE, TARGET, WEAK
from .outcome import OtherPose, Outcome, WeakDirection
from .scene import Sample, Scene, weak_segment
from .words import duration

# Shares of the motion at which the slider stops: each holds a copy of the source.
_STOPS = (0.0, 0.2, 0.4, 0.6, 0.8, 1.0)
_SOURCE, _TARGET, _INLIERS, _OUTLIERS = range(4)
_FEW = 3000  # points of a cloud in a small picture


def clouds_figure(outcome: Outcome, scene: Scene) -> go.Figure:
    """Both clouds and the correspondences, with a slider from before to after.

    Parameters
    ----------
    outcome, scene : Outcome, Scene
        What to show.

    Returns
    -------
    plotly.graph_objects.Figure
        Four traces: source, target, inliers, outliers, and one for each motion that the surfaces
        leave open; a click in the legend hides one.
    """
    end = 1.0 if outcome.has_pose else 0.0
    figure = go.Figure(
        [
            _points(_moved(scene, end), f"source: {scene.source_points.words('points')}", SOURCE),
            _points(scene.target_cloud, f"target: {scene.target_points.words('points')}", TARGET),
            _lines(scene, scene.inliers, end, scene.inliers.words("inliers"), INLIER, 3, 0.9),
            _lines(scene, scene.outliers, end, scene.outliers.words("outliers"), OUTLIER, 1, 0.5),
        ]
    )
    for direction in outcome.weak_directions:
        figure.add_trace(_weak_line(scene, direction))
    _as_space(figure, 640)
    if outcome.has_pose:
        figure.update_layout(sliders=[_slider(scene)])
    return figure


def distances_figure(scene: Scene) -> go.Figure | None:
    """The source after alignment, each point in the colour of its distance from the target."""
    if scene.distances is None or not len(scene.distances):
        return None
    points = scene.motion.apply(scene.source_cloud[scene.measured.indices]).astype(np.float32)
    figure = go.Figure(
        go.Scatter3d(
            **_xyz(points),
            mode="markers",
            marker={
                "size": _marker_size(len(points)),
                "color": scene.distances,
                "colorscale": "Viridis",
                "cmin": 0,
                "cmax": float(np.percentile(scene.distances, 95)) or 1.0,
                "colorbar": {"title": "m", "thickness": 12, "x": 1},
            },
            hovertemplate="%{marker.color:.3g} m<extra></extra>",
        )
    )
    return _as_space(figure, 420)


def pose_figure(scene: Scene, pose: OtherPose) -> go.Figure:
    """Both clouds under another pose, without correspondences."""
    chosen = slice(None, None, max(1, len(scene.source_cloud) // _FEW))
    moved = scene.moved_by(pose).motion.apply(scene.source_cloud[chosen])
    others = scene.target_cloud[:: max(1, len(scene.target_cloud) // _FEW)]
    figure = go.Figure([_points(moved, "source", SOURCE), _points(others, "target", TARGET)])
    return _as_space(figure, 300).update_layout(showlegend=False)


def _as_space(figure: go.Figure, height: int) -> go.Figure:
    """The layout of a picture in three dimensions."""
    figure.update_layout(
        template="plotly_white",
        height=height,
        margin={"l": 0, "r": 0, "t": 0, "b": 0},
        scene={"aspectmode": "data", "camera": {"eye": {"x": 1.1, "y": 1.1, "z": 0.85}}},
        legend={"itemsizing": "constant", "x": 0.01, "y": 0.99, "bgcolor": "rgba(255,255,255,0.7)"},
    )
    return figure


def _weak_line(scene: Scene, direction: WeakDirection) -> go.Scatter3d:
    return go.Scatter3d(
        **_xyz(weak_segment(scene, direction)),
        mode="lines+markers",
        line={"color": WEAK, "width": 6},
        marker={"size": 4, "color": WEAK},
        name=f"left open: {direction.words}",
        hoverinfo="name",
    )


def residuals_figure(outcome: Outcome, scene: Scene) -> go.Figure:
    """Histogram of the residuals of all correspondences on logarithmic axes."""
    values, unit = _histogram_values(scene)
    limit = _histogram_limit(scene)
    positive = values[values > 0]
    least = max(float(positive.min()) if len(positive) else 1e-9, 1e-9 * values.max(initial=1e-9))
    # 8 bins a decade, one edge at the bound, so that no bin holds inliers and outliers
    anchor = limit if limit is not None else 1.0
    lowest, highest = (np.log10(value / anchor) * 8 for value in (least, values.max(initial=least)))
    exponents = np.arange(np.floor(lowest), np.ceil(highest + 1e-9) + 1)
    edges = anchor * 10 ** (exponents / 8)
    is_inlier = np.zeros(len(values), dtype=bool)
    is_inlier[outcome.inliers] = True
    figure = go.Figure()
    for name, chosen, colour in (("inliers", is_inlier, INLIER), ("outliers", ~is_inlier, OUTLIER)):
        counts = np.histogram(np.clip(values[chosen], edges[0], edges[-1]), edges)[0]
        figure.add_bar(
            x=np.sqrt(edges[:-1] * edges[1:]),
            y=counts,
            width=0.92 * np.diff(edges),
            name=f"{int(chosen.sum()):,} {name}",
            marker_color=colour,
            customdata=np.column_stack([edges[:-1], edges[1:]]),
            hovertemplate="%{y} from %{customdata[0]:.3g} to %{customdata[1]:.3g}<extra></extra>",
        )
    if limit is not None:
        label = f"noise bound {limit:.4g} m" if unit == "m" else "noise bound"
        figure.add_vline(x=limit, line={"color": BOUND, "dash": "dash"})
        figure.add_annotation(
            x=np.log10(limit),
            y=1.0,
            yref="paper",
            text=label,
            showarrow=False,
            yanchor="bottom",
        )
    axis = "residual, m" if unit == "m" else "residual / noise bound"
    figure.update_xaxes(type="log", title=axis, exponentformat="power")
    figure.update_yaxes(type="log", title="correspondences", range=_log_counts(figure), dtick=1)
    return _chart(figure, barmode="overlay")


def stages_figure(outcome: Outcome) -> go.Figure:
    """Time of each stage."""
    names = list(outcome.stages)
    milliseconds = [1000 * seconds for seconds in outcome.stages.values()]
    figure = go.Figure(
        go.Bar(
            x=milliseconds,
            y=names,
            orientation="h",
            marker_color=TARGET,
            text=[duration(seconds) for seconds in outcome.stages.values()],
            textposition="outside",
            cliponaxis=False,
            hovertemplate="%{y}: %{x:.4g} ms<extra></extra>",
        )
    )
    figure.update_yaxes(autorange="reversed", automargin=True)
    figure.update_xaxes(title="ms", range=[0, 1.25 * max(milliseconds, default=1.0)])
    return _chart(figure, height=120 + 30 * len(names))


def graph_figure(scene: Scene) -> go.Figure | None:
    """Adjacency of the consensus graph, the inliers first; None where it is not known."""
    if scene.graph is None:
        return None
    graph = scene.graph
    k, n = len(graph.inliers.indices), len(graph.adjacency)
    shade = graph.adjacency.astype(np.int8)
    shade[:k, :k] *= 2
    shade[np.diag_indices(n)] = 0
    vertices = np.concatenate([graph.inliers.indices, graph.outliers.indices])
    colours = [[0, "#ffffff"], [0.5, OUTLIER], [1, INLIER]]
    figure = go.Figure(
        go.Heatmap(
            z=shade,
            zmin=0,
            zmax=2,
            colorscale=colours,
            showscale=False,
            customdata=np.stack(np.meshgrid(vertices, vertices), axis=-1),
            hovertemplate="%{customdata[0]} and %{customdata[1]}<extra></extra>",
        )
    )
    axis: dict[str, Any] = {
        "tickvals": [(k - 1) / 2, (k + n - 1) / 2],
        "ticktext": [graph.inliers.words("inliers"), graph.outliers.words("outliers")],
        "showgrid": False,
        "zeroline": False,
        "constrain": "domain",
        "range": [-0.5, n - 0.5],
        "linecolor": "#999",
        "mirror": True,
    }
    figure.update_xaxes(**axis)
    figure.update_yaxes(**{**axis, "range": [n - 0.5, -0.5]}, scaleanchor="x", tickangle=-90)
    figure.add_vline(x=k - 0.5, line={"color": "#999", "width": 1})
    figure.add_hline(y=k - 0.5, line={"color": "#999", "width": 1})
    return _chart(figure)


def _chart(figure: go.Figure, **layout: Any) -> go.Figure:
    legend = {"orientation": "h", "y": -0.2, "yanchor": "top", "x": 0.5, "xanchor": "center"}
    figure.update_layout(
        template="plotly_white", margin={"l": 60, "r": 20, "t": 30, "b": 50}, legend=legend
    )
    figure.update_layout(**{"height": 400, **layout})
    return figure


def _moved(scene: Scene, share: float) -> npt.NDArray[np.float32]:
    return scene.motion.apply(scene.source_cloud, share).astype(np.float32)


def _xyz(points: npt.NDArray[Any]) -> dict[str, npt.NDArray[Any]]:
    return {axis: np.ascontiguousarray(points[:, i]) for i, axis in enumerate("xyz")}


def _encoded(values: npt.NDArray[np.float32]) -> dict[str, str]:
    # plotly encodes the arrays of traces like this, but not those of sliders
    return {"dtype": "f4", "bdata": b64encode(values.astype("<f4").tobytes()).decode("ascii")}


def _marker_size(num_points: int) -> float:
    return 4.0 if num_points < 500 else 2.5 if num_points < 5000 else 1.3


def _points(points: npt.NDArray[Any], name: str, colour: str) -> go.Scatter3d:
    return go.Scatter3d(
        **_xyz(points.astype(np.float32)),
        mode="markers",
        marker={"size": _marker_size(len(points)), "color": colour},
        name=name,
        hovertemplate="(%{x:.4g}, %{y:.4g}, %{z:.4g})<extra>" + name.split(":")[0] + "</extra>",
    )


def _segments(scene: Scene, sample: Sample, share: float) -> npt.NDArray[np.float32]:
    starts, ends = scene.links(sample, share)
    gaps = np.full_like(ends, np.nan)
    return np.stack([starts, ends, gaps], axis=1).reshape(-1, 3).astype(np.float32)


def _lines(
    scene: Scene, sample: Sample, share: float, name: str, colour: str, width: int, opacity: float
) -> go.Scatter3d:
    return go.Scatter3d(
        **_xyz(_segments(scene, sample, share)),
        mode="lines",
        line={"color": colour, "width": width},
        opacity=opacity,
        name=name,
        hoverinfo="skip",
    )


def _slider(scene: Scene) -> dict[str, Any]:
    moving = [_SOURCE, _INLIERS, _OUTLIERS]
    steps = []
    for stop in _STOPS:
        parts = [
            _xyz(_moved(scene, stop)),
            _xyz(_segments(scene, scene.inliers, stop)),
            _xyz(_segments(scene, scene.outliers, stop)),
        ]
        change = {axis: [_encoded(part[axis]) for part in parts] for axis in "xyz"}
        label = {0.0: "before", 1.0: "after"}.get(stop, f"{100 * stop:.0f} %")
        steps.append({"method": "restyle", "label": label, "args": [change, moving]})
    return {
        "steps": steps,
        "active": len(steps) - 1,
        "currentvalue": {"visible": False},
        "pad": {"l": 40, "r": 40, "t": 10, "b": 20},
    }


def _histogram_values(scene: Scene) -> tuple[npt.NDArray[np.float64], str]:
    if scene.bounds is None or np.ptp(scene.bounds) == 0:
        return scene.residuals, "m"
    return scene.residuals / scene.bounds, "bounds"


def _histogram_limit(scene: Scene) -> float | None:
    if scene.bounds is None or len(scene.bounds) == 0:
        return None
    return float(scene.bounds[0]) if np.ptp(scene.bounds) == 0 else 1.0


def _log_counts(figure: go.Figure) -> list[float]:
    most = max((int(max(bar.y, default=1)) for bar in figure.data), default=1)
    return [np.log10(0.6), np.log10(max(most, 1) * 1.6)]
