"""What may be passed as points."""

from __future__ import annotations

import gmcr
import numpy as np
import pytest
from gmcr._arguments import as_points


class Cloud:
    """Points of another library, known by ``__array__`` alone, such as Open3D's or torch's."""

    def __init__(self, points: np.ndarray) -> None:
        self.points = points

    def __array__(self, dtype=None, copy=None) -> np.ndarray:
        return np.asarray(self.points, dtype=dtype)


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
    ],
    ids=["fortran", "columns", "rows", "big-endian", "list", "__array__"],
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
