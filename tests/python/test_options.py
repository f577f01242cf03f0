"""Every option is read, kept, and changes what comes out."""

from __future__ import annotations

import pickle
import re
import time

import gmcr
import numpy as np
import pytest


def go_on(stage: str, fraction: float) -> bool:
    """A callback that can be pickled; others may wrap `print`."""
    return True


#: A value of each option that is not the default.
VALUES = {
    "noise_mode": "estimated",
    "noise_bound": 0.02,
    "noise_bounds": [0.1, 0.2, 0.3],
    "scale_mode": "estimated",
    "scale": 1.5,
    "scale_range": (0.5, 4.0),
    "method": "paper",
    "evidence": "count",
    "gravity": gmcr.GravityPrior(source=[0, 0, 1], target=[0, 1, 0], max_tilt=0.1),
    "initial_pose": gmcr.InitialPose(max_rotation=0.25, max_translation=3),
    "max_translation": 12.0,
    "one_to_one": True,
    "num_hypotheses": 3,
    "certify": True,
    "num_threads": 2,
    "time_limit": 7.0,
    "memory_limit": 123456,
    "progress": go_on,
}


def solve(problem, **keywords):
    keywords.setdefault("noise_bound", problem.noise_bound)
    return gmcr.register_correspondences(problem.source, problem.target, **keywords)


def shown(value):
    return value.tolist() if isinstance(value, np.ndarray) else repr(value)


def test_the_values_are_of_all_options():
    assert set(VALUES) == set(gmcr.Options().__getstate__())


@pytest.mark.parametrize("name", VALUES)
def test_an_option_is_kept_as_keyword_attribute_copy_and_in_its_repr(name):
    default, value = gmcr.Options(), VALUES[name]
    by_keyword = gmcr.Options(**{name: value})
    by_attribute = gmcr.Options()
    setattr(by_attribute, name, value)
    copied = pickle.loads(pickle.dumps(by_keyword))
    assert shown(getattr(by_keyword, name)) != shown(getattr(default, name))
    for options in (by_attribute, copied):
        assert repr(options) == repr(by_keyword)
        assert shown(getattr(options, name)) == shown(getattr(by_keyword, name))
    assert repr(by_keyword).startswith(f"Options({name}=")
    for other in set(VALUES) - {name}:
        assert shown(getattr(by_keyword, other)) == shown(getattr(default, other))


def test_the_defaults_are_those_of_the_signature():
    assert repr(gmcr.Options()) == "Options()"
    assert "time_limit: float = 60.0" in gmcr.Options.__init__.__doc__


def test_an_unknown_name_is_refused(problem):
    with pytest.raises(TypeError, match="unexpected keyword argument 'noise'"):
        gmcr.Options(noise=1)
    with pytest.raises(TypeError, match="'cbar2'"):
        solve(problem, cbar2=1)
    with pytest.raises(AttributeError):
        gmcr.Options().noise = 1
    with pytest.raises(TypeError):
        gmcr.Options(0.02)


@pytest.mark.parametrize(
    ("kind", "name", "advice"),
    [
        (gmcr.Options, "threads", "did you mean 'num_threads'?"),
        (gmcr.Options, "hypotheses", "did you mean 'num_hypotheses'?"),
        (gmcr.Options, "threshold", "divide noise_bound by it"),
        (gmcr.FrontendOptions, "one_to_one", "it is one of Options"),
        (gmcr.InstanceOptions, "min_inliers", "it is called min_instance_inliers"),
        (gmcr.InstanceOptions, "min_share", "it is called min_instance_share"),
    ],
)
def test_an_old_or_misspelt_name_is_refused_with_the_right_one(kind, name, advice):
    with pytest.raises(TypeError, match=re.escape(f"keyword argument '{name}'")) as error:
        kind(**{name: 1})
    assert advice in str(error.value)


