"""What may be passed as points."""

from __future__ import annotations

from pathlib import Path

import gmcr
import gmcr.io
import numpy as np
import pytest
from gmcr._arguments import as_points


class Cloud:
    """Points of another library, known by ``__array__`` alone, such as Open3D's or torch's."""

    def __init__(self, points: np.ndarray) -> None:
        self.points = points

    def __array__(self, dtype=None, copy=None) -> np.ndarray:
        return np.asarray(self.points, dtype=dtype)


class Tensor:
    """A tensor of torch: with a gradient, on a GPU, until it is asked for."""

    def __init__(self, points: np.ndarray, steps: tuple[str, ...] = ()) -> None:
        self.data = points
        self.steps = steps

    def detach(self) -> Tensor:
        return Tensor(self.data, (*self.steps, "detach"))

    def cpu(self) -> Tensor:
        return Tensor(self.data, (*self.steps, "cpu"))

    def __array__(self, dtype=None, copy=None) -> np.ndarray:
        if self.steps != ("detach", "cpu"):
            raise TypeError("can't convert a tensor that requires grad or is on a GPU")
        return np.asarray(self.data, dtype=dtype)


class TensorCloud:
    """A cloud of Open3D's tensors, which have ``numpy()`` and no ``__array__``."""

    class Positions:
        def __init__(self, points: np.ndarray) -> None:
            self.points = points

        def cpu(self) -> TensorCloud.Positions:
            return self

        def numpy(self) -> np.ndarray:
            return self.points

    def __init__(self, points: np.ndarray) -> None:
        self.point = {"positions": TensorCloud.Positions(points)}


def fields_of(points: np.ndarray, shape: tuple[int, ...] = (-1,)) -> np.ndarray:
    """Structured, as of ROS: float32 would round, so float64; the fields in another order."""
    cloud = np.zeros(len(points), [("intensity", "f4"), ("z", "f8"), ("y", "f8"), ("x", "f8")])
    for column, name in enumerate("xyz"):
        cloud[name] = points[:, column]
    return cloud.reshape(shape)


def register(problem, source, target):
    return gmcr.register_correspondences(source, target, noise_bound=problem.noise_bound)


def test_c_order_float64_is_read_in_place():
    points = np.arange(12.0).reshape(4, 3)
    assert as_points(points, "source") is points


def test_a_change_of_the_array_is_seen_without_a_copy(problem):
    options = gmcr.Options(noise_bound=problem.noise_bound)
    source = np.array(problem.source)
    seen = []
    options.progress = lambda stage, fraction: seen.append(stage)
    before = gmcr.register_correspondences(source, problem.target, options)
    source[:] = source[::-1]
    after = gmcr.register_correspondences(source, problem.target, options)
    assert seen
    assert before.evidence > after.evidence


def test_float32_gives_the_result_of_its_values_as_float64(problem):
    source, target = (np.asarray(p, np.float32) for p in (problem.source, problem.target))
    narrow = register(problem, source, target)
    wide = register(problem, source.astype(np.float64), target.astype(np.float64))
    assert np.array_equal(narrow.matrix(), wide.matrix())
    assert narrow.status == "ok"


@pytest.mark.parametrize(
    "layout",
    [
        np.asfortranarray,
        lambda p: np.column_stack([p, p])[:, :3],
        lambda p: np.repeat(p, 2, axis=0)[::2],
        lambda p: p.astype(">f8"),
        lambda p: p.tolist(),
        Cloud,
        lambda p: Cloud(p.tolist()),
        Tensor,
        TensorCloud,
        fields_of,
        lambda p: fields_of(p, (10, -1)),
    ],
    ids=[
        "fortran",
        "columns",
        "rows",
        "big-endian",
        "list",
        "__array__",
        "points",
        "torch",
        "tensors",
        "fields",
        "organized",
    ],
)
def test_other_layouts_and_containers_give_the_same_bits(problem, layout):
    expected = register(problem, problem.source, problem.target)
    result = register(problem, layout(problem.source), layout(problem.target))
    assert np.array_equal(result.matrix(), expected.matrix())
    assert np.array_equal(result.inliers, expected.inliers)


