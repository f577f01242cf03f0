"""The package as it is installed: types, style, documentation, command line, examples."""

from __future__ import annotations

import dataclasses
import importlib
import importlib.metadata
import inspect
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import gmcr
import numpy as np
import pytest
from gmcr.__main__ import main

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples/python").glob("*.py"))
NOTEBOOKS = sorted((ROOT / "examples/notebooks").glob("*.ipynb"))
SAYS = {
    "01_correspondences": "trusted: ",
    "02_clouds": "trusted: ",
    "03_own_clique_solver": "exact: clique of 80, ",
    "04_priors_and_proof": "without gravity: 40 agree, proven best: True",
    "05_files": "the same bits: True",
    "06_rotation_search": "30 of 300 agree, at most 30 can",
    "07_plane_with_outliers": "40 of 400 points lie on the plane, no plane has more than 40",
    "08_learned_matches": "trusted: ",
}


def run(*command, **keywords):
    return subprocess.run(
        [sys.executable, *map(str, command)], capture_output=True, text=True, **keywords
    )


def test_types_are_checked_strictly(tmp_path):
    package = Path(gmcr.__file__).parent
    assert (package / "py.typed").exists()
    assert (package / "_gmcr.pyi").exists()
    done = run(
        "-m", "mypy", "--strict", "--cache-dir", tmp_path, "-p", "gmcr", cwd=ROOT / "examples"
    )
    assert done.returncode == 0, done.stdout
    done = run("-m", "mypy", "--strict", "--cache-dir", tmp_path, *EXAMPLES, cwd=ROOT / "examples")
    assert done.returncode == 0, done.stdout


def test_the_style_is_clean():
    paths = [ROOT / "python", ROOT / "tests/python", ROOT / "examples/python"]
    done = run("-m", "ruff", "check", "--no-cache", *paths, cwd=ROOT)
    assert done.returncode == 0, done.stdout
    done = run("-m", "ruff", "format", "--check", "--no-cache", *paths, cwd=ROOT)
    assert done.returncode == 0, done.stdout


def test_only_numpy_is_needed_at_run_time():
    needed = importlib.metadata.requires("gmcr")
    assert [name for name in needed if "extra ==" not in name] == ["numpy>=1.22"]
    assert importlib.metadata.version("gmcr") == gmcr.__version__


def test_the_extension_links_what_it_says_and_hides_the_rest():
    extension = Path(gmcr._gmcr.__file__)
    done = run("-B", ROOT / "tests/architecture/linked_test.py", extension)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("name", gmcr.__all__)
def test_everything_public_is_documented(name):
    thing = getattr(gmcr, name)
    if name in ("__version__", "CloudLike", "PointsLike", "PoseLike"):
        return
    assert inspect.getdoc(thing)
    if inspect.isfunction(thing):
        for section in ("Parameters", "Returns", "shape"):
            assert section in thing.__doc__
    if inspect.isclass(thing):
        for field, value in vars(thing).items():
            assert not isinstance(value, property) or value.__doc__, field


@pytest.mark.parametrize("name", ["batch", "io", "multiview", "viz"])
def test_everything_public_of_a_module_is_documented(name):
    module = importlib.import_module(f"gmcr.{name}")
    things = [getattr(module, public) for public in module.__all__]
    ours = [thing for thing in things if getattr(thing, "__module__", "").startswith("gmcr.")]
    assert ours
    for thing in ours:
        said = inspect.getdoc(thing)
        assert said, thing
        if inspect.isfunction(thing):
            says_what = "Returns" in said or "Yields" in said
            assert says_what or thing.__annotations__["return"] == "None", thing
            assert "Parameters" in said, thing
        if dataclasses.is_dataclass(thing):
            listed = ", ".join(re.findall(r"^(\w[\w, ]*) : ", said, re.MULTILINE)).split(", ")
            assert set(vars(thing)["__annotations__"]) <= set(listed), thing


def test_python_m_gmcr_tells_its_version():
    done = run("-m", "gmcr", "info", "--json")
    assert json.loads(done.stdout)["version"] == gmcr.__version__