def test_messages_name_the_option_as_it_is_written():
    down = gmcr.GravityPrior(source=[0, 0, 0], target=[0, 0, 1])
    with pytest.raises(ValueError, match=r"^gravity\.source: "):
        gmcr.Options(noise_bound=1, gravity=down).validate()
    with pytest.raises(ValueError, match=r"^certify: .*'paper'"):
        gmcr.Options(noise_bound=1, method="paper", certify=True).validate()


def test_docstrings_give_unit_and_range():
    assert gmcr.Options.time_limit.__doc__.endswith("Wall time for the search (seconds, positive).")
    assert "voxels" in gmcr.FrontendOptions.normal_radius.__doc__


def test_options_and_keywords_together_are_refused(problem):
    options = gmcr.Options(noise_bound=1)
    with pytest.raises(TypeError, match="not both"):
        gmcr.register_correspondences(problem.source, problem.target, options, certify=True)
    with pytest.raises(TypeError, match="expected Options, got float"):
        gmcr.register_correspondences(problem.source, problem.target, 0.02)


@pytest.mark.parametrize(
    ("name", "value", "error"),
    [
        ("noise_bound", -1, ValueError),
        ("noise_bound", "wide", TypeError),
        ("noise_bounds", [[1.0]], ValueError),
        ("method", "best", ValueError),
        ("method", 3, TypeError),
        ("scale_range", (1, 2, 3), ValueError),
        ("num_threads", 1.5, TypeError),
        ("num_threads", -2, ValueError),
        ("gravity", (0, 0, 1), TypeError),
        ("progress", 3, TypeError),
    ],
)
def test_a_bad_value_is_an_error_that_names_the_option(problem, name, value, error):
    with pytest.raises(error, match=name):
        solve(problem, **{name: value})


def test_noise_bound_decides_who_is_an_inlier(problem):
    assert len(solve(problem, noise_bound=0.001).inliers) < len(solve(problem).inliers)


def test_noise_bounds_decide_one_by_one(problem):
    bounds = np.full(100, problem.noise_bound)
    first = solve(problem).inliers[0]
    bounds[first] = 1e-9
    result = solve(problem, noise_bound=0, noise_bounds=bounds)
    assert first not in result.inliers
    with pytest.raises(ValueError, match="noise_bounds: 3 values for 100"):
        solve(problem, noise_bound=0, noise_bounds=[1, 1, 1])


def test_noise_mode_estimates_the_bound(problem):
    result = solve(problem, noise_bound=0, noise_mode="estimated")
    assert 0.003 < result.noise_estimate.noise_bound < 0.03
    assert solve(problem).noise_estimate is None


def test_scale_is_the_scale_when_known(scaled_problem):
    assert solve(scaled_problem, scale=scaled_problem.scale).scale == scaled_problem.scale
    assert solve(scaled_problem, scale=scaled_problem.scale).certificate.lower >= 40
    assert len(solve(scaled_problem).inliers) < 10


def test_scale_mode_estimates_the_scale(scaled_problem):
    result = solve(scaled_problem, scale_mode=gmcr.ScaleMode.ESTIMATED)
    assert result.scale == pytest.approx(scaled_problem.scale, rel=0.02)


def test_scale_range_is_where_the_scale_is_searched(scaled_problem):
    inside = solve(scaled_problem, scale_mode="estimated", scale_range=(1.5, 3.5))
    outside = solve(scaled_problem, scale_mode="estimated", scale_range=(0.1, 0.5))
    assert inside.diagnostics.scale_range == (1.5, 3.5)
    assert len(outside.inliers) < len(inside.inliers)


def test_method_paper_runs_the_stages_of_the_paper(problem):
    of_the_paper = {"rotation", "translation"}
    assert of_the_paper <= set(solve(problem, method="paper").diagnostics.stages)
    assert not of_the_paper & set(solve(problem).diagnostics.stages)


