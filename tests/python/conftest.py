"""Problems that several tests share."""

from __future__ import annotations

import os
from pathlib import Path

import gmcr
import numpy as np
import pytest
from hypothesis import HealthCheck, settings

ROOT = Path(__file__).parents[2]

settings.register_profile(
    "gmcr",
    deadline=None,
    derandomize=True,
    database=None,
    max_examples=25,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
settings.load_profile("gmcr")


@pytest.fixture(scope="session")
def problem() -> gmcr.SyntheticProblem:
    """100 correspondences, 40 of them right, known scale 1."""
    return gmcr.make_synthetic(num_correspondences=100, outlier_rate=0.6, seed=3)


@pytest.fixture(scope="session")
def scaled_problem() -> gmcr.SyntheticProblem:
    """100 correspondences, 40 of them right, of an unknown scale from 2 to 3."""
    return gmcr.make_synthetic(
        num_correspondences=100, outlier_rate=0.6, seed=4, scale_range=(2, 3)
    )


@pytest.fixture(scope="session")
def clouds() -> tuple[np.ndarray, np.ndarray, gmcr.Similarity]:
    """A bumpy surface of 3,000 points, the same moved, and the motion."""
    rng = np.random.default_rng(5)
    xy = rng.uniform(-1, 1, (3000, 2))
    height = 0.3 * np.sin(4 * xy[:, 0]) * np.cos(3 * xy[:, 1]) + 0.2 * np.exp(
        -20 * ((xy - [0.4, -0.3]) ** 2).sum(axis=1)
    )
    source = np.column_stack([xy, height])
    motion = gmcr.make_synthetic(num_correspondences=3, outlier_rate=0, seed=9).target_from_source
    target = source @ motion.rotation.T + motion.translation
    return source, target, motion


@pytest.fixture(scope="session")
def tool() -> Path:
    """The command-line tool of the C++ build."""
    for path in (os.environ.get("GMCR_TOOL", ""), ROOT / "build/release/bin/gmcr"):
        if path and Path(path).exists():
            return Path(path)
    pytest.skip("the tool is not built: make build")