def test_integers_are_numbers():
    corner = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]]
    result = gmcr.register_correspondences(corner, corner, noise_bound=0.1)
    assert len(result.inliers) == 4


@pytest.mark.parametrize("shape", [(3,), (5, 2), (5, 4), (3, 5), (2, 5, 3)])
def test_a_wrong_shape_is_a_value_error_that_names_the_argument(shape):
    good = np.zeros((5, 3))
    with pytest.raises(ValueError, match="source: expected shape"):
        gmcr.register_correspondences(np.zeros(shape), good, noise_bound=1)
    with pytest.raises(ValueError, match="target: expected shape"):
        gmcr.register_correspondences(good, np.zeros(shape), noise_bound=1)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_value_that_is_not_finite_is_a_value_error(problem, value):
    broken = np.array(problem.target)
    broken[7, 1] = value
    with pytest.raises(ValueError, match="target: point 7 is not finite"):
        register(problem, problem.source, broken)
    with pytest.raises(ValueError, match="source: point 7 is not finite"):
        gmcr.register_clouds(broken, problem.target)


def test_different_lengths_are_a_value_error():
    with pytest.raises(ValueError, match="target: 4 points, but source has 5"):
        gmcr.register_correspondences(np.zeros((5, 3)), np.zeros((4, 3)), noise_bound=1)


@pytest.mark.parametrize("values", [[["a", "b", "c"]], [[None, 1, 2]], [[1j, 0, 0]], [[True] * 3]])
def test_what_is_no_number_is_a_value_error(values):
    with pytest.raises(ValueError, match="source: expected numbers"):
        gmcr.register_correspondences(values, values, noise_bound=1)


@pytest.mark.parametrize("count", [0, 1, 2])
def test_fewer_than_three_are_a_status(count):
    points = np.arange(3.0 * count).reshape(count, 3)
    result = gmcr.register_correspondences(points, points, noise_bound=1)
    assert result.status == gmcr.Status.TOO_FEW_CORRESPONDENCES
    assert "3" in result.status_reason
    assert np.array_equal(result.matrix(), np.eye(4))


def test_three_exact_correspondences_are_enough():
    source = np.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 0]])
    result = gmcr.register_correspondences(source, source + np.array([1, 2, 3]), noise_bound=0.01)
    assert result.inliers.tolist() == [0, 1, 2]
    assert np.allclose(result.translation, [1, 2, 3])


def test_clouds_of_open3d_are_read():
    open3d = pytest.importorskip("open3d")
    points = np.random.default_rng(1).random((30, 3))
    legacy = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    tensors = open3d.t.geometry.PointCloud(open3d.core.Tensor(points))
    for cloud in (legacy, legacy.points, tensors, tensors.point.positions):
        assert np.array_equal(as_points(cloud, "source"), points)


@pytest.mark.parametrize("num_columns", [4, 6, 7])
def test_what_follows_the_coordinates_of_a_cloud_is_left_out(clouds, num_columns):
    source, target = (
        np.column_stack([points, np.full((len(points), num_columns - 3), 9)])
        for points in clouds[:2]
    )
    plain = gmcr.match(*clouds[:2], voxel_size=0.1)
    wide = gmcr.match(source, target, voxel_size=0.1)
    assert np.array_equal(wide.target, plain.target)
    with pytest.raises(ValueError, match=r"points: expected shape \(N, 3\), but it is \(3, 7\)"):
        gmcr.voxel_grid(np.ones((3, 7)), 1)


@pytest.mark.parametrize("kind", [str, Path])
def test_clouds_may_be_files(clouds, tmp_path, kind):
    paths = [tmp_path / "source.npy", tmp_path / "target.ply"]
    for path, points in zip(paths, clouds, strict=False):
        gmcr.io.write_points(path, points)
    of_files = gmcr.match(*map(kind, paths), voxel_size=0.1)
    of_arrays = gmcr.match(*map(gmcr.io.read_points, paths), voxel_size=0.1)
    assert np.array_equal(of_files.target, of_arrays.target)
    assert len(gmcr.voxel_grid(kind(paths[0]), 0.1)) < len(clouds[0])
