"""The example of the batch, as a user runs it."""

import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("tqdm")
EXAMPLE = Path(__file__).parents[2] / "examples" / "python" / "09_batch.py"


def test_the_example_registers_every_pair_but_the_broken_one():
    done = subprocess.run(
        [sys.executable, str(EXAMPLE)], capture_output=True, text=True, timeout=100
    )
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0] == "13 pairs: {'ok': 12, 'error': 1}"
    assert "broken: FileNotFoundError" in lines
    assert lines[-1] == "13 done before"
    assert "100%" in done.stderr
