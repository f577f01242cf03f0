"""One JSON line a run, appended as it ends, so that a run that was stopped goes on where it was."""

from __future__ import annotations

import json
import os
import platform
import subprocess
from functools import lru_cache
from pathlib import Path

import gmcr
import numpy as np

from paper.data import CHECKOUT


class RecordFile:
    """Records of one experiment in one file, by their keys."""

    def __init__(self, path: Path):
        self.path = path
        path.parent.mkdir(parents=True, exist_ok=True)
        self._drop_torn_line()
        self.keys = {record["key"] for record in read_records(path)}

    def append(self, record: dict) -> None:
        with self.path.open("a") as file:
            file.write(json.dumps(record) + "\n")
        self.keys.add(record["key"])

    def _drop_torn_line(self) -> None:
        """Drop a last line without its end: a run was killed while it wrote."""
        if not self.path.exists():
            return
        text = self.path.read_bytes()
        if text and not text.endswith(b"\n"):
            self.path.write_bytes(text[: text.rfind(b"\n") + 1])


def read_records(path: Path) -> list[dict]:
    """Records of a file, [] where it is absent."""
    if not path.exists():
        return []
    with path.open() as lines:
        return [json.loads(line) for line in lines]


def key_of(experiment: str, fields: dict, method: str) -> str:
    """What tells a run from all others."""
    parts = [f"{name}={fields[name]}" for name in sorted(fields)]
    return "|".join([experiment, *parts, method])


@lru_cache(maxsize=1)
def environment() -> dict:
    """Machine and versions, the same for all records of a run."""
    return {
        "gmcr": gmcr.__version__,
        "commit": _commit(),
        "python": platform.python_version(),
        "numpy": np.__version__,
        "cpu": _cpu_model(),
        "isa": gmcr.instruction_set(),
        "cores": os.cpu_count(),
    }


def _commit() -> str | None:
    """Of the checkout, with a + where files differ from it; None outside of one."""
    command = ["git", "describe", "--always", "--dirty=+", "--abbrev=10"]
    try:
        done = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return done.stdout.strip()


def _cpu_model() -> str:
    cpu_info = Path("/proc/cpuinfo")
    if cpu_info.exists():
        for line in cpu_info.read_text().splitlines():
            if line.startswith("model name"):
                return line.split(": ", 1)[1]
    return platform.processor() or "unknown"