def test_evidence_counts_twins_once_or_twice(problem):
    source, target = (np.vstack([p, p]) for p in (problem.source, problem.target))
    count, distinct = (
        gmcr.register_correspondences(source, target, noise_bound=0.01, evidence=evidence)
        for evidence in ("count", "distinct")
    )
    assert count.evidence == len(count.inliers)
    assert distinct.evidence < 0.6 * count.evidence


def test_gravity_admits_only_rotations_that_keep_it(problem):
    up = [0.0, 0, 1]
    gravity = gmcr.GravityPrior(source=up, target=problem.rotation @ up, max_tilt=0.05)
    assert solve(problem, gravity=gravity).certificate.lower >= 39
    gravity.target = -gravity.target
    assert solve(problem, gravity=gravity).certificate.lower < 20


def test_initial_pose_admits_only_poses_near_it(problem):
    truth = problem.target_from_source
    near = gmcr.InitialPose(target_from_source=truth, max_rotation=0.1, max_translation=0.1)
    assert solve(problem, initial_pose=near).certificate.lower >= 39
    far = gmcr.InitialPose(
        target_from_source=gmcr.Similarity(translation=truth.translation + 9),
        max_rotation=np.pi,
        max_translation=1,
    )
    assert len(solve(problem, initial_pose=far).inliers) < 20


def test_an_initial_pose_may_be_a_matrix_or_a_result(problem):
    truth = problem.target_from_source
    near = {"max_rotation": 0.1, "max_translation": 0.1}
    for pose in (truth, truth.matrix(), truth.matrix().tolist(), problem, solve(problem)):
        initial = gmcr.InitialPose(target_from_source=pose, **near)
        assert np.allclose(initial.target_from_source.matrix(), truth.matrix(), atol=0.02)
        assert solve(problem, initial_pose=initial).certificate.lower >= 39
    with pytest.raises(ValueError, match=r"target_from_source: expected a pose.*\(3, 3\)"):
        gmcr.InitialPose(target_from_source=np.eye(3))


def test_a_value_of_a_wrong_type_is_refused_in_words():
    for name, value, words in (
        ("time_limit", "10 s", "'10 s' is not a number"),
        ("num_threads", 1.5, "1.5 is not a whole number"),
        ("memory_limit", -1, "-1 is not a whole number >= 0"),
        ("certify", "no", "'no' is not True or False"),
    ):
        with pytest.raises(TypeError, match=f"^{name}: {words}$"):
            gmcr.Options(**{name: value})


def test_max_translation_admits_only_short_ones(problem):
    assert np.linalg.norm(problem.translation) > 0.3
    assert len(solve(problem, max_translation=0.2).inliers) < 20


def test_one_to_one_does_not_count_shared_points():
    problem = gmcr.make_synthetic(num_correspondences=12, outlier_rate=0, seed=2)
    source = np.vstack([problem.source, np.tile([3.0, 3, 3], (20, 1)) + 1e-4])
    target = np.vstack([problem.target, np.tile([5.0, 5, 5], (20, 1))])
    free = gmcr.register_correspondences(source, target, noise_bound=0.01, evidence="count")
    paired = gmcr.register_correspondences(
        source, target, noise_bound=0.01, evidence="count", one_to_one=True
    )
    assert len(free.inliers) > len(paired.inliers)


def test_the_certificate_gives_the_pose_that_holds_the_most(problem):
    result = solve(problem, noise_bound=0.1)
    certificate = result.certificate
    residuals = problem.target - certificate.target_from_source.apply(problem.source)
    assert (
        certificate.inliers.tolist()
        == np.flatnonzero(np.linalg.norm(residuals, axis=1) <= 0.1).tolist()
    )
    assert certificate.lower == len(certificate.inliers) >= len(result.inliers)
    assert not np.array_equal(certificate.target_from_source.matrix(), result.matrix())


