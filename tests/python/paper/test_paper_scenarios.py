"""The problems of each experiment are as its definition says."""

import numpy as np
import pytest
from paper.data import DataAbsent
from paper.problem import Pose
from paper.scenarios import EXPERIMENTS, drawing, lidar, objects, real, scaling, synthetic

ALIGNED = Pose(1.0, np.eye(3), np.zeros(3))


def cases_of(name):
    try:
        return list(EXPERIMENTS[name].cases(True))
    except DataAbsent as absence:
        pytest.skip(str(absence))


@pytest.mark.parametrize("name", EXPERIMENTS)
def test_the_same_case_is_the_same_problem_and_no_two_share_their_fields(name):
    cases = cases_of(name)
    assert cases[-1].make().input_hash() == cases[-1].make().input_hash()
    fields = [tuple(sorted(case.fields.items())) for case in cases]
    assert len(set(fields)) == len(fields)


@pytest.mark.parametrize("name", EXPERIMENTS)
def test_a_quick_run_is_part_of_the_full_one(name):
    quick = [case.fields for case in cases_of(name)]
    full = [case.fields for case in EXPERIMENTS[name].cases(False)]
    assert len(full) > len(quick)
    assert all(fields in full for fields in quick)


@pytest.mark.parametrize("name", EXPERIMENTS)
def test_each_problem_is_drawn_from_a_seed_of_its_own(name):
    # noise: the same rotation of a pair at all of its bounds
    problems = [
        case.make() for case in cases_of(name)[:6] if case.fields.get("bound_factor", 1) == 1
    ]
    assert len(problems) > 0
    assert len({problem.seed for problem in problems}) == len(problems)


def test_a_seed_is_the_same_everywhere_and_differs_by_each_field():
    assert drawing.seed_of("bunny", 40, 0.5, 0) == 2011305382
    seeds = {drawing.seed_of(*case) for case in [("a", 1), ("a", 11), ("a1", 1), ("b", 1), ("a",)]}
    assert len(seeds) == 5
    assert all(0 <= seed < 2**31 for seed in seeds)


def test_synthetic_problems_have_the_inliers_of_their_rate():
    for case in cases_of("synthetic")[:12]:
        problem, fields = case.make(), case.fields
        count = fields["num_correspondences"]
        assert problem.source.shape == problem.target.shape == (count, 3)
        assert problem.is_inlier.sum() == round((1 - fields["outlier_rate"]) * count)
        assert 1 <= problem.truth.scale <= 5


def test_scaling_problems_have_known_scale_and_noise_within_the_bound():
    problem = scaling.make_problem(200, 0.9, 1)
    assert problem.truth.scale == 1
    assert problem.is_inlier.sum() == 20


def test_lidar_problems_have_100_near_inliers_and_300_outliers_turned_about_z():
    problem = cases_of("lidar")[0].make()
    assert len(problem.source) == lidar.NUM_INLIERS + lidar.NUM_OUTLIERS
    assert problem.is_inlier.sum() == lidar.NUM_INLIERS
    assert problem.truth.rotation @ [0, 0, 1] == pytest.approx([0, 0, 1])
    assert np.abs(problem.truth.translation).max() <= lidar.MAX_TRANSLATION


@pytest.mark.parametrize("setting", ["random", "structured"])
def test_object_problems_have_as_many_inliers_as_outliers_at_a_scale_in_the_range(setting):
    case = next(case for case in cases_of("objects") if case.fields["setting"] == setting)
    problem = case.make()
    assert len(problem.source) == objects.NUM_INLIERS + objects.NUM_OUTLIERS
    assert problem.is_inlier.sum() == objects.NUM_INLIERS
    assert 0.5 <= problem.truth.scale <= 2


def test_real_matches_keep_the_inliers_that_the_data_lists():
    problem = next(c for c in cases_of("real") if c.fields["set"] == "gore").make()
    turned = real.make_problem("kitti_fpfh", real.pairs_of("kitti_fpfh")[0], seed=3)
    assert turned.is_inlier.sum() == 110  # within 0.6 m, by the data's own table
    assert problem.noise_bound != turned.noise_bound


def test_a_larger_bound_makes_more_inliers():
    cases_of("noise")
    folder = real.pairs_of("gore")[0]
    counts = [real.make_problem("gore", folder, 0, x).is_inlier.sum() for x in (0.5, 1.0, 2.0)]
    assert counts == sorted(counts) and counts[0] < counts[2]


def test_structured_outliers_lie_near_their_bases_and_are_no_inliers():
    random = np.random.default_rng(2)
    cloud = random.uniform(-1, 1, (500, 3))
    bases = drawing.random_outliers(cloud, cloud, ALIGNED, 0.1, 4, random)
    drawn = drawing.structured_outliers(cloud, cloud, ALIGNED, 0.1, bases, 60, random)
    assert drawn.shape == (60, 2)
    assert len(np.unique(drawn, axis=0)) == 60
    gaps = np.linalg.norm(cloud[drawn[:, 0]] - cloud[drawn[:, 1]], axis=1)
    assert gaps.min() > 0.1
    for source, target in drawn:
        near = [
            rank(cloud, base[0], source) <= drawing.NEIGHBOURS
            and rank(cloud, base[1], target) <= drawing.NEIGHBOURS
            for base in bases
        ]
        assert any(near)


def rank(cloud, base, point):
    """How many points are nearer to the base."""
    distances = np.linalg.norm(cloud - cloud[base], axis=1)
    return int((distances < distances[point]).sum())


def test_outliers_that_the_bound_leaves_no_room_for_are_an_error(monkeypatch):
    monkeypatch.setattr(drawing, "MAX_DRAWS", 3)
    random = np.random.default_rng(0)
    cloud = random.uniform(-0.1, 0.1, (30, 3))
    with pytest.raises(ValueError, match="noise_bound: 5"):
        drawing.random_outliers(cloud, cloud, ALIGNED, 5.0, 4, random)


def test_nearest_pairs_are_within_the_distance_under_the_truth():
    random = np.random.default_rng(4)
    source = random.uniform(-1, 1, (200, 3))
    truth = drawing.random_pose(random, 1.0, (0.5, 2.0))
    target = truth.apply(source)[::-1] + 0.0001
    pairs = drawing.nearest_pairs(source, target, truth, 0.02)
    assert (pairs[:, 0] + pairs[:, 1] == 199).all() and len(pairs) == 200
    with pytest.raises(ValueError, match="201 are needed"):
        drawing.draw_inliers(pairs, 201, random)


def test_an_absent_model_names_the_way_out(monkeypatch, tmp_path):
    monkeypatch.setenv("GMCR_DATA", str(tmp_path))
    synthetic.load_model.cache_clear()
    with pytest.raises(DataAbsent, match="GMCR_DATA"):
        synthetic.load_model("bunny")
