"""Pose from learned matches: 08_learned_matches.py [MATCHES.npz].

The file holds keypoints_source (P, 3), keypoints_target (Q, 3), matches (M, 2) indices of both, and
confidences (M,) in [0, 1]. Surer matches localise better, so each gets a noise bound of its own.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping

import gmcr
import numpy as np
import numpy.typing as npt

NOISE_BOUND = 0.01  # metres, of a match of confidence 1
LEAST_CONFIDENCE = 0.2


def make_matches() -> dict[str, npt.NDArray[np.generic]]:
    """What a network may give on two views of the same object."""
    problem = gmcr.make_synthetic(num_correspondences=500, outlier_rate=0.8, seed=7)
    rng = np.random.default_rng(7)
    order = rng.permutation(500)
    return {
        "keypoints_source": problem.source,
        "keypoints_target": problem.target[order],
        "matches": np.column_stack([order, np.arange(500)]),
        "confidences": np.where(problem.is_inlier[order], 0.7, 0.4) + rng.uniform(-0.3, 0.3, 500),
    }


def register(data: Mapping[str, npt.NDArray[np.generic]]) -> gmcr.Result:
    """Pose from the matches that are sure enough."""
    confidences = np.asarray(data["confidences"], dtype=np.float64)
    kept = confidences >= LEAST_CONFIDENCE
    rows = np.asarray(data["matches"])[kept]
    return gmcr.register_correspondences(
        data["keypoints_source"][rows[:, 0]],
        data["keypoints_target"][rows[:, 1]],
        noise_bounds=NOISE_BOUND / np.sqrt(np.minimum(confidences[kept], 1)),
    )


def main() -> None:
    print(register(np.load(sys.argv[1]) if len(sys.argv) > 1 else make_matches()))


if __name__ == "__main__":
    main()