def test_num_hypotheses_returns_alternatives():
    near, far = (
        gmcr.make_synthetic(num_correspondences=n, outlier_rate=0, seed=n) for n in (60, 40)
    )
    source = np.vstack([near.source, far.source])
    target = np.vstack([near.target, far.target])
    result = gmcr.register_correspondences(source, target, noise_bound=0.01, num_hypotheses=2)
    (alternative,) = result.alternatives
    assert len(alternative.inliers) >= 35
    assert set(alternative.inliers.tolist()) <= set(range(60, 100))
    assert result.runner_up_ratio == pytest.approx(alternative.evidence / result.evidence)
    assert np.allclose(alternative.matrix(), far.matrix(), atol=0.02)


def test_certify_proves_what_is_not_proven_without():
    keywords = {"num_correspondences": 120, "noise_bound": 0.15, "noise_extent": 0.15}
    gaps = []
    for seed in range(4):
        problem = gmcr.make_synthetic(outlier_rate=0.8, seed=seed, **keywords)
        plain, proven = (
            solve(problem, certify=certify, evidence="count").certificate
            for certify in (False, True)
        )
        gaps.append((plain.upper - plain.lower, proven.upper - proven.lower))
    assert sum(after for _, after in gaps) < sum(before for before, _ in gaps)


def test_options_say_which_poses_they_admit(problem):
    truth = problem.target_from_source
    length = np.linalg.norm(truth.translation)
    assert gmcr.Options().admit(truth)
    assert gmcr.Options(max_translation=1.01 * length).admit(truth)
    assert not gmcr.Options(max_translation=0.99 * length).admit(truth)


def test_num_threads_are_used_and_do_not_change_the_bits(problem):
    one, two = (solve(problem, num_threads=n) for n in (1, 2))
    assert (one.diagnostics.num_threads, two.diagnostics.num_threads) == (1, 2)
    assert np.array_equal(one.matrix(), two.matrix())
    assert np.array_equal(one.inliers, two.inliers)


def test_time_limit_ends_the_work_and_says_so():
    # hundreds of times the limit would not prove this one
    problem = gmcr.make_synthetic(
        num_correspondences=400, outlier_rate=0.9, noise_bound=0.2, noise_extent=0.2, seed=1
    )
    started = time.perf_counter()
    result = solve(problem, noise_bound=0.2, certify=True, time_limit=0.1)
    assert time.perf_counter() - started < 5
    assert result.diagnostics.limits_hit


def test_memory_limit_is_kept_to(problem):
    with pytest.raises(ValueError, match="memory"):
        solve(problem, memory_limit=10)


def test_progress_is_called_and_may_stop_the_search(scaled_problem):
    calls = []

    def stop(stage, fraction):
        calls.append((stage, fraction))
        return len(calls) < 2

    result = solve(scaled_problem, scale_mode="estimated", progress=stop)
    assert len(calls) == 2
    assert all(isinstance(stage, str) and 0 <= fraction <= 1 for stage, fraction in calls)
    assert result.diagnostics.limits_hit


def test_an_exception_of_progress_reaches_the_caller(problem):
    def fail(stage, fraction):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        solve(problem, progress=fail)


def test_instance_options_end_the_search():
    near, far = (
        gmcr.make_synthetic(num_correspondences=n, outlier_rate=0, seed=n) for n in (60, 20)
    )
    source, target = np.vstack([near.source, far.source]), np.vstack([near.target, far.target])

    def count(**keywords):
        options = gmcr.InstanceOptions(**keywords)
        assert repr(pickle.loads(pickle.dumps(options))) == repr(options)
        found = len(gmcr.register_instances(source, target, None, options, noise_bound=0.01))
        assert found == len(gmcr.register_instances(source, target, noise_bound=0.01, **keywords))
        return found

    assert count() == 2
    assert count(max_instances=1) == 1
    assert count(min_instance_inliers=21) == 1
    assert count(min_instance_share=0.5) == 1
    with pytest.raises(ValueError, match="max_instances"):
        count(max_instances=0)
