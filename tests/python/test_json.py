"""The JSON of results: its schema, the page that lists its fields, and all that write it."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import gmcr
import numpy as np
import pytest
import result_schema
from gmcr.__main__ import TOOL

jsonschema = pytest.importorskip("jsonschema", reason="the extra test is not installed")

ROOT = Path(__file__).parents[2]
VALIDATOR = jsonschema.Draft202012Validator(result_schema.closed())


def validated(text: str) -> dict[str, Any]:
    """The object, which holds all that the schema asks for and nothing that it does not list."""
    fields = json.loads(text)
    VALIDATOR.validate(fields)
    return fields


def run(tool: Path, *arguments: object, code: int = 0) -> dict[str, Any]:
    done = subprocess.run(
        [str(tool), *map(str, arguments), "--json"], capture_output=True, text=True, timeout=120
    )
    assert done.returncode == code, done.stderr
    return validated(done.stdout)


@pytest.fixture
def matches(problem: gmcr.SyntheticProblem, tmp_path: Path) -> Path:
    np.save(tmp_path / "matches.npy", np.hstack([problem.source, problem.target]))
    return tmp_path / "matches.npy"


def checked(*page: Path) -> subprocess.CompletedProcess[str]:
    """What the program says that writes the tables of docs/json.md from the schema."""
    command = [sys.executable, "-B", str(ROOT / "site/json_page.py"), "--check", *map(str, page)]
    return subprocess.run(command, capture_output=True, text=True, timeout=60)


def test_the_page_says_what_the_schema_says(tmp_path: Path) -> None:
    done = checked()
    assert done.returncode == 0, done.stderr
    page = (result_schema.DOCS / "json.md").read_text(encoding="utf-8")
    for meaning in ("R, row by row", "wall time of each stage", "points of the source, as read"):
        assert page.count(meaning) == 1
        (tmp_path / "json.md").write_text(page.replace(meaning, "?"), encoding="utf-8")
        done = checked(tmp_path / "json.md")
        assert done.returncode == 1 and "run site/json_page.py" in done.stderr


def test_the_schema_is_one_and_refuses_what_it_does_not_list(result: gmcr.Result) -> None:
    jsonschema.Draft202012Validator.check_schema(result_schema.SCHEMA)
    fields = validated(result.to_json())
    for change in (
        {"unlisted": 1},
        {"status": "fine"},
        {"rotation": [[1, 0], [0, 1]]},
        {"certificate": {**fields["certificate"], "unlisted": 1}},
        {"limit_codes": ["patience"]},
        {"num_source_voxels": 3},  # and no other field of two clouds
    ):
        assert not VALIDATOR.is_valid({**fields, **change}), change
    for name in ("status", "certificate", "time_ms", "report", "limit_codes"):
        assert not VALIDATOR.is_valid({key: fields[key] for key in fields if key != name}), name


@pytest.mark.parametrize(
    "arguments",
    [
        ("--noise-bound", 0.01),
        ("--noise-bound", "auto"),
        ("--noise-bound", 0.01, "--hypotheses", 3, "--max-translation", 100),
        ("--noise-bound", 0.01, "--estimate-scale", "--certify", "--evidence", "count"),
        ("--noise-bound", 0.01, "--instances", 2, "--min-instance-inliers", 3),
        ("--noise-bound", 0.01, "--method", "paper"),
    ],
)
def test_solve_keeps_the_schema(tool: Path, matches: Path, arguments: tuple[object, ...]) -> None:
    run(tool, "solve", matches, *arguments)


def test_solve_without_a_pose_keeps_the_schema(tool: Path, tmp_path: Path) -> None:
    (tmp_path / "two.csv").write_text("0,0,0,1,1,1\n1,0,0,2,1,1\n")
    for bound in (0.01, "auto"):
        fields = run(tool, "solve", tmp_path / "two.csv", "--noise-bound", bound, code=1)
        assert fields["covariance"] is None


def test_register_keeps_the_schema(
    tool: Path, clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity], tmp_path: Path
) -> None:
    for name, points in zip(("source.npy", "target.npy"), clouds[:2], strict=True):
        np.save(tmp_path / name, points)
    pair = tmp_path / "source.npy", tmp_path / "target.npy"
    assert run(tool, "register", *pair)["refinement"]["method"] == "icp"
    assert run(tool, "register", *pair, "--refine", "none")["refinement"]["note"] == "none"


@pytest.fixture(scope="module")
def result(problem: gmcr.SyntheticProblem) -> gmcr.Result:
    return gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.01)


def test_tool_and_python_write_the_same(tool: Path, matches: Path, result: gmcr.Result) -> None:
    written = run(tool, "solve", matches, "--noise-bound", 0.01)
    ours = validated(result.to_json(gmcr.Options(noise_bound=0.01)))
    assert list(ours) == list(written)
    for name in ours.keys() - {"time_ms", "report"}:
        assert ours[name] == written[name], name
    assert list(ours["time_ms"]) == list(written["time_ms"])
    labels = [line["label"] for line in written["report"]]
    assert [line["label"] for line in ours["report"]] == labels


def test_json_of_python_holds_the_bits_of_the_result(result: gmcr.Result) -> None:
    fields = validated(result.to_json(gmcr.Options(noise_bound=0.01), indent=2))
    assert np.array_equal(fields["target_from_source"], result.matrix())
    assert np.array_equal(fields["covariance"]["matrix"], result.covariance.matrix)
    assert fields["inliers"] == result.inliers.tolist()
    assert fields["noise_bound"] == 0.01
    assert fields["time_ms"]["total"] == pytest.approx(1000 * result.diagnostics.total_seconds)


def test_what_the_options_decide_is_left_out_without_them(result: gmcr.Result) -> None:
    fields = validated(result.to_json())
    assert "\n" not in result.to_json()
    assert "noise_bound" not in fields and "alternatives" not in fields
    asked = gmcr.Options(noise_bound=0.01, num_hypotheses=2)
    assert validated(result.to_json(asked))["alternatives"] == []


def test_clouds_of_python_keep_the_schema(
    clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity],
) -> None:
    result = gmcr.register_clouds(clouds[0], clouds[1])
    fields = validated(result.to_json())
    assert fields["verdict"] == result.verdict
    assert fields["fitness"] == result.fitness
    assert fields["noise_bound"] == result.matches.noise_bound
    assert fields["refinement"]["method"] == "icp"


def test_numbers_that_are_not_finite_are_null(result: gmcr.Result) -> None:
    endless = gmcr.Options(noise_bound=0.01, time_limit=float("inf"))
    assert validated(result.to_json(endless))["options"]["time_limit"] is None


def test_each_limit_has_its_code(problem: gmcr.SyntheticProblem) -> None:
    late = gmcr.register_correspondences(
        problem.source, problem.target, noise_bound=0.01, time_limit=1e-9
    )
    stopped = gmcr.register_correspondences(
        problem.source, problem.target, noise_bound=0.01, progress=lambda *_: False
    )
    for result, code in ((late, "time"), (stopped, "stopped")):
        fields = validated(result.to_json())
        assert code in fields["limit_codes"] == result.diagnostics.limit_codes
        assert fields["limits_hit"] == result.diagnostics.limits_hit
        assert len(fields["limits_hit"]) == len(fields["limit_codes"])


def test_the_tool_of_the_package_writes_all_fields(matches: Path) -> None:
    assert run(TOOL, "solve", matches, "--noise-bound", "0.01")["noise_bound"] == 0.01
    assert "noise_estimate" in run(TOOL, "solve", matches, "--noise-bound", "auto")


def test_a_page_is_made_from_what_the_tool_writes(matches: Path, tmp_path: Path) -> None:
    pytest.importorskip("plotly", reason="the extra viz is not installed")
    from gmcr.viz.__main__ import main as draw

    fields = run(TOOL, "solve", matches, "--noise-bound", "0.01")
    (tmp_path / "result.json").write_text(json.dumps(fields))
    page = tmp_path / "page.html"
    assert draw(["report", f"{tmp_path / 'result.json'}", f"--matches={matches}", f"-o{page}"]) == 0
    assert "35 of 100 (35.0 %)" in page.read_text()


def test_str_is_the_brief_report_and_report_the_full_one(result: gmcr.Result) -> None:
    brief, full = str(result), result.report()
    assert brief.splitlines()[0] == "status        pose found"
    assert f"inliers       {len(result.inliers)} of 100 ({len(result.inliers)}.0 %)" in brief
    assert set(brief.splitlines()) < set(full.splitlines())
    assert "uncertainty" in full and "uncertainty" not in brief
    assert not brief.endswith("\n") and repr(result).count("\n") == 0
    # nothing is claimed of poses that priors, which are not known here, may have excluded
    assert "no admitted pose" in brief
    assert "no admitted pose" not in result.report(gmcr.Options(noise_bound=0.01))


def test_notebooks_show_a_table(
    result: gmcr.Result, clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity]
) -> None:
    assert "pose found" in result._repr_html_()
    html = gmcr.register_clouds(clouds[0], clouds[1])._repr_html_()
    assert html.startswith("<table>") and html.endswith("</table>")
    assert html.count("<tr>") == html.count("</tr>") > 5
    assert "verdict" in html


def test_two_poses_of_nearly_the_same_evidence_are_called_ambiguous() -> None:
    twins = [gmcr.make_synthetic(num_correspondences=n, outlier_rate=0, seed=n) for n in (30, 27)]
    source, target = (np.vstack([getattr(p, name) for p in twins]) for name in ("source", "target"))
    result = gmcr.register_correspondences(source, target, noise_bound=0.01, num_hypotheses=2)
    ratio = result.alternatives[0].evidence / result.evidence
    assert 0.8 < ratio < 1
    assert f"another pose has {100 * ratio:.0f} % of the evidence of this one" in str(result)
    assert validated(result.to_json())["runner_up_ratio"] == pytest.approx(ratio)
