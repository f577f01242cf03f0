"""Poses of many scans from measured poses of pairs."""

from __future__ import annotations

import importlib
from itertools import combinations
from typing import Any

import gmcr
import numpy as np
import numpy.typing as npt
import pytest
from gmcr.multiview import Edge, MultiviewResult, merge_scans, place_scans, point_information

pytest.importorskip("open3d")

Matrix = npt.NDArray[np.float64]
TOLERANCE = 0.05
NOISE = 0.002


def _pose(rng: np.random.Generator, angle: float, distance: float) -> Matrix:
    """A turn by the angle about a random axis and a shift by the distance."""
    axis, shift = rng.normal(size=(2, 3))
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    pose = np.eye(4)
    pose[:3, :3] = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    pose[:3, 3] = distance * shift / np.linalg.norm(shift)
    return pose


class Scene:
    """Scans of 50 points each in [-1, 1]^3 about an origin, and noisy edges between them."""

    def __init__(self, num_scans: int, seed: int = 1, origin: float = 0) -> None:
        self.rng = np.random.default_rng(seed)
        self.poses = [_pose(self.rng, self.rng.uniform(0, 3), 2) for _ in range(num_scans)]
        self.poses[0] = np.eye(4)
        self.scans = [self.rng.uniform(-1, 1, (50, 3)) + origin for _ in range(num_scans)]

    def truth(self, source: int, target: int) -> Matrix:
        return np.linalg.inv(self.poses[target]) @ self.poses[source]

    def edge(self, source: int, target: int, weight: float = 10, **fields: Any) -> Edge:
        pose = self.truth(source, target) @ _pose(self.rng, NOISE, NOISE)
        return Edge(source, target, pose, weight, TOLERANCE, **fields)

    def wrong_edge(self, source: int, target: int, weight: float = 10, **fields: Any) -> Edge:
        pose = self.truth(source, target) @ _pose(self.rng, 1, 1)
        return Edge(source, target, pose, weight, TOLERANCE, **fields)

    def all_edges(self) -> list[Edge]:
        return [self.edge(j, i) for i, j in combinations(range(len(self.scans)), 2)]

    def place(self, edges: list[Edge]) -> MultiviewResult:
        return place_scans(self.scans, edges)

    def assert_near(self, result: MultiviewResult, scans: range | list[int], error: float) -> None:
        for scan in scans:
            pose = result.poses[scan]
            assert pose is not None
            errors = gmcr.evaluate(pose, self.poses[scan], self.scans[scan])
            assert errors.mean_point_error is not None
            assert errors.mean_point_error < error


def test_one_scan_is_where_it_is_and_needs_no_pose_graph(monkeypatch: pytest.MonkeyPatch) -> None:
    _hide_open3d(monkeypatch)
    scene = Scene(1)
    result = scene.place([])
    assert np.array_equal(result.poses, [np.eye(4)])
    assert [component.scans for component in result.components] == [(0,)]
    assert result.summary() == "connected, in the frame of scan 0: 0"


def test_two_scans_take_the_pose_of_their_edge_in_either_direction() -> None:
    scene = Scene(2)
    for edge in (scene.edge(1, 0), scene.edge(0, 1)):
        result = scene.place([edge])
        scene.assert_near(result, range(2), 3 * NOISE)
        (judged,) = result.edges
        assert judged.edge is edge
        assert judged.is_accepted
        assert not judged.is_confirmed
        assert judged.reason == "no cycle confirms it"
        assert judged.disagreement == pytest.approx(0, abs=1e-12)


def test_edges_that_all_agree_are_accepted_and_confirmed_and_average_their_noise() -> None:
    scene = Scene(6)
    edges = scene.all_edges()
    result = scene.place(edges)
    assert all(judged.is_accepted and judged.is_confirmed for judged in result.edges)
    scene.assert_near(result, range(6), 2 * NOISE)

    def mean_error(placed: MultiviewResult) -> float:
        errors = [
            gmcr.evaluate(pose, truth, scan).mean_point_error
            for pose, truth, scan in zip(placed.poses, scene.poses, scene.scans, strict=True)
            if pose is not None
        ]
        return float(np.mean([error for error in errors if error is not None]))

    chain = [edge for edge in edges if edge.source == edge.target + 1]
    assert mean_error(result) < 0.7 * mean_error(scene.place(chain))


@pytest.mark.parametrize("seed", range(5))
def test_wrong_edges_are_rejected_though_they_weigh_most(seed: int) -> None:
    scene = Scene(6, seed)
    edges = scene.all_edges()
    wrong = scene.rng.choice(len(edges), 4, replace=False)
    for index in wrong:
        edges[index] = scene.wrong_edge(edges[index].source, edges[index].target, weight=100)
    result = scene.place(edges)
    rejected = [i for i, judged in enumerate(result.edges) if not judged.is_accepted]
    assert rejected == sorted(wrong)
    assert all("off the poses that the others agree on" in result.edges[i].reason for i in rejected)
    scene.assert_near(result, range(6), 2 * NOISE)


