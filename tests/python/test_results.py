"""Every property of the results, with values that differ from each other and from the defaults."""

from __future__ import annotations

import copy
import pickle

import gmcr
import numpy as np
import pytest


@pytest.fixture(scope="module")
def result(scaled_problem) -> gmcr.Result:
    return gmcr.register_correspondences(
        scaled_problem.source,
        scaled_problem.target,
        noise_bound=scaled_problem.noise_bound,
        scale_mode="estimated",
        scale_range=(0.5, 5),
    )


def state(record):
    """All fields as plain values, so that two records compare."""
    if hasattr(record, "__getstate__") and type(record).__module__ == "gmcr._gmcr":
        return {name: state(value) for name, value in record.__getstate__().items()}
    if isinstance(record, list):
        return [state(value) for value in record]
    return record.tolist() if isinstance(record, np.ndarray) else record


def test_the_truth_is_found(result, scaled_problem):
    assert result.scale == pytest.approx(scaled_problem.scale, rel=0.02)
    assert np.allclose(result.rotation, scaled_problem.rotation, atol=0.02)
    assert np.allclose(result.translation, scaled_problem.translation, atol=0.05)


def test_status_is_a_word_and_a_member(result):
    assert result.status == "ok"
    assert result.status is gmcr.Status.OK
    assert f"{result.status}" == "ok"
    assert result.status_reason == ""


def test_each_status_has_its_word():
    points = np.eye(3)
    reasons = {
        "too_few_correspondences": (points[:2], points[:2]),
        "no_consensus": (np.diag([1.0, 2, 3]) * 9, np.diag([5.0, 1, 7])),
        "degenerate": (np.outer(range(5), [1.0, 0, 0]), np.outer(range(5), [1.0, 0, 0])),
    }
    for word, (source, target) in reasons.items():
        result = gmcr.register_correspondences(source, target, noise_bound=1e-3)
        assert result.status == word
        assert result.status_reason


def test_matrix_is_made_of_scale_rotation_and_translation(result):
    expected = np.eye(4)
    expected[:3, :3] = result.scale * result.rotation
    expected[:3, 3] = result.translation
    assert np.allclose(result.matrix(), expected, rtol=1e-15)
    assert np.array_equal(result.matrix(), result.target_from_source.matrix())


def test_inliers_are_those_within_the_bound(result, scaled_problem):
    images = scaled_problem.source @ result.matrix()[:3, :3].T + result.translation
    residuals = np.linalg.norm(scaled_problem.target - images, axis=1)
    assert np.array_equal(result.inliers, np.flatnonzero(residuals <= scaled_problem.noise_bound))
    assert result.inliers.dtype == np.int64


def test_inliers_are_a_view_that_outlives_the_result(scaled_problem):
    inliers = gmcr.register_correspondences(
        scaled_problem.source, scaled_problem.target, noise_bound=0.5
    ).inliers
    assert not inliers.flags.writeable
    assert not inliers.flags.owndata
    assert (np.diff(inliers) > 0).all()


def test_evidence_and_certificate_bound_each_other(result):
    certificate = result.certificate
    assert certificate.lower == len(result.inliers) <= certificate.upper
    assert certificate.certified == (certificate.lower == certificate.upper)
    assert certificate.evidence.lower == result.evidence <= certificate.evidence.upper + 1e-9
    assert 30 < result.evidence <= len(result.inliers)
    assert isinstance(certificate.evidence.certified, bool)


def test_consistent_scales_hold_the_scale(result):
    low, high = result.consistent_scales
    assert low < result.scale < high


def test_covariance_is_seven_by_seven_with_scale(result, problem):
    covariance = result.covariance
    assert covariance.matrix.shape == (7, 7)
    assert np.allclose(covariance.matrix, covariance.matrix.T)
    assert covariance.eigenvalues.shape == (7,)
    assert (np.diff(covariance.eigenvalues) >= 0).all()
    rigid = gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.01)
    assert rigid.covariance.matrix.shape == (6, 6)
    none = gmcr.register_correspondences(np.eye(3)[:2], np.eye(3)[:2], noise_bound=1)
    assert none.covariance is None


