"""Common mistakes, and what each is answered with."""

from __future__ import annotations

import copy
import re
import subprocess
import sys
from functools import partial

import gmcr
import numpy as np
import pytest
from gmcr import _hints

POINTS = np.random.default_rng(8).random((20, 3))
POSE = np.eye(4)


def solve(**keywords):
    return gmcr.register_correspondences(POINTS, POINTS, **keywords)


def bounded(*arguments, **keywords):
    return gmcr.register_correspondences(*arguments, noise_bound=0.1, **keywords)


#: What is called, the error, and words of its message.
MISTAKES = {
    "no bound": (solve, ValueError, "noise_bound: .*write noise_bound=0.05.* noise_bound='auto'"),
    "a bound in words": (
        lambda: solve(noise_bound="5 cm"),
        TypeError,
        "'5 cm' is not a number of metres or 'auto'",
    ),
    "a bound a match": (lambda: solve(noise_bound=[0.1] * 20), TypeError, "write noise_bounds="),
    "no bound for an instance": (
        lambda: gmcr.register_instances(POINTS, POINTS, max_instances=2),
        ValueError,
        "noise_bound='auto'",
    ),
    "no bound for a graph": (
        lambda: gmcr.consistency_graph(POINTS, POINTS),
        ValueError,
        "noise_bound='auto'",
    ),
    "a typo": (
        lambda: bounded(POINTS, POINTS, num_thread=1),
        TypeError,
        r"^register_correspondences\(\) got .* mean 'num_threads'",
    ),
    "a typo in the bounds of a pose": (
        lambda: gmcr.register_clouds(POINTS, POINTS, initial_pose=POSE, max_rotation_err=1),
        TypeError,
        r"^register_clouds\(\) got .* mean 'max_rotation_error'",
    ),
    "a typo in many scans": (
        lambda: gmcr.multiview.register_scans([POINTS, POINTS], voxel_sise=1),
        TypeError,
        r"^register_scans\(\) got .* mean 'voxel_size'",
    ),
    "a typo in a clique": (
        lambda: gmcr.max_clique(np.ones((3, 3), bool), time_limt=1),
        TypeError,
        r"^max_clique\(\) got .* mean 'time_limit'",
    ),
    "a typo in the front end": (
        lambda: gmcr.register_clouds(POINTS, POINTS, voxels=1),
        TypeError,
        r"^register_clouds\(\) got .* mean 'voxel_size'",
    ),
    "a typo in instances": (
        lambda: gmcr.register_instances(POINTS, POINTS, noise_bound=1, max_instance=2),
        TypeError,
        r"^register_instances\(\) got .* mean 'max_instances'",
    ),
    "a typo in a problem": (
        lambda: gmcr.make_synthetic(outliers_rate=0.5),
        TypeError,
        r"^make_synthetic\(\) got .* mean 'outlier_rate'",
    ),
    "a kind as if it were options": (
        lambda: gmcr.make_synthetic("structured"),
        TypeError,
        "write kind='structured'",
    ),
    "TEASER++'s name": (lambda: solve(cbar2=1), TypeError, "write noise_bound="),
    "a flag of the tool": (
        lambda: solve(estimate_scale=True),
        TypeError,
        "'estimate_scale'.* write scale_mode='estimated'",
    ),
    "Open3D's name": (lambda: solve(init=POSE), TypeError, "write initial_pose=pose, max_"),
    "a bound in short": (lambda: solve(noise=0.01), TypeError, "write noise_bound="),
    "a bound of clouds in short": (
        lambda: gmcr.register_clouds(POINTS, POINTS, noise=0.01),
        TypeError,
        "write noise_bound=",
    ),
    "a bound of a rotation": (
        lambda: gmcr.register_clouds(POINTS, POINTS, initial_pose=POSE, max_rotation=0.2),
        TypeError,
        "'max_rotation' is no option: write initial_pose=pose, max_rotation_error=15",
    ),
    "a budget": (lambda: solve(budget=3), TypeError, "write time_limit=10, seconds"),
    "a budget of a clique": (
        lambda: gmcr.max_clique(np.ones((3, 3), bool), budget=3),
        TypeError,
        "write time_limit=10, seconds",
    ),
    "memory in words": (
        lambda: bounded(POINTS, POINTS, memory_limit="4GB"),
        TypeError,
        "memory_limit: '4GB' .* write memory_limit=4000000000$",
    ),
    "memory in other words": (
        lambda: bounded(POINTS, POINTS, memory_limit="1.5 GiB"),
        TypeError,
        "write memory_limit=1610612736$",
    ),
    "memory of a clique in words": (
        lambda: gmcr.max_clique(np.ones((3, 3), bool), max_memory="500mb"),
        TypeError,
        "write max_memory=500000000$",
    ),
    "gravity alone": (
        lambda: bounded(POINTS, POINTS, gravity=[0, 0, 1]),
        TypeError,
        "gravity: write gravity=gmcr.GravityPrior",
    ),
    "a pose alone": (
        lambda: bounded(POINTS, POINTS, initial_pose=POSE),
        TypeError,
        "initial_pose: .*write initial_pose=pose, max_rotation_error=15, max_translation_error=2",
    ),
    "a pose alone, of clouds": (
        lambda: gmcr.register_clouds(POINTS, POINTS, initial_pose=gmcr.Similarity()),
        TypeError,
        "initial_pose: .*write initial_pose=pose, max_rotation_error=15, max_translation_error=2",
    ),
    "bounds without a pose": (
        lambda: bounded(POINTS, POINTS, max_translation_error=1),
        TypeError,
        "max_translation_error: .*initial_pose=pose",
    ),
    "bounds of a pose that has its own": (
        lambda: bounded(
            POINTS, POINTS, initial_pose=gmcr.InitialPose(max_rotation=0.1), max_rotation_error=1
        ),
        TypeError,
        "max_rotation_error: a gmcr.InitialPose has bounds of its own",
    ),
    "bounds beside options": (
        lambda: gmcr.register_correspondences(
            POINTS, POINTS, gmcr.Options(noise_bound=1), max_rotation_error=1
        ),
        TypeError,
        r"give options or keywords \(max_rotation_error\), not both",
    ),
    "more than half a turn": (
        lambda: bounded(POINTS, POINTS, initial_pose=POSE, max_rotation_error=181),
        ValueError,
        r"max_rotation_error: 181 is not in \[0, 180\] degrees",
    ),
    "a distance below 0": (
        lambda: bounded(POINTS, POINTS, initial_pose=POSE, max_translation_error=-1),
        ValueError,
        "max_translation_error: -1 is not >= 0 metres",
    ),
    "a distance in words": (
        lambda: bounded(POINTS, POINTS, initial_pose=POSE, max_translation_error="2 m"),
        TypeError,
        "max_translation_error: '2 m' is not a number of metres",
    ),
    "a rotation as an initial pose": (
        lambda: bounded(POINTS, POINTS, initial_pose=np.eye(3), max_rotation_error=1),
        ValueError,
        r"initial_pose: .*write gmcr.Similarity\(rotation=",
    ),
    "an initial pose that is no similarity": (
        lambda: bounded(POINTS, POINTS, initial_pose=np.ones((4, 4)), max_rotation_error=1),
        ValueError,
        "^initial_pose: ",
    ),
    "three rows of an initial pose": (
        lambda: bounded(POINTS, POINTS, initial_pose=POSE[:3], max_rotation_error=1),
        ValueError,
        r"initial_pose: .*np.vstack\(\[pose, \[0, 0, 0, 1\]\]\)",
    ),
    "a range of a known scale": (
        lambda: bounded(POINTS, POINTS, scale_range=(0.5, 2)),
        ValueError,
        "scale_range: .*write scale_mode='estimated'",
    ),
    "a range from above": (
        lambda: bounded(POINTS, POINTS, scale_range=(2, 0.5)),
        ValueError,
        "scale_range: .*(smallest, largest)",
    ),
    "an unknown word": (
        lambda: bounded(POINTS, POINTS, scale_mode="unknown"),
        ValueError,
        "'unknown' is not one of 'known', 'estimated'",
    ),
    "a bound in place of options": (
        lambda: gmcr.register_correspondences(POINTS, POINTS, 0.1),
        TypeError,
        "write noise_bound=0.1",
    ),
    "options in a dict": (
        lambda: gmcr.register_correspondences(POINTS, POINTS, {"noise_bound": 0.1}),
        TypeError,
        r"write \*\*options",
    ),
    "options in place of the front end": (
        lambda: gmcr.register_clouds(POINTS, POINTS, gmcr.Options()),
        TypeError,
        "frontend: .* write options=",
    ),
    "the front end in place of options": (
        lambda: gmcr.register_clouds(POINTS, POINTS, None, gmcr.FrontendOptions()),
        TypeError,
        "options: .* write frontend=",
    ),
    "a point a column": (lambda: bounded(POINTS.T, POINTS.T), ValueError, "write source.T"),
    "a point a column, of clouds": (
        lambda: gmcr.register_clouds(POINTS, POINTS.T),
        ValueError,
        "write target.T",
    ),
    "more columns of matched points": (
        lambda: bounded(np.ones((20, 4)), POINTS),
        ValueError,
        r"write source\[:, :3\]",
    ),
    "a table of matches": (
        lambda: bounded(np.ones((20, 6)), POINTS),
        ValueError,
        r"write source=source\[:, :3\], target=source\[:, 3:\]",
    ),
    "an organized cloud": (
        lambda: gmcr.register_clouds(np.ones((4, 5, 3)), POINTS),
        ValueError,
        r"write source.reshape\(-1, 3\)",
    ),
    "matched points as a path": (
        lambda: bounded("matches.csv", POINTS),
        ValueError,
        "gmcr.io.read_points.'matches.csv'.*gmcr.batch.read_matches",
    ),
    "a file that is not there": (
        lambda: gmcr.register_clouds("nowhere.ply", POINTS),
        OSError,
        "nowhere.ply",
    ),
    "a cloud in a dict": (
        lambda: gmcr.register_clouds({"x": 1}, POINTS),
        ValueError,
        r"source: .* it is a dict; write np.column_stack\(\[source\['x'\], source\['y'\], ",
    ),
    "points in a dict": (
        lambda: bounded(POINTS, {"points": POINTS}),
        ValueError,
        r"target: .* it is a dict; write target\['points'\]",
    ),
    "no cloud": (
        lambda: gmcr.register_clouds(None, POINTS),
        ValueError,
        "source: expected numbers, but it is a NoneType",
    ),
    "Open3D's name of the pose": (
        lambda: bounded(POINTS, POINTS).transformation,
        AttributeError,
        r"'Result' object has no attribute 'transformation'; write .matrix\(\)",
    ),
    "another name of the pose of clouds": (
        lambda: gmcr.register_clouds(POINTS, POINTS, voxel_size=0.1).pose,
        AttributeError,
        r"'CloudResult' object has no attribute 'pose'; write .matrix\(\)",
    ),
    "a letter for a pose": (
        lambda: gmcr.Similarity().T,
        AttributeError,
        r"'Similarity' object has no attribute 'T'; write .matrix\(\)",
    ),
    "a verb alone": (
        lambda: gmcr.register(POINTS, POINTS),
        AttributeError,
        "'register'; write gmcr.register_clouds.* or gmcr.register_correspondences",
    ),
    "a typo in a function": (
        lambda: gmcr.localize_scan(POINTS, POINTS),
        AttributeError,
        "'localize_scan'; did you mean 'localise_scan'",
    ),
    "a reader without its module": (
        lambda: gmcr.read_points("a.ply"),
        AttributeError,
        "write gmcr.io.read_points",
    ),
    "fields without coordinates": (
        lambda: bounded(np.zeros(5, [("u", float), ("v", float)]), POINTS),
        ValueError,
        "source: expected the fields x, y and z, but there are u, v",
    ),
    "a matrix for a transform": (
        lambda: gmcr.Similarity(POSE),
        TypeError,
        r"^Similarity\(\) takes keywords only; write gmcr.Similarity.from_matrix\(matrix\)",
    ),
    "a matrix for a rough pose": (
        lambda: gmcr.InitialPose(POSE),
        TypeError,
        r"^InitialPose\(\) takes keywords only; write gmcr.InitialPose\(target_from_source=",
    ),
    "a bound without its name": (
        lambda: gmcr.Options(0.05),
        TypeError,
        r"^Options\(\) takes keywords only; write gmcr.Options\(noise_bound=0.05\)",
    ),
    "a matrix in options": (
        lambda: gmcr.Options(initial_pose=POSE),
        TypeError,
        "^initial_pose: a value of type ndarray is not a gmcr.InitialPose; write gmcr.InitialPose",
    ),
    "another library's name in options": (
        lambda: gmcr.Options(noise=1),
        TypeError,
        "keyword argument 'noise': write noise_bound=0.05",
    ),
    "a transform of points by @": (
        lambda: gmcr.Similarity() @ POINTS,
        TypeError,
        r"write pose.apply\(points\) for points",
    ),
    "a covariance without its convention": (
        lambda: bounded(POINTS, POINTS).pose_graph_covariance(),
        TypeError,
        "needs the convention of the pose graph: 'gtsam' or 'ros'",
    ),
    "words for points of a transform": (
        lambda: gmcr.Similarity().apply(["x"]),
        ValueError,
        "^points: expected numbers, but the dtype is <U1",
    ),
    "points where the pose belongs": (
        lambda: gmcr.evaluate_consensus(POINTS, POINTS, POSE, noise_bound=0.1),
        ValueError,
        "the pose comes before the points",
    ),
    "a pose where the result belongs": (
        lambda: gmcr.refine_clouds(POSE, POINTS, POINTS),
        TypeError,
        r"result: .* it is a pose: write gmcr.refine_clouds\(result, .*initial_pose=pose, max_",
    ),
    "rows of unlike length where the result belongs": (
        lambda: gmcr.refine_clouds([[0], [1, 2]], POINTS, POINTS),
        TypeError,
        r"result: .* it is list: write gmcr.refine_clouds\(result, ",
    ),
    "clouds where the result belongs": (
        lambda: gmcr.refine_clouds(POINTS, POINTS, POSE),
        TypeError,
        r"result: .* it is ndarray: write gmcr.refine_clouds\(result, .*initial_pose=pose, max_",
    ),
    "another pose for the result of matches": (
        lambda: gmcr.with_pose(bounded(POINTS, POINTS), POSE),
        TypeError,
        r"result: .* it is Result, .* gmcr.evaluate_consensus\(pose, source, target, ",
    ),
    "another pose for matches": (
        lambda: gmcr.with_pose(gmcr.match(POINTS, POINTS, voxel_size=0.1), POSE),
        TypeError,
        "result: .* it is CloudMatches, .* write result = gmcr.register_clouds",
    ),
    "the pose before the result": (
        lambda: gmcr.with_pose(POSE, POSE),
        TypeError,
        r"result: .* write gmcr.with_pose\(result, pose\)",
    ),
    "the result of matches to be refined by clouds": (
        lambda: gmcr.refine_clouds(bounded(POINTS, POINTS), POINTS, POINTS),
        TypeError,
        "result: .* it is Result: .* for a pose from elsewhere gmcr.register_clouds",
    ),
    "points where the pose of a covariance belongs": (
        lambda: gmcr.evaluate_uncertainty(POINTS, POINTS, POSE, [0, 1, 2], noise_bound=0.1),
        ValueError,
        "the pose comes before the points",
    ),
    "points where inliers belong": (
        lambda: gmcr.evaluate_uncertainty(POSE, POINTS, POINTS, POINTS, noise_bound=0.1),
        ValueError,
        r"inliers: expected indices .* shape \(20, 3\), float64; write result.inliers",
    ),
    "a result where inliers belong": (
        lambda: gmcr.evaluate_uncertainty(
            POSE, POINTS, POINTS, bounded(POINTS, POINTS), noise_bound=0.1
        ),
        ValueError,
        "inliers: .* Result; write result.inliers",
    ),
    "a mask of other matches": (
        lambda: gmcr.evaluate_uncertainty(POSE, POINTS, POINTS, np.ones(19, bool), noise_bound=0.1),
        ValueError,
        r"inliers: .* 20 of True and False, .* shape \(19,\), bool",
    ),
    "a pose where points belong": (
        lambda: gmcr.evaluate_consensus(POSE, POSE, POINTS, noise_bound=0.1),
        ValueError,
        "source: .* it looks like a pose, which comes before the points",
    ),
    "a pose among the points of a covariance": (
        lambda: gmcr.evaluate_uncertainty(POSE, POINTS, POSE, [0, 1, 2], noise_bound=0.1),
        ValueError,
        "target: .* it looks like a pose, which comes before the points",
    ),
    "a pose where the front end belongs": (
        lambda: gmcr.register_clouds(POINTS, POINTS, POSE),
        TypeError,
        "frontend: .* write initial_pose=pose, max_rotation_error=15",
    ),
    "a pose where options belong": (
        lambda: gmcr.register_correspondences(POINTS, POINTS, POSE),
        TypeError,
        "options: .* write initial_pose=pose, max_rotation_error=15",
    ),
    "three rows of a pose": (
        lambda: gmcr.evaluate(POSE[:3], POSE),
        ValueError,
        r"estimate: .*np.vstack\(\[pose, \[0, 0, 0, 1\]\]\)",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_answered_with_what_to_write(mistake):
    call, error, words = MISTAKES[mistake]
    with pytest.raises(error) as caught:
        call()
    assert re.search(words, str(caught.value)), caught.value
    assert "\n" not in str(caught.value)


def test_other_names_are_missing_as_ever():
    result = bounded(POINTS, POINTS)
    for thing in (gmcr, result, gmcr.Similarity()):
        assert not hasattr(thing, "frobnicate")
        with pytest.raises(AttributeError, match=r"has no attribute 'frobnicate'$"):
            _ = thing.frobnicate
    assert np.array_equal(copy.deepcopy(result).matrix(), result.matrix())


def test_submodules_need_no_import_of_their_own():
    code = (
        "import sys, gmcr; assert not [n for n in gmcr._LAZY if f'gmcr.{n}' in sys.modules]; "
        "assert {'io', 'viz', 'batch', 'multiview', 'register_clouds'} <= set(dir(gmcr)); "
        "gmcr.io.read_cloud, gmcr.viz.plot, gmcr.batch.run, gmcr.multiview.register_scans"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def test_no_name_of_elsewhere_is_an_option_here():
    for kind in (
        gmcr.Options,
        gmcr.FrontendOptions,
        gmcr.InstanceOptions,
        gmcr.CliqueOptions,
        gmcr.WeightedCliqueOptions,
        gmcr.SyntheticOptions,
    ):
        assert not _hints.ELSEWHERE.keys() & kind().__getstate__().keys()


def test_a_message_of_a_mesh_or_of_a_ros_message_says_how_to_read_it():
    class Mesh:
        vertices = POINTS

    class Message:
        point_step = 16

    with pytest.raises(ValueError, match=r"source: .*of a mesh sample the surface"):
        gmcr.register_clouds(Mesh(), POINTS)
    with pytest.raises(ValueError, match=r"target: .*point_cloud2.read_points"):
        gmcr.register_clouds(POINTS, Message())


def test_what_is_written_instead_works():
    moved = POINTS + np.array([1, 2, 3])
    near = gmcr.InitialPose(
        target_from_source=gmcr.Similarity(translation=[1, 2, 3]),
        max_rotation=0.2,
        max_translation=1,
    )
    up = gmcr.GravityPrior(source=[0, 0, 1], target=[0, 0, 1], max_tilt=0.03)
    for keywords in (
        {"noise_bound": 0.05},
        {"noise_bound": "auto"},
        {"noise_bound": 0.05, "initial_pose": near},
        {"noise_bound": 0.05, "initial_pose": POSE, "max_translation_error": 4},
        {"noise_bound": 0.05, "gravity": up},
        {"noise_bound": 0.05, "scale_mode": "estimated", "scale_range": (0.5, 2)},
    ):
        result = gmcr.register_correspondences(POINTS, moved, **keywords)
        assert len(result.inliers) == 20, keywords


@pytest.mark.parametrize("bounds", [(10, 0.5), (10, None), (None, 0.5)])
def test_a_pose_with_bounds_beside_it_is_an_initial_pose(problem, bounds):
    truth = problem.target_from_source
    turn, shift = bounds
    limits = {"max_rotation_error": turn, "max_translation_error": shift}
    limits = {name: limit for name, limit in limits.items() if limit is not None}
    prior = gmcr.InitialPose(
        target_from_source=truth,
        max_rotation=np.pi if turn is None else np.radians(turn),
        max_translation=np.inf if shift is None else shift,
    )
    solve_it = partial(gmcr.register_correspondences, problem.source, problem.target)
    expected = solve_it(noise_bound=problem.noise_bound, initial_pose=prior)
    for pose in (truth, truth.matrix(), truth.matrix().tolist(), problem, expected):
        result = solve_it(noise_bound=problem.noise_bound, initial_pose=pose, **limits)
        assert result.certificate.lower >= 39
        if pose is not expected:
            assert np.array_equal(result.matrix(), expected.matrix())


def test_a_pose_with_bounds_is_heeded_by_clouds_and_instances(clouds):
    source, target, motion = clouds
    rough = {"initial_pose": motion.matrix(), "max_rotation_error": 20, "max_translation_error": 1}
    result = gmcr.register_clouds(source, target, voxel_size=0.1, max_attempts=1, **rough)
    assert result.verdict == "trusted"
    rough["initial_pose"] = gmcr.Similarity(translation=[9, 9, 9])
    few = source[::100]
    (first, *_) = gmcr.register_instances(few, few, noise_bound=0.01, **rough)
    assert len(first.inliers) < len(few)


def test_inliers_may_be_a_mask(problem):
    poses = problem.target_from_source, problem.source, problem.target
    mask, indices = (
        gmcr.evaluate_uncertainty(*poses, inliers, noise_bound=problem.noise_bound)
        for inliers in (problem.is_inlier, np.flatnonzero(problem.is_inlier))
    )
    assert np.array_equal(mask.covariance.matrix, indices.covariance.matrix)


def test_auto_is_the_estimated_bound(problem):
    auto, estimated = (
        gmcr.register_correspondences(problem.source, problem.target, **keywords)
        for keywords in ({"noise_bound": "auto"}, {"noise_mode": "estimated"})
    )
    for options in (gmcr.Options(noise_bound="auto"), gmcr.Options()):
        options.noise_bound = "auto"
        assert repr(options) == "Options(noise_mode='estimated')"
    assert auto.noise_estimate.noise_bound == estimated.noise_estimate.noise_bound
    assert np.array_equal(auto.matrix(), estimated.matrix())
