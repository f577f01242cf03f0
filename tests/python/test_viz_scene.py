"""What is drawn: samples, motion, residuals, graph and the words for them."""

from __future__ import annotations

import json

import gmcr
import numpy as np
import pytest
from gmcr.viz import DrawLimits, words
from gmcr.viz.motion import Motion, angle_axis
from gmcr.viz.outcome import Outcome, outcome_of_json
from gmcr.viz.prepare import scene_of_result
from gmcr.viz.scene import Scene, make_scene

# so wide that random outliers are all beyond it, so that counts are known
NOISE_BOUND = 0.02


@pytest.fixture(scope="module")
def result(problem: gmcr.SyntheticProblem) -> gmcr.Result:
    return gmcr.register_correspondences(problem.source, problem.target, noise_bound=NOISE_BOUND)


def scene_of(
    result: gmcr.Result,
    problem: gmcr.SyntheticProblem,
    limits: DrawLimits | None = None,
    **keywords: object,
) -> tuple[Outcome, Scene]:
    keywords = keywords or {"noise_bound": NOISE_BOUND}
    return scene_of_result(result, problem.source, problem.target, gmcr.Options(**keywords), limits)


def rotation_about(axis: np.ndarray, angle: float) -> np.ndarray:
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


@pytest.mark.parametrize("angle", [1e-6, 0.3, 2.0, np.pi - 1e-9, np.pi])
def test_angle_and_axis_of_a_rotation_are_those_it_was_made_of(angle: float) -> None:
    for axis in np.random.default_rng(1).normal(size=(20, 3)):
        axis = axis / np.linalg.norm(axis)
        found, found_axis = angle_axis(rotation_about(axis, angle))
        assert found == pytest.approx(angle, abs=1e-9)
        assert rotation_about(found_axis, found) == pytest.approx(
            rotation_about(axis, angle), abs=1e-9
        )


def test_angle_of_no_rotation_is_zero() -> None:
    assert angle_axis(np.eye(3))[0] == 0


def test_motion_leaves_and_arrives_and_its_centre_travels_straight() -> None:
    rng = np.random.default_rng(2)
    points = rng.normal(size=(50, 3))
    rotation = rotation_about(np.array([0.6, 0, 0.8]), 2.5)
    motion = Motion(4.0, rotation, np.array([1.0, 2, 3]), points.mean(axis=0))
    arrived = 4 * points @ rotation.T + [1, 2, 3]
    assert motion.apply(points, 0) == pytest.approx(points)
    assert motion.apply(points, 1) == pytest.approx(arrived)
    halfway = motion.apply(points, 0.5)
    assert halfway.mean(axis=0) == pytest.approx((points.mean(axis=0) + arrived.mean(axis=0)) / 2)
    assert np.linalg.norm(halfway[0] - halfway[1]) == pytest.approx(
        2 * np.linalg.norm(points[0] - points[1])
    )


def test_scene_draws_every_inlier_and_outlier_where_they_are_few(
    result: gmcr.Result, problem: gmcr.SyntheticProblem
) -> None:
    _, scene = scene_of(result, problem)
    assert scene.inliers.indices.tolist() == np.flatnonzero(problem.is_inlier).tolist()
    assert scene.outliers.indices.tolist() == np.flatnonzero(~problem.is_inlier).tolist()
    assert scene.inliers.words("inliers") == "40 inliers"
    assert scene.outliers.words("outliers") == "60 outliers"


def test_what_is_left_out_is_said_and_the_choice_is_the_same_every_time(
    result: gmcr.Result, problem: gmcr.SyntheticProblem
) -> None:
    limits = DrawLimits(points=30, inliers=5, outliers=7, vertices=6)
    outcome, scene = scene_of(result, problem, limits)
    _, again = scene_of(result, problem, limits)
    assert words.drawn(outcome, scene)[:3] == [
        "Source: showing 30 of 100 points",
        "Target: showing 30 of 100 points",
        "Lines: 5 of 40 inliers and 7 of 60 outliers",
    ]
    assert scene.graph is not None and scene.graph.adjacency.shape == (12, 12)
    assert set(scene.inliers.indices) <= set(result.inliers)
    assert not set(scene.outliers.indices) & set(result.inliers)
    assert np.array_equal(scene.source_cloud, again.source_cloud)
    assert np.array_equal(scene.outliers.indices, again.outliers.indices)


