"""Finds bench/paper; skips its tests where what it needs is not installed."""

import sys
from pathlib import Path

import pytest

BENCH = Path(__file__).resolve().parents[3] / "bench"
sys.path.insert(0, str(BENCH))

for _module in ("gmcr", "scipy", "tqdm", "matplotlib"):
    pytest.importorskip(_module, reason=f"{_module} is not installed: bench/paper not tested")