def test_diagnostics_tell_what_was_done(result):
    diagnostics = result.diagnostics
    assert diagnostics.num_correspondences == diagnostics.num_used == 100
    assert diagnostics.scale_range == (0.5, 5.0)
    assert diagnostics.num_candidates > 0
    assert diagnostics.num_scale_ranges >= 0  # votes may have closed all
    assert diagnostics.num_threads == gmcr.hardware_threads()
    assert diagnostics.num_clique_nodes >= 0
    assert diagnostics.limits_hit == diagnostics.limit_codes == []
    assert 0 < sum(diagnostics.stages.values()) <= 1.05 * diagnostics.total_seconds + 1e-3


def test_a_proof_searches_ranges_of_scales(scaled_problem):
    result = gmcr.register_correspondences(
        scaled_problem.source,
        scaled_problem.target,
        noise_bound=scaled_problem.noise_bound,
        scale_mode="estimated",
        certify=True,
    )
    assert result.diagnostics.num_scale_ranges > 0
    assert result.certificate.certified


def test_priors_are_counted_in_num_used(problem):
    pose = gmcr.InitialPose(
        target_from_source=problem.target_from_source, max_rotation=0.1, max_translation=0.1
    )
    result = gmcr.register_correspondences(
        problem.source, problem.target, noise_bound=0.01, initial_pose=pose
    )
    assert 38 < result.diagnostics.num_used < 100 == result.diagnostics.num_correspondences


def test_noise_estimate_says_the_bound_and_how_sure(problem):
    options = gmcr.Options(noise_mode="estimated")
    result = gmcr.register_correspondences(problem.source, problem.target, options)
    estimate = result.noise_estimate
    assert estimate.stable_min <= estimate.noise_bound <= estimate.stable_max
    assert estimate.log10_false_alarms < -10
    assert state(pickle.loads(pickle.dumps(estimate))) == state(estimate)


def test_results_survive_pickling_and_copying(result):
    for other in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result), copy.copy(result)):
        assert state(other) == state(result)
        assert repr(other) == repr(result)
        assert np.array_equal(other.matrix(), result.matrix())


def test_limits_survive_pickling_with_their_codes(problem):
    result = gmcr.register_correspondences(
        problem.source, problem.target, noise_bound=0.01, progress=lambda *_: False
    )
    diagnostics = pickle.loads(pickle.dumps(result)).diagnostics
    assert diagnostics.limit_codes == result.diagnostics.limit_codes
    assert diagnostics.limit_codes[0] == "stopped"
    assert diagnostics.limits_hit == result.diagnostics.limits_hit
    assert "caller" in diagnostics.limits_hit[0]


def test_alternatives_survive_pickling():
    twins = [gmcr.make_synthetic(num_correspondences=n, outlier_rate=0, seed=n) for n in (30, 25)]
    source, target = (np.vstack([getattr(p, name) for p in twins]) for name in ("source", "target"))
    result = gmcr.register_correspondences(source, target, noise_bound=0.01, num_hypotheses=2)
    (alternative,) = pickle.loads(pickle.dumps(result)).alternatives
    assert state(alternative) == state(result.alternatives[0])
    assert alternative.scale == 1
    assert alternative.rotation.shape == (3, 3)
    assert alternative.translation.shape == (3,)


def test_the_repr_is_one_readable_line(result):
    text = repr(result)
    assert text.startswith("Result('ok', ")
    assert f"{len(result.inliers)} of 100 inliers" in text
    assert "\n" not in text
    assert "Certificate(lower=" in repr(result.certificate)


def test_fields_are_read_only(result):
    for name in result.__getstate__():
        with pytest.raises(AttributeError):
            setattr(result, name, None)


def test_instances_are_found_one_after_the_other():
    near, far = (
        gmcr.make_synthetic(num_correspondences=n, outlier_rate=0, seed=n) for n in (50, 20)
    )
    first, second = gmcr.register_instances(
        np.vstack([near.source, far.source]),
        np.vstack([near.target, far.target]),
        noise_bound=0.01,
    )
    assert first.certificate.inliers.tolist() == list(range(50))
    assert second.certificate.inliers.tolist() == list(range(50, 70))