@pytest.mark.parametrize("suffix", [".npy", ".csv"])
def test_python_m_gmcr_solves_a_file(problem, tmp_path, capfd, suffix):
    path = tmp_path / f"matches{suffix}"
    matches = np.hstack([problem.source, problem.target])
    if suffix == ".npy":
        np.save(path, matches)
    else:
        np.savetxt(path, matches, delimiter=",", header="ax,ay,az,bx,by,bz", comments="")
    arguments = ["solve", str(path), "--noise-bound", "0.01", "--evidence", "count", "--json"]
    assert main(arguments) == 0
    fields = json.loads(capfd.readouterr().out)
    assert fields["status"] == "ok"
    assert fields["num_inliers"] == len(fields["inliers"]) >= 35
    assert len(fields["certificate"]["inliers"]) == fields["certificate"]["lower"] >= 39
    assert main(["solve", str(path), "--noise-bound", "1e-9"]) == 1
    assert main(["solve", str(path), "--noise-bound", "-1"]) == 2
    assert main(["solve", str(tmp_path / "none.npy"), "--noise-bound", "1"]) == 3


def test_a_package_without_the_tool_says_so(monkeypatch, capsys):
    monkeypatch.setattr("gmcr.__main__.TOOL", Path("/nonexistent/gmcr"))
    assert main(["info"]) == 3
    assert "GMCR_BUILD_APPS=OFF" in capsys.readouterr().err


SHARED = (
    "man/man1/gmcr.1",
    "bash-completion/completions/gmcr",
    "zsh/site-functions/_gmcr",
    "fish/vendor_completions.d/gmcr.fish",
)


def test_the_wheel_holds_its_extension_stub_and_tool_alone():
    files = {str(path) for path in importlib.metadata.files("gmcr")}
    assert {"gmcr/_gmcr.pyi", "gmcr/bin/gmcr"} <= files
    assert any(name.startswith("gmcr/_gmcr.") and name.endswith(".so") for name in files)
    assert not [name for name in files if name.startswith(("lib", "include", "bin"))]
    shared = {name.rpartition("share/")[2] for name in files if "/share/" in name}
    assert shared == set(SHARED)  # where man and the shells look, beside the tool


def test_a_source_distribution_holds_what_a_build_reads(tmp_path):
    # scikit-build-core as pip calls it, without the network
    code = "import sys; from scikit_build_core.build import build_sdist; build_sdist(sys.argv[1])"
    done = run("-c", code, tmp_path, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    (archive,) = tmp_path.glob("gmcr-*.tar.gz")
    with tarfile.open(archive) as opened:
        names = {name.partition("/")[2] for name in opened.getnames()}
    listed = subprocess.run(
        ["git", "ls-files", "CMakeLists.txt", "LICENSE", "README.md", "apps", "cmake", "include",
         "pyproject.toml", "python", "src"],
        capture_output=True, text=True, check=True, cwd=ROOT,
    )  # fmt: skip
    assert names >= set(listed.stdout.split())
    assert not [name for name in names if name.startswith(("tests/", "docs/", "build/"))]


def test_nothing_follows_the_last_line_of_a_program():
    code = "import gmcr; kept = gmcr.Options(progress=print); gmcr.kept = kept; print('end')"
    done = run("-c", code)
    assert (done.stdout, done.stderr) == ("end\n", "")


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_runs(path, clouds, tmp_path):
    arguments = []
    if "clouds" in path.name:
        for name, points in zip(("source", "target"), clouds[:2], strict=True):
            np.save(tmp_path / f"{name}.npy", points)
            arguments.append(tmp_path / f"{name}.npy")
    done = run(path, *arguments, env={**os.environ, "PYTHONWARNINGS": "error"})
    assert done.returncode == 0, done.stderr
    assert SAYS.get(path.stem, "") in done.stdout
    assert done.stdout


def test_the_examples_go_from_one_to_eight_in_both_languages():
    for path in (ROOT / "examples", ROOT / "examples/python"):
        names = {each.stem for each in path.glob("0[1-8]_*")}
        assert names == SAYS.keys(), path


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs_and_comes_without_output(path):
    cells = json.loads(path.read_text())["cells"]
    names = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            assert cell["outputs"] == []
            exec("".join(cell["source"]), names)
    assert "gmcr" in names


@pytest.mark.skipif(
    not shutil.which("dpkg-query"), reason="versions are those of Debian's packages"
)
def test_the_bill_of_materials_has_all_that_the_notices_name(tmp_path):
    out = tmp_path / "gmcr.cdx.json"
    done = run(ROOT / "tools/sbom", out)
    assert done.returncode == 0, done.stderr
    named = {part["name"] for part in json.loads(out.read_text())["components"]}
    assert named >= {"eigen", "highway", "onetbb", "numpy", "plotly"}
