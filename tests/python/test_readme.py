"""The README is true: each of its commands runs as it stands, and so does its Python."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from gmcr.__main__ import TOOL

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text()
DATA = Path(os.environ.get("GMCR_DATA", ROOT.parent / "shared/data"))
SCANS = {
    "hippo1.ply": DATA / "object_scans/hippo_2_1/target.ply",
    "hippo2.ply": DATA / "object_scans/hippo_2_1/source.ply",
}


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.DOTALL | re.MULTILINE)


def commands() -> list[str]:
    lines = [line for block in blocks("sh") for line in block.splitlines()]
    return [line.partition("  #")[0].strip() for line in lines if line and line[0] != "#"]


def numbers(line: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?\d+\.?\d*(?:e-?\d+)?", line)]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """As a clone after `make demo`, with the tool of this package and the demo's scans."""
    folder = tmp_path_factory.mktemp("clone")
    (folder / "build/demo").mkdir(parents=True)
    for name, other in SCANS.items():
        scan = ROOT / "build/demo" / name
        if not scan.exists():
            scan = other
        if not scan.exists():
            pytest.skip("neither the scans of `make demo` nor the data are here")
        shutil.copy(scan, folder / "build/demo" / name)
    (folder / "build/release/bin").mkdir(parents=True)
    (folder / "build/release/bin/gmcr").symlink_to(TOOL)
    return folder


def run(command: str, folder: Path) -> subprocess.CompletedProcess[str]:
    path = f"{folder}/build/release/bin:{os.environ['PATH']}"
    return subprocess.run(
        ["bash", "-c", command],
        capture_output=True,
        text=True,
        cwd=folder,
        env={**os.environ, "PATH": path, "GMCR_PYTHON": sys.executable},
        timeout=300,
    )


@pytest.mark.parametrize("command", commands())
def test_a_command_runs(command: str, folder: Path) -> None:
    if command.startswith("make "):
        # of a target that is there; .ci/run makes them
        target = command.split()[1]
        assert re.search(rf"^{target}:", (ROOT / "Makefile").read_text(), re.MULTILINE), target
        pytest.skip("it builds")
    if "pip install" in command:
        extra = re.search(r"pip install '\.\[(\w+)\]'", command)
        assert extra and f"\n{extra[1]} = [" in (ROOT / "pyproject.toml").read_text()
        pytest.skip("it needs the network")
    if command.startswith("cmake --install"):
        pytest.skip("tests/consumer installs")
    if command.startswith("build/try/bin/"):  # what the command above installs
        pytest.importorskip("plotly", reason="the extra viz is not installed")
        command = command.replace("build/try/bin/", f"{Path(sys.executable).parent}/")
    done = run(command, folder)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_first_thing_is_what_the_tool_prints(folder: Path) -> None:
    sample = blocks("")[0].splitlines()
    assert sample[0].startswith("$ gmcr register ")
    done = run(sample[0].removeprefix("$ "), folder)
    assert done.returncode == 0, done.stderr
    printed = {line[:13]: line for line in done.stdout.splitlines() if line[:1] != " "}
    for line in sample[1:]:
        assert line[:13] in printed, line
        assert numbers(line) == pytest.approx(numbers(printed[line[:13]]), rel=0.01), line


@pytest.mark.parametrize("code", blocks("python"))
def test_the_python_runs(code: str, folder: Path) -> None:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=folder)
    assert done.returncode == 0, done.stderr
    assert "trusted" in done.stdout
