"""Keywords as editors and type checkers see them."""

from __future__ import annotations

import enum
import subprocess
import sys
import typing
from pathlib import Path

import gmcr
import jedi
import pytest
from gmcr import _keywords

KINDS = [
    (_keywords.OptionKeywords, gmcr.Options),
    (_keywords.FrontendKeywords, gmcr.FrontendOptions),
    (_keywords.LimitKeywords, gmcr.InstanceOptions),
    (_keywords.CliqueKeywords, gmcr.CliqueOptions),
    (_keywords.WeightedCliqueKeywords, gmcr.WeightedCliqueOptions),
    (_keywords.SyntheticKeywords, gmcr.SyntheticOptions),
]
NEARNESS = {"max_rotation_error", "max_translation_error"}
SOLVER = set(gmcr.Options().__getstate__()) | NEARNESS
CLOUDS = SOLVER | set(gmcr.FrontendOptions().__getstate__())
INSTANCES = SOLVER | set(gmcr.InstanceOptions().__getstate__())
CLIQUES = set(gmcr.CliqueOptions().__getstate__())
WEIGHTED = set(gmcr.WeightedCliqueOptions().__getstate__())
SYNTHETIC = set(gmcr.SyntheticOptions().__getstate__())
OFFERED = {
    "register_correspondences(source, target, ": SOLVER,
    "register_instances(source, target, ": INSTANCES,
    "register_clouds(source, target, ": CLOUDS,
    "match(source, target, ": CLOUDS,
    "refine_clouds(result, source, target, ": SOLVER,
    "with_pose(result, pose, ": SOLVER,
    "evaluate_consensus(pose, source, target, ": SOLVER,
    "evaluate_uncertainty(pose, source, target, inliers, ": SOLVER,
    "consistency_graph(source, target, ": SOLVER,
    "max_clique(graph, ": CLIQUES,
    "max_weight_clique(graph, weights, ": WEIGHTED,
    "make_synthetic(": SYNTHETIC,
    "multiview.register_scans(scans, ": CLOUDS,
    "multiview.register_pairs(scans, ": CLOUDS,
    "viz.plot(result, source, target, ": SOLVER,
    "viz.report(result, source, target, path, ": SOLVER,
}
SUBMODULES = {
    "": {"io", "viz", "batch", "multiview", "register_clouds"},
    "io.read_": {"read_points", "read_cloud"},
}
TYPOS = {
    "register_correspondences(points, points, noise_bond=1)": "noise_bound",
    "register_correspondences(points, points, scale_mode='unknown')": "'estimated'",
    "register_correspondences(points, points, noise_bound='automatic')": "'auto'",
    "register_clouds(points, points, voxel_sise=1)": "voxel_size",
    "register_clouds(points, points, max_rotation_error='15')": "max_rotation_error",
    "register_clouds(points, points, refine='gicp')": "'icp'",
    "register_instances(points, points, max_instance=1)": "max_instances",
    "multiview.register_scans([points], voxel_sise=1)": "voxel_size",
    "max_clique(points, time_limt=1)": "time_limit",
    "make_synthetic(outlier_rat=0.5)": "outlier_rate",
    "Options(evidence='counts')": "'count'",
    "register_clouds(points, points).pose_graph_covariance('g2o')": "'gtsam'",
    "make_synthetic(kind='bal')": "'ball'",
    "register_cloud(points, points)": "register_cloud",
    "io.read_point('a.ply')": "read_point",
    "register_clouds(points, points).transformation": "transformation",
}


@pytest.mark.parametrize(("keywords", "options"), KINDS, ids=lambda kind: kind.__name__)
def test_the_typed_keywords_are_the_options(keywords, options):
    names = list(options().__getstate__())
    if options is gmcr.SyntheticOptions:
        names.remove("kind")  # the argument of that name
    assert list(keywords.__annotations__) == names


@pytest.mark.parametrize("name", [name for name in vars(_keywords) if name.endswith("Word")])
def test_the_typed_words_are_those_that_are_known(name):
    literal, words = typing.get_args(getattr(_keywords, name))
    assert issubclass(words, enum.Enum)
    assert typing.get_args(literal) == tuple(word.value for word in words)


@pytest.mark.parametrize("call", OFFERED, ids=lambda call: call.partition("(")[0])
def test_an_editor_offers_every_option(call):
    script = jedi.Script(
        f"import gmcr\ngmcr.{call}",
        project=jedi.Project(Path(gmcr.__file__).parents[1]),
    )
    offered = {completion.name for completion in script.complete()}
    assert {f"{option}=" for option in OFFERED[call]} <= offered


@pytest.mark.parametrize(("start", "names"), SUBMODULES.items())
def test_an_editor_knows_the_submodules(start, names):
    script = jedi.Script(
        f"import gmcr\ngmcr.{start}", project=jedi.Project(Path(gmcr.__file__).parents[1])
    )
    assert names <= {completion.name for completion in script.complete()}


def test_a_type_checker_finds_a_typo_and_nothing_else(tmp_path):
    right = [
        "register_correspondences(points, points, noise_bound='auto', scale_mode='estimated')",
        "register_correspondences(points, points, method=gmcr.Method.PAPER, scale_range=(1, 2))",
        "register_clouds('a.ply', pathlib.Path('b.ply'), voxel_size=0.1, noise_bound=0.2)",
        "register_instances(points, points, max_instances=2, noise_bound=0.2)",
        "register_clouds(points, points).status.value.upper()",
        "register_clouds(points, points).inliers.astype(int)",
        "InitialPose(target_from_source=points, max_rotation=0.1)",
        "register_clouds(points, points, initial_pose=np.eye(4), max_rotation_error=15)",
        "register_clouds(points, points, initial_pose=gmcr.Similarity(), max_translation_error=2)",
        "register_correspondences(points, points, initial_pose=gmcr.InitialPose(), noise_bound=1)",
        "io.read_points('a.ply').mean(axis=0)",
    ]
    path = tmp_path / "calls.py"
    head = [
        "import pathlib",
        "import gmcr",
        "import numpy as np",
        "points = np.zeros((3, 3))",
    ]
    path.write_text("\n".join([*head, *(f"gmcr.{call}" for call in [*right, *TYPOS])]))
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path / "cache", path],
        capture_output=True, text=True, cwd=tmp_path,
    )  # fmt: skip
    found = [line for line in done.stdout.splitlines() if ": error: " in line]
    first = len(head) + len(right) + 1
    assert len(found) == len(TYPOS), done.stdout
    for line, (error, wanted) in enumerate(zip(found, TYPOS.values(), strict=True), first):
        assert f"calls.py:{line}: " in error
        if wanted != "voxel_size":  # mypy names the nearest option only sometimes
            assert wanted in error
