"""How the tool behaves on a terminal, a dumb one, and where colours are not wanted."""

from __future__ import annotations

import os
import pty
import subprocess
from pathlib import Path

import gmcr
import numpy as np
import pytest

CODE = "\x1b["


def on_a_terminal(tool: Path, *arguments: object, **environment: str) -> str:
    """What the tool writes where both of its outputs are a terminal."""
    ours, its = pty.openpty()
    kept = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "TERM")}
    process = subprocess.Popen(
        [str(tool), *map(str, arguments)], stdout=its, stderr=its, stdin=subprocess.DEVNULL,
        env={**kept, "TERM": "xterm-256color", **environment},
    )  # fmt: skip
    os.close(its)
    text = b""
    while True:
        try:
            part = os.read(ours, 4096)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        text += part
    process.wait()
    os.close(ours)
    return text.decode()


@pytest.fixture
def matches(problem: gmcr.SyntheticProblem, tmp_path: Path) -> Path:
    np.save(tmp_path / "matches.npy", np.hstack([problem.source, problem.target]))
    return tmp_path / "matches.npy"


def test_colours_are_for_terminals_that_want_them(tool: Path, matches: Path) -> None:
    command = ("solve", matches, "--noise-bound", "0.01")
    assert CODE in on_a_terminal(tool, *command)
    assert CODE in on_a_terminal(tool, *command, NO_COLOR="")
    assert CODE not in on_a_terminal(tool, *command, NO_COLOR="1")
    assert CODE not in on_a_terminal(tool, *command, TERM="dumb")


@pytest.fixture
def long_matches(tmp_path: Path) -> Path:
    """Matches that keep the solver busy for more than a second."""
    made = gmcr.make_synthetic(
        num_correspondences=400, outlier_rate=0.8, noise_bound=0.4, noise_extent=0.4, seed=3
    )
    np.save(tmp_path / "long.npy", np.hstack([made.source, made.target]))
    return tmp_path / "long.npy"


def test_progress_rewrites_its_line_only_where_it_can(tool: Path, long_matches: Path) -> None:
    command = (
        "solve", long_matches, "--noise-bound", "0.4", "--certify", "--time-limit", "2.5",
    )  # fmt: skip
    text = on_a_terminal(tool, *command)
    assert "\r\x1b[K" in text and "proof" in text
    dumb = on_a_terminal(tool, *command, TERM="dumb")
    assert "\x1b" not in dumb and "gmcr: proof" in dumb
    assert on_a_terminal(tool, *command, "--quiet") == ""