def test_the_covariance_comes_as_a_pose_graph_wants_it(result):
    rotation = result.rotation
    ours = result.covariance.matrix[:6, :6]
    gtsam, ros = (result.pose_graph_covariance(word) for word in ("gtsam", "ros"))
    assert gtsam[:3, :3] == pytest.approx(rotation.T @ ours[:3, :3] @ rotation)
    assert gtsam[3:, :3] == pytest.approx(rotation.T @ ours[3:, :3] @ rotation)
    assert ros[3:, 3:] == pytest.approx(ours[:3, :3])
    assert ros[:3, 3:] == pytest.approx(ours[3:, :3])
    with pytest.raises(ValueError, match="convention"):
        result.pose_graph_covariance("g2o")
    assert (
        gmcr.register_correspondences(
            np.zeros((2, 3)), np.zeros((2, 3)), noise_bound=1
        ).pose_graph_covariance("ros")
        is None
    )


def test_evaluate_consensus_agrees_with_the_result(result, scaled_problem):
    options = gmcr.Options(noise_bound=scaled_problem.noise_bound, scale_mode="estimated")
    for pose in (result, result.target_from_source, result.matrix()):
        consensus = gmcr.evaluate_consensus(
            pose, scaled_problem.source, scaled_problem.target, options
        )
        assert len(set(consensus.inliers) ^ set(result.inliers)) <= 1
    assert consensus.evidence == pytest.approx(result.evidence, abs=1)
    assert state(pickle.loads(pickle.dumps(consensus))) == state(consensus)


def test_evaluate_uncertainty_agrees_with_the_result(result, scaled_problem):
    options = gmcr.Options(noise_bound=scaled_problem.noise_bound, scale_mode="estimated")
    uncertainty = gmcr.evaluate_uncertainty(
        result, scaled_problem.source, scaled_problem.target, result.inliers, options
    )
    assert np.allclose(uncertainty.covariance.matrix, result.covariance.matrix)
    assert uncertainty.consistent_scales == pytest.approx(result.consistent_scales)
    assert state(pickle.loads(pickle.dumps(uncertainty))) == state(uncertainty)


def test_consistency_graph_has_an_edge_where_lengths_agree(problem):
    graph = gmcr.consistency_graph(problem.source, problem.target, noise_bound=0.01)
    lengths = [
        np.linalg.norm(p[:, None] - p[None], axis=-1) for p in (problem.source, problem.target)
    ]
    expected = np.abs(lengths[1] - lengths[0]) <= 0.02
    np.fill_diagonal(expected, False)
    assert graph.dtype == np.bool_
    assert np.array_equal(graph, expected)
    with pytest.raises(ValueError, match="scale_range"):
        gmcr.consistency_graph(
            problem.source, problem.target, noise_bound=1, scale_mode="estimated"
        )


def test_consistency_graph_keeps_to_the_priors(problem):
    def graph(**priors):
        return gmcr.consistency_graph(problem.source, problem.target, noise_bound=0.01, **priors)

    pose = gmcr.InitialPose(
        target_from_source=problem.target_from_source, max_rotation=0.1, max_translation=0.1
    )
    plain, near = graph(), graph(initial_pose=pose)
    inliers = np.flatnonzero(problem.is_inlier)
    residuals = problem.target_from_source.apply(problem.source) - problem.target
    is_far = np.linalg.norm(residuals, axis=1) > 0.5
    assert near[np.ix_(inliers, inliers)].sum() == len(inliers) * (len(inliers) - 1)
    assert not (near & ~plain).any()
    assert plain[is_far].any()
    assert not near[is_far].any()


def test_consistency_graph_has_no_edge_between_matches_of_one_point():
    source = np.array([[0.0, 0, 0], [0.01, 0, 0], [0, 1, 0]])
    target = source[[0, 0, 2]]
    graphs = [
        gmcr.consistency_graph(source, target, noise_bound=0.05, one_to_one=value)
        for value in (False, True)
    ]
    assert graphs[0].sum() == 6
    assert graphs[1].tolist() == [[False, False, True], [False, False, True], [True, True, False]]
