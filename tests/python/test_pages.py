"""The documentation is true: what its pages show runs, and the site builds without a dead link."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import gmcr
import pytest
from pages import blocks_of, prepare, run_page

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [
    DOCS / f"{name}.md"
    for name in (
        "quickstart",
        "pictures",
        "noise_bound",
        "troubleshooting",
        "which_tool",
        "json",
        "multiview",
        "python",
        "scale",
    )
] + sorted((DOCS / "cookbook").glob("*.md"))


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("pages")
    prepare(made)
    return made


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_what_a_page_shows_runs_and_prints_what_it_says(page, folder, tool, monkeypatch):
    monkeypatch.chdir(folder)
    num_run = run_page(page, folder, tool)
    runnable = [b for b in blocks_of(page.read_text()) if b.language in ("python", "sh")]
    assert num_run == len(runnable)


def test_a_page_that_lies_is_found(tmp_path, tool):
    for block, complaint in (
        ("```python\nprint(1)\n```\n\n```text\n2\n```\n", "lie.md:5: printed\n1"),
        ("```python\n\nraise ValueError('no')\n```\n", "lie.md:1: ValueError: no"),
        ("```sh\ngmcr solv m.csv\n```\n", "lie.md:1: exit code 2"),
    ):
        page = tmp_path / "lie.md"
        page.write_text(block)
        with pytest.raises(AssertionError, match=re.escape(complaint)):
            run_page(page, tmp_path, tool)


def test_the_snippets_of_the_guide_are_parts_of_the_examples():
    examples = [path.read_text() for path in (ROOT / "examples").glob("*.cpp")]
    snippets = [b for b in blocks_of((DOCS / "cpp.md").read_text()) if b.language == "cpp"]
    assert len(snippets) >= 5
    for snippet in snippets:
        assert any(snippet.code in example for example in examples), snippet.code


@pytest.fixture(scope="session")
def site(tmp_path_factory: pytest.TempPathFactory, tool: Path) -> Path:
    pytest.importorskip("mkdocs", reason="the extra docs is not installed")
    out = tmp_path_factory.mktemp("site") / "site"
    done = subprocess.run(
        [sys.executable, ROOT / "site/build.py", "--out", out, "--tool", tool],
        capture_output=True, text=True, env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return out / "html"


def test_the_site_has_every_page_and_fetches_nothing(site):
    pages = list(site.rglob("*.html"))
    assert len(pages) > len(PAGES) + 10
    for page in pages:
        text = page.read_text()
        fetched = re.findall(r"""<(?:script|img|iframe)[^>]*src=["'](?:https?:)?//[^"']*""", text)
        fetched += re.findall(
            r"""<link[^>]*rel=["']stylesheet["'][^>]*href=["'](?:https?:)?//[^"']*""", text
        )
        assert fetched == [], page
        for picture in re.findall(r"""<img[^>]*src=["']([^"']+)""", text):
            assert (page.parent / picture).exists(), f"{page.name}: {picture}"


def test_the_references_hold_what_there_is(site):
    options = (site / "reference/options.html").read_text()
    for name in gmcr.Options().__getstate__():
        assert f"<code>{name}</code>" in options, name
    python = (site / "reference/python.html").read_text()
    for name in ("register_correspondences", "CloudResult", "Covariance"):
        assert f"gmcr.{name}" in python, name
    assert "Transform that most of the correspondences" in python
    command_line = (site / "reference/cli.html").read_text()
    for option in ("--noise-bound", "--max-tilt", "--quiet"):
        assert option in command_line, option


def test_the_reference_of_the_headers_holds_what_is_public_and_nothing_else(site):
    cpp = site / "reference/cpp"
    functions = (cpp / "namespacegmcr.html").read_text()
    for name in ("register_correspondences", "read_cloud", "localise_scan"):
        assert f">{name}</a>" in functions, name
    classes = (cpp / "annotated.html").read_text()
    for name in ("CliqueSolver", "IoError", "CloudResult", "PreparedMap"):
        assert f">{name}</a>" in classes, name
    assert "gmcr_register_clouds" in (cpp / "gmcr_8h.html").read_text()
    files = (cpp / "files.html").read_text()
    for header in (ROOT / "include").rglob("*.h*"):
        assert f"{header.name}<" in files, header
    graph = (cpp / "classgmcr_1_1BitsetGraph.html").read_text()
    assert "mutable_row" in graph and "words_per_row_" not in graph
    assert not list(cpp.glob("*detail*"))


def test_the_pictures_of_the_method_are_drawn_from_what_the_library_returns(tmp_path):
    pytest.importorskip("matplotlib")
    done = subprocess.run(
        [sys.executable, ROOT / "site/draw_method.py", tmp_path], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    drawn = {path.name for path in tmp_path.glob("*.png")}
    assert drawn == {path.name for path in (DOCS / "images").glob("method_*.png")}
    assert drawn and all(name in (DOCS / "pictures.md").read_text() for name in drawn)