def test_two_wrong_doubtful_edges_that_agree_do_not_outweigh_a_trusted_one() -> None:
    scene = Scene(3)
    wrong = scene.wrong_edge(2, 0, verdict=gmcr.Verdict.DOUBTFUL)
    agreeing = Edge(
        2, 1, scene.truth(0, 1) @ wrong.target_from_source, 10, TOLERANCE, verdict=wrong.verdict
    )
    extra = scene.edge(1, 2, weight=1)
    result = scene.place([scene.edge(1, 0), wrong, agreeing, extra])
    assert [judged.is_accepted for judged in result.edges] == [True, False, False, True]
    scene.assert_near(result, range(3), 5 * NOISE)


def test_two_groups_are_joined_by_the_edges_that_agree_not_by_the_heaviest() -> None:
    scene = Scene(6)
    inside = [scene.edge(j, i, 50) for i, j in [(0, 1), (0, 2), (1, 2), (3, 4), (3, 5), (4, 5)]]
    right = [scene.edge(3, 0, weight=1), scene.edge(4, 1, weight=1)]
    wrong = [scene.wrong_edge(5, 2, weight=90), scene.wrong_edge(0, 5, weight=80)]
    result = scene.place(inside + wrong + right)
    assert [judged.is_accepted for judged in result.edges] == [True] * 6 + [False] * 2 + [True] * 2
    scene.assert_near(result, range(6), 5 * NOISE)


def test_a_doubtful_edge_counts_only_where_a_cycle_confirms_it() -> None:
    scene = Scene(3)
    doubtful = gmcr.Verdict.DOUBTFUL
    first, second = (scene.edge(2, i, verdict=doubtful, reason="few matches") for i in (0, 1))
    alone = scene.place([scene.edge(1, 0), first])
    assert alone.poses[2] is None
    assert alone.edges[1].reason == "no cycle confirms it; few matches"
    both = scene.place([scene.edge(1, 0), first, second])
    assert all(judged.is_confirmed for judged in both.edges)
    scene.assert_near(both, range(3), 3 * NOISE)


def test_an_untrusted_edge_is_never_used() -> None:
    scene = Scene(2)
    edge = scene.edge(1, 0, verdict=gmcr.Verdict.UNTRUSTED, reason="chance")
    result = scene.place([edge])
    assert result.poses[1] is None
    assert result.edges[0].reason == "chance"
    assert result.edges[0].disagreement is None


def test_of_several_hypotheses_for_a_pair_the_consistent_one_is_taken() -> None:
    scene = Scene(4)
    edges = scene.all_edges()
    others = [scene.wrong_edge(edge.source, edge.target, weight=20) for edge in edges]
    result = scene.place(edges + others)
    assert [judged.is_accepted for judged in result.edges] == [True] * 6 + [False] * 6
    scene.assert_near(result, range(4), 2 * NOISE)


def test_scans_that_nothing_connects_are_reported_in_groups_of_their_own() -> None:
    scene = Scene(5)
    result = scene.place([scene.edge(2, 0), scene.edge(4, 3)])
    assert [component.scans for component in result.components] == [(0, 2), (1,), (3, 4)]
    assert [pose is None for pose in result.poses] == [False, True, False, True, True]
    group = result.components[2]
    assert np.array_equal(group.poses[3], np.eye(4))
    errors = gmcr.evaluate(group.poses[4], scene.truth(4, 3), scene.scans[4])
    assert errors.mean_point_error is not None
    assert errors.mean_point_error < 3 * NOISE
    assert "in the frame of scan 3: 3, 4" in result.summary()
    assert str(result) == result.summary()
    html = result._repr_html_()
    assert html.count("<tr>") == 1 + len(result.edges)
    assert "<td>2 \u2192 0</td>" in html and "<li>3, 4</li>" in html


def test_a_long_loop_closes_within_the_drift_of_its_edges() -> None:
    scene = Scene(12)
    edges = [scene.edge((i + 1) % 12, i) for i in range(12)]
    result = scene.place(edges)
    assert all(judged.is_confirmed for judged in result.edges)
    broken = scene.place([*edges[:-1], scene.wrong_edge(0, 11, weight=1)])
    assert [judged.is_accepted for judged in broken.edges] == [True] * 11 + [False]
    assert not any(judged.is_confirmed for judged in broken.edges)


