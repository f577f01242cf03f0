"""A scan in a map."""

from __future__ import annotations

import gmcr
import numpy as np
import pytest
from towns import pose_at, sweep, town_points

VOXEL = 0.4
TRUTH = pose_at(31, 27, 2.1)


@pytest.fixture(scope="module")
def points():
    return town_points()


@pytest.fixture(scope="module")
def town(points):
    return gmcr.prepare_map(points, voxel_size=VOXEL)


@pytest.fixture(scope="module")
def scan(points):
    return sweep(points, TRUTH)


def same(a, b):
    return np.array_equal(a.matrix(), b.matrix()) and a.verdict == b.verdict


def test_a_scan_is_found_and_trusted(scan, town):
    result = gmcr.localise_scan(scan, town)
    assert result.verdict == "trusted", result.verdict_reason
    assert np.abs(result.matrix() - TRUTH).max() < 0.05
    assert result.num_source_points == len(scan)
    assert "of the scan" in result.verdict_reason


def test_a_map_that_is_not_prepared_gives_the_same(scan, points, town, tmp_path):
    expected = gmcr.localise_scan(scan, town)
    assert same(gmcr.localise_scan(scan, points, voxel_size=VOXEL), expected)
    path = tmp_path / "town.map.ply"
    town.save(path)
    assert same(gmcr.localise_scan(scan, path), expected)
    assert same(gmcr.localise_scan(scan, gmcr.PreparedMap.load(path)), expected)
    assert np.array_equal(gmcr.io.read_points(path), town.points)
    with pytest.raises(ValueError, match="voxel_size"):
        gmcr.localise_scan(scan, path, voxel_size=0.3)


def test_what_is_known_is_heeded(scan, town):
    elsewhere = pose_at(8, 9, 0.1)
    near = gmcr.InitialPose(target_from_source=elsewhere, max_rotation=0.3, max_translation=4)
    result = gmcr.localise_scan(scan, town, initial_pose=near)
    assert result.verdict != "trusted"
    if result.status == "ok":
        assert np.linalg.norm(result.matrix()[:3, 3] - elsewhere[:3, 3]) <= 4 + 1e-9


def test_up_is_a_direction_of_the_map(scan, points):
    turned = points[:, [2, 0, 1]]  # x is up
    result = gmcr.localise_scan(
        scan, gmcr.prepare_map(turned, voxel_size=VOXEL, up=[2, 0, 0]), num_threads=1
    )
    assert result.verdict == "trusted", result.verdict_reason
    assert np.abs(result.matrix()[[1, 2, 0]] - TRUTH[:3]).max() < 0.05


def test_a_map_is_described(town):
    assert town.voxel_size == VOXEL
    assert town.up.tolist() == [0, 0, 1]
    assert not town.points.flags.writeable
    assert repr(town) == f"PreparedMap({len(town.points)} points, voxel_size=0.4)"


def test_what_does_not_fit_is_refused(scan, points, town, tmp_path):
    with pytest.raises(ValueError, match="up"):
        gmcr.prepare_map(points, up=[0, 0, 0])
    with pytest.raises(ValueError, match="no points"):
        gmcr.prepare_map(np.zeros((0, 3)))
    with pytest.raises(ValueError, match="scale_mode"):
        gmcr.localise_scan(scan, town, scale_mode="estimated")
    with pytest.raises(ValueError, match="pairs of clouds"):
        gmcr.localise_scan(scan, gmcr.prepare(points[:1000], voxel_size=VOXEL))
    with pytest.raises(OSError, match="absent"):
        gmcr.PreparedMap.load(tmp_path / "absent.ply")
