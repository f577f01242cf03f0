"""Many scans from their points alone."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import gmcr
import numpy as np
import numpy.typing as npt
import pytest
from gmcr.io import read_points
from gmcr.multiview import register_pairs, register_scans

pytest.importorskip("open3d")

Matrix = npt.NDArray[np.float64]
EXAMPLE = Path(__file__).parents[2] / "examples/python/10_multiview.py"


@pytest.fixture(scope="module")
def scene() -> tuple[list[Matrix], list[Matrix]]:
    """Three overlapping pieces of a bumpy surface, moved, and a fourth that is only noise.

    With the poses of the three in the frame of the first.
    """
    rng = np.random.default_rng(2)
    xy = rng.uniform([0, 0], [4, 2], (9000, 2))
    height = np.zeros(len(xy))
    for _ in range(40):
        centre, width = rng.uniform([0, 0], [4, 2]), rng.uniform(0.1, 0.4)
        bump = np.exp(-((xy - centre) ** 2).sum(axis=1) / (2 * width**2))
        height += rng.uniform(-0.3, 0.3) * bump
    surface = np.column_stack([xy, height])
    scans, poses = [], []
    for index, (low, high) in enumerate([(0, 2.4), (0.8, 3.2), (1.6, 4.0)]):
        seen = surface[(low <= xy[:, 0]) & (xy[:, 0] <= high)]
        seen = seen[rng.random(len(seen)) < 0.7]
        motion = gmcr.make_synthetic(num_correspondences=3, outlier_rate=0, seed=index)
        world_from_scan = motion.target_from_source.matrix()
        scan_from_world = np.linalg.inv(world_from_scan)
        scans.append(seen @ scan_from_world[:3, :3].T + scan_from_world[:3, 3])
        poses.append(world_from_scan)
    scans.append(rng.normal(size=(3000, 3)))
    return scans, [np.linalg.inv(poses[0]) @ pose for pose in poses]


def test_scans_are_placed_from_their_points_and_what_is_none_of_them_is_left_out(
    scene: tuple[list[Matrix], list[Matrix]],
) -> None:
    scans, poses = scene
    frontend = gmcr.FrontendOptions(voxel_size=0.06, max_attempts=2)
    result = register_scans(scans, frontend=frontend, num_threads=2)
    assert [component.scans for component in result.components] == [(0, 1, 2), (3,)]
    assert [(judged.edge.source, judged.edge.target) for judged in result.edges] == [
        (1, 0), (2, 0), (3, 0), (2, 1), (3, 1), (3, 2)
    ]  # fmt: skip
    for scan in (1, 2):
        pose = result.poses[scan]
        assert pose is not None
        errors = gmcr.evaluate(pose, poses[scan], scans[scan])
        assert errors.mean_point_error is not None
        assert errors.mean_point_error < 0.02
    judged = result.edges[0]
    assert judged.is_accepted
    assert judged.edge.result is not None
    assert judged.edge.result.registration.certificate.upper >= len(
        judged.edge.result.registration.inliers
    )
    assert judged.edge.tolerance == judged.edge.result.matches.noise_bound
    assert "3 -> 0   untrusted rejected: " in result.summary()


def test_chosen_pairs_keep_their_direction_and_refinement_brings_them_closer(
    scene: tuple[list[Matrix], list[Matrix]],
) -> None:
    scans, poses = scene
    options = gmcr.Options(num_threads=2)
    frontend = gmcr.FrontendOptions(voxel_size=0.06, max_attempts=2)
    pairs = [(0, 1)]
    coarse = gmcr.FrontendOptions(voxel_size=0.06, max_attempts=2, refine="none")
    (plain,) = register_pairs(scans, pairs, coarse, options, tolerance=0.5)
    (refined,) = register_pairs(scans, pairs, frontend, options)
    truth = np.linalg.inv(poses[1])
    errors = [
        gmcr.evaluate(edge.target_from_source, truth, scans[0]).mean_point_error
        for edge in (plain, refined)
    ]
    assert (refined.source, refined.target) == (0, 1)
    assert plain.tolerance == 0.5
    assert errors[1] < 0.7 * errors[0]  # type: ignore[operator]


def test_refinement_keeps_to_the_priors(scene: tuple[list[Matrix], list[Matrix]]) -> None:
    source, target = scene[0][:2]
    frontend = gmcr.FrontendOptions(voxel_size=0.06, max_attempts=2, refine="none")
    result = gmcr.register_clouds(source, target, frontend)
    found = result.registration.target_from_source
    for max_rotation in (1e-9, 0.5):
        prior = gmcr.InitialPose(target_from_source=found, max_rotation=max_rotation)
        options = gmcr.Options(initial_pose=prior)
        refined = gmcr.refine_clouds(result, source, target, options)
        assert options.admit(refined.registration.target_from_source)
    assert refined.refinement.is_applied
    assert refined.refinement.noise > 0


def test_alternatives_are_edges_of_their_own(scene: tuple[list[Matrix], list[Matrix]]) -> None:
    scans, _ = scene
    frontend = gmcr.FrontendOptions(voxel_size=0.06, max_attempts=1)
    edges = register_pairs(scans, [(1, 0)], frontend, num_hypotheses=3, num_threads=2)
    assert len(edges) > 1
    assert {(edge.source, edge.target) for edge in edges} == {(1, 0)}
    assert not np.allclose(edges[0].target_from_source, edges[1].target_from_source)


def test_copies_of_a_scan_meet_exactly(scene: tuple[list[Matrix], list[Matrix]]) -> None:
    scans, _ = scene
    frontend = gmcr.FrontendOptions(voxel_size=0.06, max_attempts=1)
    result = register_scans([scans[0]] * 3, frontend=frontend, num_threads=2)
    assert all(judged.is_confirmed for judged in result.edges)
    for pose in result.poses:
        np.testing.assert_allclose(pose, np.eye(4), atol=1e-6)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("pairs", "keywords", "match"),
    [
        ([(0, 0)], {}, r"\(0, 0\) are not two of 2 scans"),
        ([(0, 2)], {}, r"\(0, 2\) are not two of 2 scans"),
        ([(0, 1), (1, 0)], {}, "there twice"),
        ([], {"tolerance": 0.0}, "tolerance: 0.0"),
        ([], {"scale_mode": "estimated"}, "scale 1"),
        ([], {"scale": 2.0}, "scale 1"),
    ],
)
def test_broken_contracts_are_value_errors_before_any_work(
    pairs: list[tuple[int, int]], keywords: dict[str, object], match: str
) -> None:
    with pytest.raises(ValueError, match=match):
        register_pairs([np.zeros((1, 3))] * 2, pairs, **keywords)  # type: ignore[arg-type]


def test_scans_without_points_are_value_errors_before_any_work() -> None:
    with pytest.raises(ValueError, match=r"scans\[1\]: expected finite points"):
        register_scans([np.zeros((5, 3)), np.empty((0, 3))])


def test_without_pairs_each_scan_is_alone() -> None:
    result = register_scans([np.zeros((1, 3)), np.ones((2, 3))], pairs=[])
    assert [component.scans for component in result.components] == [(0,), (1,)]


def test_the_example_puts_four_real_scans_together(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    done = subprocess.run(
        [sys.executable, str(EXAMPLE), "--output", str(tmp_path)],
        capture_output=True,
        text=True,
        check=True,
    )
    if done.stdout.startswith("skipped"):
        pytest.skip(done.stdout)
    errors = re.findall(r"([\d.]+) deg, ([\d.]+) mm off the truth", done.stdout)
    assert len(errors) == 2
    assert all(float(degrees) < 0.5 and float(mm) < 1 for degrees, mm in errors)
    assert (tmp_path / "bunny.png").stat().st_size > 100_000
    merged = read_points(tmp_path / "bunny.ply")
    np.testing.assert_allclose(np.ptp(merged, axis=0), [0.156, 0.154, 0.121], atol=0.005)
