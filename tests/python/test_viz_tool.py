"""``gmcr register --report`` and ``gmcr solve --report``."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from html import unescape
from pathlib import Path

import gmcr
import numpy as np
import pytest
from gmcr.viz.__main__ import _heading
from gmcr.viz.outcome import outcome_of_json, outcome_of_result

pytest.importorskip("plotly", reason="the extra viz is not installed")


def run(
    tool: Path, *arguments: object, python: str = sys.executable, folder: Path | None = None
) -> subprocess.CompletedProcess:
    return subprocess.run(
        [str(tool), *map(str, arguments)],
        env={**os.environ, "GMCR_PYTHON": python},
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=60,
    )


def text_of(path: Path) -> str:
    """What the page says, without its scripts and tags."""
    page = re.sub(r"<(script|style).*?</\1>", " ", path.read_text(encoding="utf-8"), flags=re.S)
    return " ".join(unescape(re.sub(r"<[^>]*>", " ", page)).split())


@pytest.fixture
def matches(problem: gmcr.SyntheticProblem, tmp_path: Path) -> Path:
    np.save(tmp_path / "matches.npy", np.hstack([problem.source, problem.target]))
    return tmp_path / "matches.npy"


def test_register_writes_a_report_and_nothing_but_json_on_stdout(
    tool: Path, clouds: tuple[np.ndarray, np.ndarray, gmcr.Similarity], tmp_path: Path
) -> None:
    for name, points in zip(("source.npy", "target.npy"), clouds[:2], strict=True):
        np.save(tmp_path / name, points)
    report = tmp_path / "a report.html"
    done = run(
        tool, "register", tmp_path / "source.npy", tmp_path / "target.npy", "--json",
        "--report", report, "--hypotheses", 2,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    result = json.loads(done.stdout)
    text = text_of(report)
    assert f"inliers {result['num_inliers']} of {result['num_correspondences']} (" in text
    reason = result["verdict_reason"]
    assert f"source.npy \u2192 target.npy {result['verdict']} {reason.capitalize()}." in text
    assert text.lower().count(reason.lower()) == 1
    assert str(tmp_path) not in text
    assert "showing all 3,000 points" in text
    assert "num_hypotheses 2" in text
    assert "(100.0 %) pairs of inliers agree" in text
    assert f"gmcr {result['version']}" in text


@pytest.mark.parametrize(
    ("title", "heading"),
    [
        ("/data/a.ply \u2192 /other/b.ply", "a.ply \u2192 b.ply"),
        ("one/scan.ply \u2192 two/scan.ply", "one/scan.ply \u2192 two/scan.ply"),
        ("/far/one/scan.ply \u2192 /far/two/scan.ply", "one/scan.ply \u2192 two/scan.ply"),
        ("/a.ply \u2192 /a.ply", "/a.ply \u2192 /a.ply"),
        ("/data/matches.csv", "matches.csv"),
        ("- \u2192 /data/b.ply", "- \u2192 b.ply"),
        ("Registration", "Registration"),
        ("", ""),
    ],
)
def test_heading_names_files_not_folders(title: str, heading: str) -> None:
    assert _heading(title) == heading


def test_solve_reports_bounds_of_the_matches_and_the_number_of_instances(
    tool: Path, problem: gmcr.SyntheticProblem, tmp_path: Path
) -> None:
    once = np.hstack([problem.source, problem.target, np.linspace(0.02, 0.03, 100)[:, None]])
    elsewhere = once + np.eye(7)[3] * 10
    np.save(tmp_path / "matches.npy", np.vstack([once, elsewhere]))
    report = tmp_path / "report.html"
    done = run(tool, "solve", tmp_path / "matches.npy", "--instances", 3, "--report", report)
    assert done.returncode == 0, done.stderr
    assert f"written       {report}" in done.stdout
    text = text_of(report)
    assert "inliers 40 of 200 (20.0 %)" in text
    assert "instances 2 found" in text
    assert "noise_bounds 200 values" in text


def test_json_of_the_tool_and_result_of_python_are_the_same_outcome(
    tool: Path, matches: Path, problem: gmcr.SyntheticProblem
) -> None:
    done = run(tool, "solve", matches, "--noise-bound", 0.02, "--json")
    found = outcome_of_json(json.loads(done.stdout))
    options = gmcr.Options(noise_bound=0.02)
    expected = outcome_of_result(
        gmcr.register_correspondences(problem.source, problem.target, options), options
    )
    assert found.matrix().tolist() == expected.matrix().tolist()
    assert found.inliers.tolist() == expected.inliers.tolist()
    for name in ("status", "certificate", "evidence", "noise_bound", "version", "verdict"):
        assert getattr(found, name) == getattr(expected, name), name
    labels = [line.label for line in expected.report]
    assert [line.label for line in found.report] == labels
    assert list(found.stages) == list(expected.stages)


def test_a_python_without_the_package_is_refused_before_any_work(
    tool: Path, tmp_path: Path
) -> None:
    for python in ("/nonexistent/python", "false"):
        done = run(
            tool, "solve", tmp_path / "no such file.csv", "--noise-bound", 1,
            "--report", tmp_path / "report.html", python=python,
        )  # fmt: skip
        assert done.returncode == 2
        assert done.stdout == ""
        assert done.stderr == (
            "gmcr: --report needs the Python package gmcr with its viz extra: "
            "pip install '.[viz]' in its sources\n"
        )
    assert list(tmp_path.iterdir()) == []


def test_a_report_runs_nothing_of_the_working_directory(
    tool: Path, matches: Path, tmp_path: Path
) -> None:
    for name in ("gmcr", "runpy", "plotly"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "__init__.py").write_text("raise SystemExit('not of the package')")
    report = tmp_path / "report.html"
    done = run(
        tool, "solve", matches, "--noise-bound", 0.02, "--report", report, folder=tmp_path
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert report.exists()


def test_a_report_that_cannot_be_written_is_an_error_of_files(tool: Path, matches: Path) -> None:
    done = run(tool, "solve", matches, "--noise-bound", 0.02, "--report", "/nonexistent/a.html")
    assert done.returncode == 3
    assert done.stdout == ""
    assert done.stderr == (
        "gmcr: /nonexistent/a.html: cannot be written: "
        "folder /nonexistent: No such file or directory\n"
    )