def test_residuals_within_the_bounds_are_exactly_those_of_the_inliers(
    problem: gmcr.SyntheticProblem,
) -> None:
    bounds = np.random.default_rng(3).uniform(0.01, 0.03, len(problem.source))
    result = gmcr.register_correspondences(problem.source, problem.target, noise_bounds=bounds)
    _, scene = scene_of(result, problem, noise_bounds=bounds)
    assert scene.bounds == pytest.approx(bounds)
    assert np.flatnonzero(scene.residuals <= scene.bounds).tolist() == result.inliers.tolist()


def test_consensus_graph_holds_all_pairs_of_inliers_and_is_that_of_the_solver(
    result: gmcr.Result, problem: gmcr.SyntheticProblem
) -> None:
    outcome, scene = scene_of(result, problem)
    graph = scene.graph
    assert graph is not None
    assert graph.adjacency[:40, :40].sum() == 40 * 39
    vertices = np.concatenate([graph.inliers.indices, graph.outliers.indices])
    whole = gmcr.consistency_graph(problem.source, problem.target, noise_bound=NOISE_BOUND)
    assert np.array_equal(graph.adjacency, whole[np.ix_(vertices, vertices)])
    assert "780 of 780 (100.0 %) pairs of inliers agree" in words.agreement(scene)
    assert outcome.has_pose


def test_noise_bound_that_was_estimated_is_taken_from_the_result(
    problem: gmcr.SyntheticProblem,
) -> None:
    result = gmcr.register_correspondences(problem.source, problem.target, noise_mode="estimated")
    outcome, scene = scene_of(result, problem, noise_mode="estimated")
    assert scene.bounds == pytest.approx(result.noise_estimate.noise_bound)
    assert dict(words.result_rows(outcome))["noise bound"].startswith(
        f"{outcome.noise_bound:.4g} m chosen from the matches: "
    )


def test_without_the_noise_bound_the_graph_is_left_out_and_that_is_said(
    result: gmcr.Result, problem: gmcr.SyntheticProblem
) -> None:
    _, scene = scene_of(result, problem, num_threads=1)
    assert scene.bounds is None and scene.graph is None
    assert "the noise bound is not known" in words.agreement(scene)


def test_far_points_are_drawn_near_the_origin(problem: gmcr.SyntheticProblem) -> None:
    offset = np.array([5e5, 4e6, 100])
    source, target = problem.source + offset, problem.target + offset
    result = gmcr.register_correspondences(source, target, noise_bound=NOISE_BOUND)
    outcome, scene = scene_of_result(result, source, target, gmcr.Options(noise_bound=0.02), None)
    assert np.abs(scene.target_cloud).max() < 100
    moved = source @ (result.scale * result.rotation).T + result.translation
    assert scene.motion.apply(scene.source_cloud) + scene.origin == pytest.approx(moved, abs=1e-6)
    assert words.drawn(outcome, scene)[-1].startswith("Axes relative to (")


def test_clouds_are_counted_as_given_and_matches_as_found(
    clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity],
) -> None:
    source, target, _ = clouds
    result = gmcr.register_clouds(source, target)
    outcome, scene = scene_of_result(
        result, source, target, gmcr.Options(), DrawLimits(points=1000)
    )
    assert scene.source_points.total == len(source)
    assert len(scene.source_cloud) == 1000
    assert scene.inliers.total == len(result.registration.inliers)
    assert scene.outliers.total == len(result.matches.source) - scene.inliers.total
    assert np.flatnonzero(scene.residuals <= scene.bounds).tolist() == (
        result.registration.inliers.tolist()
    )
    assert words.headline(outcome).text == result.verdict
    assert "verdict" not in dict(words.result_rows(outcome)), "the headline says it"


def test_the_words_are_those_of_the_library(
    result: gmcr.Result, problem: gmcr.SyntheticProblem
) -> None:
    outcome, _ = scene_of(result, problem)
    report = result.report(gmcr.Options(noise_bound=NOISE_BOUND)).splitlines()
    rows = words.result_rows(outcome) + words.pose_rows(outcome)
    assert {"status", "inliers", "certificate", "rotation", "uncertainty"} < dict(rows).keys()
    for label, text in rows:
        assert f"{label:<13} {text}" in report


def test_the_matrix_and_the_stages_are_left_to_the_pictures(
    result: gmcr.Result, problem: gmcr.SyntheticProblem
) -> None:
    outcome, _ = scene_of(result, problem)
    assert [label for label, _ in words.pose_rows(outcome)] == [
        "scale",
        "rotation",
        "translation",
        "uncertainty",
    ]
    texts = [text for _, text in words.result_rows(outcome)]
    stages = tuple(f"{stage:<22} " for stage in outcome.stages)
    assert stages and not [text for text in texts if text.startswith(stages)]