def test_scans_far_from_their_origins_are_placed_as_well() -> None:
    scene = Scene(5, origin=1e6)
    for pose in scene.poses[1:]:  # so that they meet in spite of the lever
        pose[:3, 3] += 1e6 * np.ones(3) - pose[:3, :3] @ (1e6 * np.ones(3))
    edges = []
    for i, j in combinations(range(5), 2):
        centre = np.eye(4)
        centre[:3, 3] = 1e6
        noise = centre @ _pose(scene.rng, NOISE, NOISE) @ np.linalg.inv(centre)
        edges.append(Edge(j, i, scene.truth(j, i) @ noise, 10, TOLERANCE))
    result = scene.place(edges)
    assert all(judged.is_confirmed for judged in result.edges)
    scene.assert_near(result, range(5), 2 * NOISE)


def test_information_decides_between_edges_that_differ() -> None:
    scene = Scene(3)
    sure = point_information(scene.scans[1] - scene.scans[1].mean(axis=0), 1e-5)
    edges = [scene.edge(1, 0, information=sure), scene.edge(2, 0), scene.edge(2, 1)]
    result = scene.place(edges)
    assert result.poses[1] is not None
    np.testing.assert_allclose(result.poses[1], edges[0].target_from_source, atol=1e-6)
    assert result.edges[0].disagreement < 1e-6 < result.edges[1].disagreement  # type: ignore[operator]


def test_point_information_is_that_of_small_motions() -> None:
    rng = np.random.default_rng(3)
    points, motion = rng.normal(size=(20, 3)), rng.normal(size=6)
    moved = np.cross(motion[:3], points) + motion[3:]
    information = point_information(points, sigma=0.1)
    assert motion @ information @ motion == pytest.approx((moved**2).sum() / 0.1**2)


def test_the_order_of_the_edges_does_not_change_the_poses() -> None:
    scene = Scene(5)
    edges = scene.all_edges()
    edges[3] = scene.wrong_edge(edges[3].source, edges[3].target)
    for index, edge in enumerate(edges):
        edges[index] = Edge(
            edge.source, edge.target, edge.target_from_source, 10 + index, TOLERANCE
        )
    forward, backward = scene.place(edges), scene.place(edges[::-1])
    for one, other in zip(forward.poses, backward.poses, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-7)  # type: ignore[arg-type]


def test_merged_scans_are_averaged_in_voxels_and_those_without_a_pose_left_out() -> None:
    shift = np.eye(4)
    shift[0, 3] = 5
    scans = [np.array([[0.0, 0, 0], [9, 9, 9]]), np.array([[-4.8, 0, 0]]), np.ones((1, 3))]
    merged = merge_scans(scans, [np.eye(4), shift, None], voxel_size=1)
    np.testing.assert_allclose(merged, [[0.1, 0, 0], [9, 9, 9]])


@pytest.mark.parametrize(
    ("change", "match"),
    [
        (lambda scene: scene.place([scene.edge(0, 1), Edge(0, 3, np.eye(4), 1, 1)]), r"edges\[1\]"),
        (lambda scene: scene.place([Edge(1, 1, np.eye(4), 1, 1)]), "1 -> 1"),
        (lambda scene: place_scans([], []), "at least one"),
        (lambda scene: place_scans([np.empty((0, 3))], []), r"scans\[0\]"),
        (lambda scene: place_scans([np.full((2, 3), np.nan)], []), r"scans\[0\]"),
        (lambda scene: point_information(scene.scans[0], 0), "sigma: 0"),
        (lambda scene: Edge(0, 1, np.eye(3), 1, 1), "matrix"),
        (lambda scene: Edge(0, 1, np.zeros((4, 4)), 1, 1), "matrix"),
        (lambda scene: Edge(0, 1, np.diag([2.0, 2, 2, 1]), 1, 1), "scale is not 1"),
        (lambda scene: Edge(0, 1, np.eye(4), 0, 1), "weight and tolerance: 0 and 1"),
        (lambda scene: Edge(0, 1, np.eye(4), 1, -1), "weight and tolerance: 1 and -1"),
        (lambda scene: merge_scans(scene.scans, [None] * 3, 1), "none is given"),
        (lambda scene: merge_scans(scene.scans, [], 1), "0 for 3 scans"),
    ],
)
def test_broken_contracts_are_value_errors(change: Any, match: str) -> None:
    with pytest.raises(ValueError, match=match):
        change(Scene(3))


def test_without_open3d_a_pose_graph_is_an_import_error_that_names_the_extra(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    _hide_open3d(monkeypatch)
    scene = Scene(3)
    with pytest.raises(ImportError, match=r"pip install 'gmcr\[multiview\]'"):
        scene.place(scene.all_edges())


def _hide_open3d(monkeypatch: pytest.MonkeyPatch) -> None:
    original = importlib.import_module

    def import_module(name: str, package: str | None = None) -> Any:
        if name.split(".")[0] == "open3d":
            raise ModuleNotFoundError("No module named 'open3d'", name="open3d")
        return original(name, package)

    monkeypatch.setattr(importlib, "import_module", import_module)
