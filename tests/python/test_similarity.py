"""Transforms and the errors between them."""

from __future__ import annotations

import pickle

import gmcr
import numpy as np
import pytest

TURN = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])


def make_similarity() -> gmcr.Similarity:
    return gmcr.Similarity(scale=2, rotation=TURN, translation=[1, 2, 3])


def test_the_default_is_the_identity():
    assert np.array_equal(gmcr.Similarity().matrix(), np.eye(4))


def test_fields_are_kept_row_by_row():
    pose = pickle.loads(pickle.dumps(make_similarity()))
    assert pose.scale == 2
    assert np.array_equal(pose.rotation, TURN)
    assert np.array_equal(pose.translation, [1, 2, 3])
    assert np.array_equal(pose.matrix()[:3, :3], 2 * TURN)
    pose.scale, pose.rotation, pose.translation = 5, np.eye(3), [7, 8, 9]
    assert np.array_equal(pose.matrix()[0], [5, 0, 0, 7])


def test_matrices_are_read_and_written():
    pose = make_similarity()
    assert np.allclose(gmcr.Similarity.from_matrix(pose.matrix()).matrix(), pose.matrix())
    with pytest.raises(ValueError):
        gmcr.Similarity.from_matrix(np.diag([1.0, 1, -1, 1]))
    with pytest.raises(ValueError, match="matrix"):
        gmcr.Similarity.from_matrix(np.eye(3))


def test_composition_inverse_and_application_are_those_of_the_matrices():
    pose, other = make_similarity(), gmcr.Similarity(translation=[0, 0, 5])
    points = np.arange(12.0).reshape(4, 3)
    assert np.allclose((pose @ other).matrix(), pose.matrix() @ other.matrix())
    assert np.allclose(pose.inverse().matrix(), np.linalg.inv(pose.matrix()))
    assert np.allclose(pose.apply(points), points @ (2 * TURN).T + [1, 2, 3])


def test_evaluate_tells_the_four_errors_apart():
    errors = gmcr.evaluate(make_similarity(), np.eye(4), points=[[0.0, 0, 0], [0, 0, 1]])
    assert errors.scale_error == pytest.approx(1)
    assert errors.rotation_error_deg == pytest.approx(90)
    assert errors.translation_error == pytest.approx(np.sqrt(14))
    assert errors.mean_point_error == pytest.approx((np.sqrt(14) + np.sqrt(1 + 4 + 16)) / 2)
    assert pickle.loads(pickle.dumps(errors)) == errors


def test_evaluate_takes_results_and_problems(problem):
    result = gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.01)
    errors = gmcr.evaluate(result, problem)
    assert errors.rotation_error_deg < 1
    assert errors.mean_point_error is None
