"""Synthetic problems."""

from __future__ import annotations

import pickle

import gmcr
import numpy as np
import pytest

#: A value of each option that is not the default.
VALUES = {
    "kind": "structured",
    "num_correspondences": 50,
    "outlier_rate": 0.25,
    "seed": 11,
    "noise_shape": "cube",
    "noise_extent": 0.004,
    "noise_bound": 0.03,
    "scale_range": (2.0, 3.0),
    "max_translation": 0.5,
    "num_cloud_points": 700,
    "num_sphere_points": 30,
    "num_bases": 4,
    "source_neighbours": 5,
    "target_neighbours": 12,
    "association_neighbours": 2,
}
#: Changes that show where that value alone would not, or would be refused.
VARIED = {
    "kind": {"kind": "random", "num_correspondences": 90},
    "noise_shape": {"noise_shape": "gaussian"},
    "num_bases": {"num_bases": 20},
    "association_neighbours": {"association_neighbours": 0},
}
#: What each of them is varied from: the structured benchmark reads them all.
BASE = gmcr.make_synthetic(kind="structured")


def bits(problem):
    return problem.source.tobytes(), problem.target.tobytes(), problem.noise_bound


@pytest.mark.parametrize("name", VALUES)
def test_an_option_is_kept_and_changes_the_problem(name):
    assert set(VALUES) == set(gmcr.SyntheticOptions().__getstate__())
    options = pickle.loads(pickle.dumps(gmcr.SyntheticOptions(**{name: VALUES[name]})))
    assert np.array_equal(getattr(options, name), VALUES[name])
    assert repr(options).startswith(f"SyntheticOptions({name}=")
    changed = gmcr.make_synthetic(
        **{"kind": "structured", **VARIED.get(name, {name: VALUES[name]})}
    )
    assert bits(changed) != bits(BASE)


def test_the_truth_explains_the_inliers():
    problem = gmcr.make_synthetic(num_correspondences=40, outlier_rate=0.25, scale_range=(2, 3))
    images = problem.source @ (problem.scale * problem.rotation).T + problem.translation
    residuals = np.linalg.norm(problem.target - images, axis=1)
    assert np.array_equal(problem.is_inlier, residuals <= problem.noise_bound)
    assert problem.is_inlier.sum() == 30
    assert problem.is_inlier.dtype == np.bool_
    assert 2 <= problem.scale <= 3
    assert np.array_equal(problem.matrix(), problem.target_from_source.matrix())


def test_the_paper_s_benchmarks_have_its_settings():
    assert len(gmcr.make_synthetic(kind="random").source) == 80
    assert len(gmcr.make_synthetic(kind="structured").source) == 90


def test_a_model_gives_the_source():
    model = np.array([[0.0, 0, 0], [2, 0, 0], [0, 1, 0], [0, 0, 1]])
    problem = gmcr.make_synthetic(model=model, num_correspondences=4, outlier_rate=0)
    lengths = np.linalg.norm(problem.source[:, None] - problem.source[None], axis=-1)
    assert lengths.max() == pytest.approx(np.sqrt(5) / 2)


def test_problems_survive_pickling():
    other = pickle.loads(pickle.dumps(BASE))
    assert np.array_equal(other.target, BASE.target)
    assert np.array_equal(other.is_inlier, BASE.is_inlier)
    assert np.array_equal(other.matrix(), BASE.matrix())


def test_bad_choices_are_refused():
    with pytest.raises(ValueError, match="kind: 'cube' is not one of 'ball'"):
        gmcr.make_synthetic(kind="cube")
    with pytest.raises(ValueError, match="outlier_rate"):
        gmcr.make_synthetic(outlier_rate=2)
    with pytest.raises(TypeError, match="'rate'"):
        gmcr.make_synthetic(rate=0.5)
    with pytest.raises(TypeError, match="not both"):
        gmcr.make_synthetic(gmcr.SyntheticOptions(), seed=1)
