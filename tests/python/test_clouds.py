"""Registration of clouds and its front end."""

from __future__ import annotations

import pickle

import gmcr
import numpy as np
import pytest

#: A value of each option that is not the default.
VALUES = {
    "voxel_size": 0.1,
    "source_voxel_size": 0.2,
    "normal_radius": 2.5,
    "feature_radius": 6.0,
    "noise_bound_voxels": 1.25,
    "orientation": "outward",
    "source_viewpoint": [1.0, 2, 3],
    "target_viewpoint": [4.0, 5, 6],
    "mutual": False,
    "max_ratio": 0.75,
    "max_attempts": 3,
    "refine": "none",
}


@pytest.fixture(scope="module")
def result(clouds) -> gmcr.CloudResult:
    return gmcr.register_clouds(*clouds[:2], gmcr.FrontendOptions(voxel_size=0.05))


@pytest.mark.parametrize("name", VALUES)
def test_a_frontend_option_is_kept(name):
    assert set(VALUES) == set(gmcr.FrontendOptions().__getstate__())
    options = pickle.loads(pickle.dumps(gmcr.FrontendOptions(**{name: VALUES[name]})))
    assert np.array_equal(getattr(options, name), VALUES[name])
    assert repr(options).startswith(f"FrontendOptions({name}=")


def test_the_motion_of_a_surface_is_found(result, clouds):
    errors = gmcr.evaluate(result, clouds[2])
    assert errors.rotation_error_deg < 3
    assert errors.translation_error < 0.1
    assert result.verdict == "trusted"
    assert result.verdict is gmcr.Verdict.TRUSTED


def test_the_properties_of_a_cloud_result(result, clouds):
    matches, registration = result.matches, result.registration
    assert result.num_source_points == 3000
    assert result.num_target_points == 3000
    assert 0.5 < result.fitness <= 1
    assert 0.5 < result.target_fitness <= 1
    assert 0 < result.overlap_rmse < 0.05
    assert 0 < result.distinct_evidence <= len(registration.inliers)
    assert result.num_attempts >= 1
    assert result.verdict_reason
    assert np.array_equal(result.matrix(), registration.matrix())
    assert np.array_equal(result.target_from_source.matrix(), registration.matrix())
    assert {"voxel", "features", "matching"} <= set(registration.diagnostics.stages)
    assert repr(result).startswith("CloudResult('trusted', fitness=")
    assert registration.inliers.max() < len(matches.source)


def test_a_cloud_result_has_all_that_its_registration_has(result):
    registration = result.registration
    public = {name for name in dir(gmcr.Result) if not name.startswith("_")}
    assert public <= set(dir(gmcr.CloudResult))
    assert result.status is gmcr.Status.OK
    assert (result.status_reason, result.evidence) == ("", registration.evidence)
    assert np.array_equal(result.inliers, registration.inliers)
    assert result.certificate.upper == registration.certificate.upper > 0
    assert np.array_equal(result.covariance.matrix, registration.covariance.matrix)
    for convention in ("gtsam", "ros"):
        of_clouds, of_matches = (
            each.pose_graph_covariance(convention) for each in (result, registration)
        )
        assert of_clouds.shape == (6, 6)
        assert np.array_equal(of_clouds, of_matches)
    assert np.array_equal(result.rotation, registration.rotation)
    assert np.array_equal(result.translation, registration.translation)
    assert (result.scale, result.consistent_scales) == (1, registration.consistent_scales)
    assert result.log10_false_alarms == registration.log10_false_alarms < 0
    assert result.diagnostics.stages == registration.diagnostics.stages
    assert (result.alternatives, result.noise_estimate, result.runner_up_ratio) == ([], None, 0)
    with pytest.raises(ValueError, match="convention: 'g2o' is not 'gtsam' or 'ros'"):
        result.pose_graph_covariance("g2o")


def test_the_inliers_of_a_cloud_result_outlive_it(clouds):
    inliers = gmcr.register_clouds(*clouds[:2], voxel_size=0.1).inliers
    assert not inliers.flags.writeable
    assert inliers.tolist() == sorted(set(inliers.tolist()))


def test_a_different_number_of_points_is_counted_apart(clouds):
    result = gmcr.register_clouds(clouds[0][:2000], clouds[1])
    assert (result.num_source_points, result.num_target_points) == (2000, 3000)


def test_matches_index_the_voxels(clouds):
    frontend = gmcr.FrontendOptions(voxel_size=0.08, source_voxel_size=0.06, noise_bound_voxels=2)
    matches = gmcr.match(*clouds[:2], frontend)
    assert np.array_equal(matches.source, matches.source_voxels[matches.source_indices])
    assert np.array_equal(matches.target, matches.target_voxels[matches.target_indices])
    assert (matches.source_voxel_size, matches.target_voxel_size) == (0.06, 0.08)
    assert matches.noise_bound == pytest.approx(0.16)
    assert matches.filtered
    assert matches.num_radii == 1
    assert set(matches.stages) == {"voxel", "normals", "features", "matching"}
    assert not gmcr.match(*clouds[:2], gmcr.FrontendOptions(mutual=False)).filtered
    assert gmcr.match(*clouds[:2], noise_bound=0.3).noise_bound == 0.3


