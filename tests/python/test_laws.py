"""Laws of the registration, on random problems."""

from __future__ import annotations

import gmcr
import numpy as np
from hypothesis import given
from hypothesis import strategies as st

seeds = st.integers(0, 10_000)


def make(seed, **keywords) -> gmcr.SyntheticProblem:
    return gmcr.make_synthetic(num_correspondences=40, outlier_rate=0.5, seed=seed, **keywords)


def solve(source, target, noise_bound=0.01, **keywords) -> gmcr.Result:
    return gmcr.register_correspondences(
        source, target, noise_bound=noise_bound, num_threads=1, **keywords
    )


@given(seeds)
def test_a_known_rigid_motion_is_recovered(seed):
    problem = make(seed)
    errors = gmcr.evaluate(solve(problem.source, problem.target), problem, problem.source)
    assert errors.mean_point_error < 0.015


@given(seeds)
def test_a_known_similarity_is_recovered(seed):
    problem = make(seed, scale_range=(0.5, 4))
    result = solve(problem.source, problem.target, scale_mode="estimated")
    assert gmcr.evaluate(result, problem, problem.source).mean_point_error < 0.02


@given(seeds, seeds)
def test_moving_the_target_moves_the_result(seed, other):
    problem = make(seed)
    motion = make(other).target_from_source
    result = solve(problem.source, problem.target)
    moved = solve(problem.source, motion.apply(problem.target))
    assert np.array_equal(moved.inliers, result.inliers)
    # where least squares leaves an inlier outside, the fit that keeps it in follows the axes
    expected = motion @ result.target_from_source
    errors = gmcr.evaluate(moved, expected, problem.source)
    assert errors.mean_point_error < 0.3 * problem.noise_bound


@given(seeds)
def test_permuting_the_correspondences_permutes_the_inliers(seed):
    problem = make(seed)
    order = np.random.default_rng(seed).permutation(40)
    result = solve(problem.source, problem.target)
    permuted = solve(problem.source[order], problem.target[order])
    assert sorted(order[permuted.inliers]) == result.inliers.tolist()
    assert np.allclose(permuted.matrix(), result.matrix(), atol=1e-6)


@given(seeds, st.sampled_from([1e-3, 0.25, 8.0, 1000.0]))
def test_a_change_of_unit_changes_the_translation_alone(seed, unit):
    problem = make(seed)
    result = solve(problem.source, problem.target)
    scaled = solve(unit * problem.source, unit * problem.target, unit * problem.noise_bound)
    assert np.array_equal(scaled.inliers, result.inliers)
    assert np.allclose(scaled.rotation, result.rotation, atol=1e-6)
    assert np.allclose(scaled.translation, unit * result.translation, atol=1e-6 * unit)


@given(seeds)
def test_an_added_outlier_never_lowers_the_bound(seed):
    problem = make(seed)
    source = np.vstack([problem.source, [[9.0, 9, 9]]])
    target = np.vstack([problem.target, [[-7.0, 3, 20]]])
    fewer = solve(problem.source, problem.target, evidence="count")
    more = solve(source, target, evidence="count")
    assert more.certificate.upper >= fewer.certificate.lower
    assert len(more.inliers) >= len(fewer.inliers)


@given(seeds)
def test_the_same_problem_gives_the_same_bits_for_any_number_of_threads(seed):
    problem = make(seed, scale_range=(1, 3))
    one, two = (
        gmcr.register_correspondences(
            problem.source,
            problem.target,
            noise_bound=0.01,
            scale_mode="estimated",
            num_threads=threads,
        )
        for threads in (1, 2)
    )
    assert one.matrix().tobytes() == two.matrix().tobytes()
    assert one.inliers.tobytes() == two.inliers.tobytes()
    assert one.certificate.upper == two.certificate.upper