@pytest.mark.parametrize("evidence", [0.0, 3.0])
def test_evidence_of_a_pose_that_the_surfaces_chose_is_said_as_it_is(
    clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity], evidence: float
) -> None:
    fields = json.loads(gmcr.register_clouds(*clouds[:2], num_hypotheses=2).to_json())
    pose = {name: fields[name] for name in ("scale", "rotation", "translation")}
    fields["alternatives"] = [pose | {"evidence": 4.0, "num_inliers": 5, "inliers": []}]
    fields |= {"evidence": evidence, "num_inliers": 1, "inliers": [7], "rivals": []}
    fields["report"] = [
        {"label": "alternatives", "text": "inf % of the evidence, 5 inliers", "tone": ""},
        {"label": "ambiguous", "text": "another pose has 100 % of the evidence", "tone": "bad"},
    ]
    outcome = outcome_of_json(fields)
    assert outcome.consensus == f"evidence {evidence:.1f}, 1 inlier"
    said = "evidence 4.0, 5 inliers; 0 deg and 0 m away"
    assert [other.words for other in outcome.others] == [said]
    assert [line.text for line in outcome.report] == [
        said,
        "the matches speak more for other poses",
    ]
    pytest.importorskip("plotly", reason="the extra viz is not installed")
    from gmcr.viz.page import page

    page_text = page(outcome, scene_of_outcome(outcome, clouds), "Page").partition("<header>")[2]
    assert f'<b id="evidence">{evidence:.1f}</b>' in page_text
    assert f"The returned pose: evidence {evidence:.1f}, 1 inlier." in page_text
    for share in ("inf %", "% of the evidence"):
        assert share not in page_text


def test_shares_of_the_evidence_are_of_the_most(
    clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity],
) -> None:
    fields = json.loads(gmcr.register_clouds(*clouds[:2]).to_json())
    pose = {name: fields[name] for name in ("scale", "rotation", "translation")}
    entry = pose | {"evidence": fields["evidence"] / 4, "num_inliers": 1, "inliers": []}
    rival = pose | {"overlap": 0.97, "is_symmetry": True}
    outcome = outcome_of_json(fields | {"alternatives": [entry], "rivals": [rival]})
    assert [other.words for other in outcome.others] == [
        "25 % of the evidence, 1 inlier; 0 deg and 0 m away",
        "the surfaces meet 97 % as much, a symmetry; 0 deg and 0 m away",
    ]


def scene_of_outcome(
    outcome: Outcome, clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity]
) -> Scene:
    matched = np.zeros((outcome.num_correspondences, 3))
    return make_scene(outcome, clouds[:2], (matched, matched), None, DrawLimits(points=50))


def test_data_without_an_answer_has_no_pose_and_no_graph() -> None:
    points = np.eye(3)[:2]
    result = gmcr.register_correspondences(points, points, noise_bound=0.1)
    outcome, scene = scene_of_result(result, points, points, gmcr.Options(noise_bound=0.1), None)
    assert not outcome.has_pose and scene.graph is None
    assert words.headline(outcome) == ("status", "too few correspondences", "bad")
    assert dict(words.result_rows(outcome))["status"].startswith("too_few_correspondences: ")
    assert words.pose_rows(outcome) == [("pose", "none")]
    assert words.agreement(scene) == "not drawn: there is no pose"


def test_points_and_options_of_another_result_are_refused(
    result: gmcr.Result, problem: gmcr.SyntheticProblem
) -> None:
    with pytest.raises(ValueError, match="noise_bound: an inlier has"):
        scene_of(result, problem, noise_bound=1e-5)
    with pytest.raises(ValueError, match="noise_bound: an inlier has"):
        scene_of_result(
            result, problem.target, problem.source, gmcr.Options(noise_bound=NOISE_BOUND), None
        )
    with pytest.raises(ValueError, match=r"source: shape \(99, 3\)"):
        scene_of_result(result, problem.source[:99], problem.target[:99], gmcr.Options(), None)
    with pytest.raises(TypeError, match="result: expected Result or CloudResult, got str"):
        scene_of_result("ok", problem.source, problem.target, gmcr.Options(), None)  # type: ignore[arg-type]


def test_limits_below_one_are_refused() -> None:
    with pytest.raises(ValueError, match="outliers: 0 is less than 1"):
        DrawLimits(outliers=0)


def test_missing_extra_is_named(
    result: gmcr.Result, problem: gmcr.SyntheticProblem, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    with pytest.raises(ImportError, match=r"pip install '\.\[viz\]'"):
        gmcr.viz.plot(result, problem.source, problem.target)
