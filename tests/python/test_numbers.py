"""Numbers of all magnitudes: refused by name out of range, and no harm inside it."""

from __future__ import annotations

import gmcr
import numpy as np
import pytest

POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 3, 5]], dtype=float)


def solve(source, target, **keywords):
    keywords = {"noise_bound": 0.01, **keywords}
    return gmcr.register_correspondences(source, target, **keywords)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e-310, 9e-51, -1.1e50, 1e155])
@pytest.mark.parametrize("cloud", ["source", "target"])
def test_a_coordinate_out_of_range_is_refused_by_its_point(cloud, value):
    clouds = {"source": POINTS.copy(), "target": POINTS.copy()}
    clouds[cloud][3, 1] = value
    with pytest.raises(ValueError, match=f"{cloud}: point 3"):
        solve(**clouds)


@pytest.mark.parametrize(
    ("name", "keywords"),
    [
        ("noise_bound", {"noise_bound": 1e158}),
        ("noise_bound", {"noise_bound": 1e-60}),
        ("scale", {"scale": 1e60}),
        ("scale_range", {"scale_mode": "estimated", "scale_range": (1e-60, 1)}),
        ("max_translation", {"max_translation": 1e60}),
    ],
)
def test_an_option_out_of_range_is_refused_by_its_name(name, keywords):
    with pytest.raises(ValueError, match=name):
        solve(POINTS, POINTS, **keywords)


@pytest.mark.parametrize("unit", [1e-40, 1e-3, 1e3, 1e40])
@pytest.mark.parametrize("scale_mode", ["known", "estimated"])
def test_any_unit_in_range_gives_the_same_inliers(unit, scale_mode):
    result = solve(unit * POINTS, unit * POINTS, noise_bound=0.01 * unit, scale_mode=scale_mode)
    assert result.status == "ok"
    assert len(result.inliers) == 5


@pytest.mark.parametrize("mark", [1e20, np.finfo(np.float32).max, -1e50])
def test_a_mark_for_a_missing_point_takes_nothing_from_the_others(mark):
    source, target = POINTS.copy(), POINTS.copy()
    source[4] = mark
    result = solve(source, target)
    assert result.status == "ok"
    assert list(result.inliers) == [0, 1, 2, 3]
