"""Clouds that are prepared once for many pairs."""

from __future__ import annotations

import pickle

import gmcr
import numpy as np
import pytest
from gmcr import io

VOXEL = 0.05


@pytest.fixture(scope="module")
def prepared(clouds):
    return [gmcr.prepare(cloud, voxel_size=VOXEL) for cloud in clouds[:2]]


def same(a, b):
    return np.array_equal(a.matrix(), b.matrix()) and a.verdict == b.verdict


def test_results_are_those_of_the_points(clouds, prepared):
    expected = gmcr.register_clouds(*clouds[:2], voxel_size=VOXEL)
    assert same(gmcr.register_clouds(*prepared), expected)
    assert same(gmcr.register_clouds(clouds[0], prepared[1], voxel_size=VOXEL), expected)
    assert same(gmcr.register_clouds(prepared[0], clouds[1], voxel_size=VOXEL), expected)
    matches = gmcr.match(*prepared)
    assert "features" not in matches.stages
    expected_matches = gmcr.match(*clouds[:2], voxel_size=VOXEL)
    assert np.array_equal(matches.source, expected_matches.source)
    assert np.array_equal(matches.target_indices, expected_matches.target_indices)


def test_it_is_a_file_that_reads_as_a_cloud(clouds, prepared, tmp_path):
    path = tmp_path / "scan.prepared.ply"
    prepared[0].save(path)
    again = gmcr.PreparedCloud.load(str(path))
    assert again.voxel_size == VOXEL
    assert (again.normal_radius, again.feature_radius) == (2, 5)
    assert np.array_equal(again.points, clouds[0])
    assert again.to_bytes() == path.read_bytes()
    assert "voxel_size=0.05" in repr(again)
    assert np.array_equal(io.read_points(path), clouds[0])
    assert same(gmcr.register_clouds(again, prepared[1]), gmcr.register_clouds(*prepared))


def test_it_can_be_pickled(prepared):
    again = pickle.loads(pickle.dumps(prepared))
    assert same(gmcr.register_clouds(*again), gmcr.register_clouds(*prepared))


def test_what_does_not_fit_is_refused(prepared, tmp_path):
    content = prepared[0].to_bytes()
    with pytest.raises(ValueError, match="version 2"):
        gmcr.PreparedCloud.from_bytes(content.replace(b"cloud 1\n", b"cloud 2\n", 1))
    path = tmp_path / "cut.ply"
    path.write_bytes(content[:-1])
    with pytest.raises(OSError, match=r"cut\.ply: prepared cloud: it is cut"):
        gmcr.PreparedCloud.load(path)
    with pytest.raises(OSError):
        gmcr.PreparedCloud.load(tmp_path / "absent.ply")
    with pytest.raises(ValueError, match="feature_radius"):
        gmcr.register_clouds(*prepared, feature_radius=6)
    with pytest.raises(ValueError, match="not finite"):
        gmcr.prepare(np.full((4, 3), np.nan))
    with pytest.raises(ValueError, match="voxel_size"):
        gmcr.prepare(np.zeros((4, 3)), voxel_size=-1)


def test_points_are_a_view(prepared):
    assert not prepared[0].points.flags.writeable
    with pytest.raises(AttributeError):
        prepared[0].points = None
