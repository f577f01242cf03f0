"""The interactive page of a scene, served by viser."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import viser

from . import words
from .colours import BOUND, INLIER, OUTLIER, SOURCE, TARGET, WEAK, rgb, shades
from .outcome import Outcome
from .scene import Sample, Scene, weak_segment

# Edges of the consensus graph that are drawn; what is left out is said.
_MAX_EDGES = 2000
# Pixels.
_DETAILS_WIDTH = 400
_MAIN_WIDTH = 340
_MARGIN = 12
# Width over height of a picture in which the camera sees the target from where it stands.
_WIDE = 0.8


def serve(outcome: Outcome, scene: Scene, host: str, port: int) -> viser.ViserServer:
    """Starts a server in the background whose page shows the scene.

    Parameters
    ----------
    outcome, scene : Outcome, Scene
        What to show.
    host : str
        Address to listen on.
    port : int
        Port; the next free one where it is taken.

    Returns
    -------
    viser.ViserServer
        Nodes ``/source``, ``/target``, ``/inliers``, ``/outliers`` and ``/consensus_graph``.
    """
    server = viser.ViserServer(host=host, port=port, label="gmcr", verbose=False)
    size = _extent(scene)
    nodes = _add_nodes(server, scene, 1.0 if outcome.has_pose else 0.0, size)
    _add_weak_directions(server, outcome, scene, nodes)
    server.gui.add_markdown(f"**{words.headline(outcome).text}** {words.reason(outcome)}")
    if outcome.has_pose:
        _add_poses(server, outcome, scene, nodes)
    with _details(server):
        server.gui.add_markdown(_summary(outcome, scene))
        boxes = _add_toggles(server, nodes)
        _add_distances(server, scene, nodes["source"].point_size, boxes["source"])
    _look_at_target(server, scene, size)
    return server


def _details(server: viser.ViserServer) -> viser.GuiTabHandle:
    """Where all but the verdict and the motion stands: beside the scene, on phones behind a bar.

    There viser opens its main panel over the scene, up to three fifths of it and whatever the
    server says, and other panels only when touched. So the main one is kept short; elsewhere it
    floats in the corner.
    """
    server.gui.main_panel.float(x=_MARGIN, y=_MARGIN, width=_MAIN_WIDTH)
    details = server.gui.add_panel()
    details.dock_right()
    details.set_width(_DETAILS_WIDTH)
    return details.add_tab("Details")


def _extent(scene: Scene) -> float:
    extents = [np.ptp(cloud, axis=0).max() for cloud in _clouds(scene) if len(cloud)]
    return float(max(extents, default=1.0)) or 1.0


def _clouds(scene: Scene) -> tuple[npt.NDArray[Any], npt.NDArray[Any]]:
    return scene.motion.apply(scene.source_cloud), scene.target_cloud


def _segments(scene: Scene, sample: Sample, share: float) -> npt.NDArray[np.float32]:
    return np.stack(scene.links(sample, share), axis=1).astype(np.float32)


def _graph_edges(scene: Scene) -> tuple[npt.NDArray[np.float32], Sample]:
    """Segments, (m, 2, 3), between the target points of consistent pairs."""
    if scene.graph is None:
        return np.empty((0, 2, 3), dtype=np.float32), Sample(np.empty(0, dtype=np.int64), 0)
    vertices = np.concatenate([scene.graph.inliers.indices, scene.graph.outliers.indices])
    pairs = np.argwhere(np.triu(scene.graph.adjacency))
    kept = np.arange(len(pairs))
    if len(pairs) > _MAX_EDGES:
        kept = np.sort(np.random.default_rng(0).choice(len(pairs), _MAX_EDGES, replace=False))
    segments = scene.target[vertices[pairs[kept]]].astype(np.float32)
    return segments, Sample(kept, len(pairs))


def _add_nodes(
    server: viser.ViserServer, scene: Scene, share: float, size: float
) -> dict[str, Any]:
    nodes: dict[str, Any] = {}
    moved = scene.motion.apply(scene.source_cloud, share)
    for name, points, colour in (
        ("source", moved, SOURCE),
        ("target", scene.target_cloud, TARGET),
    ):
        nodes[name] = server.scene.add_point_cloud(
            f"/{name}",
            points.astype(np.float32),
            rgb(colour),
            point_size=size / 500,
            precision="float32",
        )
    edges, _ = _graph_edges(scene)
    for name, segments, colour, width in (
        ("inliers", _segments(scene, scene.inliers, share), INLIER, 2.0),
        ("outliers", _segments(scene, scene.outliers, share), OUTLIER, 1.0),
        ("consensus_graph", edges, BOUND, 1.0),
    ):
        if len(segments):
            nodes[name] = server.scene.add_line_segments(
                f"/{name}", segments, rgb(colour), thickness=width, thickness_units="screen"
            )
    for name in ("outliers", "consensus_graph"):
        if name in nodes:
            nodes[name].visible = False
    return nodes


def _add_weak_directions(
    server: viser.ViserServer, outcome: Outcome, scene: Scene, nodes: dict[str, Any]
) -> None:
    if not outcome.weak_directions:
        return
    segments = [weak_segment(scene, direction) for direction in outcome.weak_directions]
    nodes["left_open"] = server.scene.add_line_segments(
        "/left_open",
        np.array(segments, dtype=np.float32),
        rgb(WEAK),
        thickness=4.0,
        thickness_units="screen",
    )


def _add_poses(
    server: viser.ViserServer, outcome: Outcome, scene: Scene, nodes: dict[str, Any]
) -> None:
    """The way of the source, and where there are other poses, which one it goes to."""
    slider = server.gui.add_slider("before / after", 0.0, 1.0, 0.01, 1.0)
    scenes = {f"returned: {outcome.consensus}": scene}
    for index, pose in enumerate(outcome.others, 1):
        scenes[f"{index}: {pose.words}"] = scene.moved_by(pose)
    choice = server.gui.add_dropdown("pose", tuple(scenes)) if outcome.others else None

    def move(_: object) -> None:
        chosen = scenes[choice.value] if choice else scene
        share = float(slider.value)
        nodes["source"].points = chosen.motion.apply(scene.source_cloud, share).astype(np.float32)
        for name, sample in (("inliers", scene.inliers), ("outliers", scene.outliers)):
            if name in nodes:
                nodes[name].points = _segments(chosen, sample, share)

    slider.on_update(move)
    if choice:
        choice.on_update(move)


def _add_distances(
    server: viser.ViserServer, scene: Scene, point_size: float, source_box: Any
) -> None:
    """The source in the colours of its distances from the target, after alignment."""
    if scene.distances is None or not len(scene.distances):
        return
    colours = shades(scene.distances, float(np.percentile(scene.distances, 95)))
    node = server.scene.add_point_cloud(
        "/distances",
        scene.motion.apply(scene.source_cloud[scene.measured.indices]).astype(np.float32),
        colours,
        point_size=2 * point_size,
        precision="float32",
    )
    node.visible = False
    box = server.gui.add_checkbox("distances", False)

    @box.on_update
    def toggle(_: object) -> None:
        node.visible = bool(box.value)
        source_box.value = not box.value  # in its place


def _add_toggles(server: viser.ViserServer, nodes: dict[str, Any]) -> dict[str, Any]:
    """A box for each node, by its name, and one size for the points."""
    boxes = {name: _add_toggle(server, name.replace("_", " "), nodes[name]) for name in nodes}
    point_size = server.gui.add_slider("point size", 0.1, 5.0, 0.1, 1.0)
    unit = nodes["source"].point_size

    @point_size.on_update
    def resize(_: object) -> None:
        for name in ("source", "target"):
            nodes[name].point_size = unit * float(point_size.value)

    return boxes


def _add_toggle(server: viser.ViserServer, label: str, node: Any) -> Any:
    box = server.gui.add_checkbox(label, bool(node.visible))

    @box.on_update
    def toggle(_: object) -> None:
        node.visible = bool(box.value)

    return box


def _look_at_target(server: viser.ViserServer, scene: Scene, size: float) -> None:
    target = scene.target_cloud
    centre = target.mean(axis=0) if len(target) else np.zeros(3)
    server.initial_camera.look_at = tuple(centre)
    away = size * np.array([0.8, -1.0, 0.65])
    server.initial_camera.position = tuple(centre + away)
    server.initial_camera.near = size / 1000
    server.initial_camera.far = size * 1000

    @server.on_client_connect
    def step_back(client: viser.ClientHandle) -> None:
        # the field of view is that of the height, so that a phone held upright sees less
        if client.camera.aspect < _WIDE:
            client.camera.position = tuple(centre + away * _WIDE / client.camera.aspect)
            client.camera.look_at = tuple(centre)  # which moves with the position


def _summary(outcome: Outcome, scene: Scene) -> str:
    rows = words.result_rows(outcome) + words.pose_rows(outcome)
    if outcome.is_of_clouds and outcome.has_pose:
        rows += [*words.weak_rows(outcome), ("distances", words.distances(scene))]
    rows += words.in_use_rows(outcome)
    rows.append(("consensus graph", words.agreement(scene)))
    lines = [f"**{key}** {text}" if key else text for key, text in rows]
    shown = [*words.drawn(outcome, scene), f"Graph: {_graph_edges(scene)[1].words('edges')}"]
    return "  \n".join(lines) + "\n\n" + ". ".join(shown) + "."