def test_cloud_results_survive_pickling(result):
    other = pickle.loads(pickle.dumps(result))
    assert repr(other) == repr(result)
    for name in ("source", "target", "source_voxels", "target_voxels", "target_indices"):
        assert np.array_equal(getattr(other.matches, name), getattr(result.matches, name))
    assert other.verdict is result.verdict


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("voxel_size", 0.11),
        ("source_voxel_size", 0.15),
        ("normal_radius", 3.5),
        ("feature_radius", 3.0),
        ("orientation", "outward"),
        ("source_viewpoint", [0, 0, -50]),
        ("target_viewpoint", [9, -7, -50]),
        ("mutual", False),
        ("max_ratio", 0.8),
    ],
)
def test_a_frontend_option_changes_the_matches(clouds, name, value):
    base = gmcr.FrontendOptions(voxel_size=0.08, orientation="toward_viewpoint")
    changed = gmcr.FrontendOptions(voxel_size=0.08, orientation="toward_viewpoint")
    setattr(changed, name, value)
    before, after = (gmcr.match(*clouds[:2], frontend) for frontend in (base, changed))
    assert before.target.tobytes() != after.target.tobytes()


def test_the_refinement_is_on_unless_told_otherwise(clouds, result):
    source, target, truth = clouds
    assert result.refinement.method == "icp"
    assert result.refinement.is_applied
    assert 0 < result.refinement.noise < result.matches.target_voxel_size
    plain = gmcr.register_clouds(source, target, voxel_size=0.08, refine="none")
    assert plain.refinement.method == "none"
    later = gmcr.refine_clouds(plain, source, target)
    errors = [
        gmcr.evaluate(pose.matrix(), truth, source).mean_point_error for pose in (plain, later)
    ]
    assert errors[1] < 0.5 * errors[0]


def test_surfaces_say_how_they_meet(result):
    surfaces = result.surfaces
    assert 0.3 < surfaces.source_share <= 1
    assert 0.3 < surfaces.target_share <= 1
    assert surfaces.agreement > 0.6
    assert surfaces.weak_directions == []
    assert result.rivals == []
    assert not result.mirrored_is_worse
    assert not result.found_by_turning


def test_poses_are_judged_on_the_voxels_of_the_first_attempt(result, clouds):
    voxels = result.voxels
    first = gmcr.match(*clouds[:2], gmcr.FrontendOptions(voxel_size=0.05))
    assert np.array_equal(voxels.source, first.source_voxels)
    assert np.array_equal(voxels.target, first.target_voxels)
    assert voxels.source_voxel_size == first.source_voxel_size
    assert voxels.target_voxel_size == first.target_voxel_size


def test_a_plane_leaves_motions_open():
    rng = np.random.default_rng(1)
    clouds = [np.column_stack([rng.uniform(0, 1, (4000, 2)), np.zeros(4000)]) for _ in range(2)]
    result = gmcr.register_clouds(clouds[0], clouds[1] + [0, 0, 0.01], max_attempts=8)
    assert result.verdict == "untrusted"
    for direction in result.surfaces.weak_directions:
        assert np.linalg.norm(direction.turn) + np.linalg.norm(direction.shift) > 0.9


def test_one_to_one_leaves_one_match_a_target(clouds):
    frontend = gmcr.FrontendOptions(voxel_size=0.08, mutual=False)
    shared = gmcr.match(*clouds[:2], frontend).target_indices
    single = gmcr.match(*clouds[:2], frontend, one_to_one=True).target_indices
    assert len(np.unique(shared)) < len(shared)
    assert len(np.unique(single)) == len(single)


def test_keywords_are_of_both_kinds_of_options(clouds):
    frontend = gmcr.FrontendOptions(voxel_size=0.08, mutual=False)
    given = gmcr.match(*clouds[:2], frontend, gmcr.Options(noise_bound=0.05))
    by_name = gmcr.match(*clouds[:2], voxel_size=0.08, mutual=False, noise_bound=0.05)
    assert by_name.noise_bound == given.noise_bound == 0.05
    assert by_name.target.tobytes() == given.target.tobytes()
    with pytest.raises(TypeError, match="not both"):
        gmcr.match(*clouds[:2], frontend, voxel_size=0.1)
    with pytest.raises(TypeError, match="'voxels'"):
        gmcr.register_clouds(*clouds[:2], voxels=0.1)


def test_max_attempts_bounds_the_settings_that_are_tried():
    noise = np.random.default_rng(1).random((2, 400, 3))
    once, twice = (
        gmcr.register_clouds(*noise, gmcr.FrontendOptions(max_attempts=n)).num_attempts
        for n in (1, 2)
    )
    assert (once, twice) == (1, 2)


def test_with_pose_judges_another_pose(result, clouds):
    worse = gmcr.with_pose(result, np.eye(4))
    assert worse.fitness < result.fitness
    assert np.array_equal(worse.matrix(), np.eye(4))


def test_voxel_grid_is_the_mean_of_each_cell():
    means = gmcr.voxel_grid([[0, 0, 0], [0.2, 0, 0], [5, 5, 5]], 1)
    assert means.tolist() == [[0.1, 0, 0], [5, 5, 5]]
    for bad in (0, -1, np.nan):
        with pytest.raises(ValueError, match="voxel_size"):
            gmcr.voxel_grid([[0, 0, 0]], bad)


def test_fpfh_has_a_row_of_33_a_point_and_ignores_motion(clouds):
    source, target, _ = clouds
    outward = gmcr.FrontendOptions(orientation="outward")
    features, moved = (
        gmcr.fpfh(points[:500], voxel_size=0.1, frontend=outward) for points in (source, target)
    )
    assert features.shape == (500, 33)
    assert features.dtype == np.float32
    sums = features.sum(axis=1)
    assert np.allclose(sums[sums > 0], 600, atol=0.1)
    assert (sums > 0).mean() > 0.9
    assert np.median(np.abs(features - moved).max(axis=1)) < 1
    with pytest.raises(ValueError, match="voxel_size"):
        gmcr.fpfh(source, voxel_size=0)


def test_empty_clouds_are_a_status():
    result = gmcr.register_clouds(np.empty((0, 3)), np.empty((0, 3)))
    assert result.registration.status == "too_few_correspondences"
    assert result.verdict == "untrusted"
