"""Pose from features of one's own: 11_descriptors.py [FEATURES.npz].

The file holds points_source (N, 3), points_target (M, 3), features_source (N, D) and
features_target (M, D), as a network gives them; or bits of binary features, as bool (N, D) or uint8
(N, D / 8).
"""

from __future__ import annotations

import sys
from collections.abc import Mapping

import gmcr
import numpy as np
import numpy.typing as npt

NOISE_BOUND = 0.02  # metres: how far apart two points of a right match may lie


def make_features() -> dict[str, npt.NDArray[np.generic]]:
    """Two views of an object, of whose features noise leaves a part."""
    problem = gmcr.make_synthetic(num_correspondences=600, outlier_rate=0.3, seed=5)
    rng = np.random.default_rng(5)
    features = rng.normal(size=(600, 32)).astype(np.float32)
    order = rng.permutation(600)
    noisy = features + rng.normal(scale=0.8, size=features.shape)
    return {
        "points_source": problem.source,
        "points_target": problem.target[order],
        "features_source": features,
        "features_target": noisy[order].astype(np.float32),
    }


def register(data: Mapping[str, npt.NDArray[np.generic]]) -> gmcr.Result:
    """Pose from what is among the two nearest features both ways."""
    matches = gmcr.match_descriptors(data["features_source"], data["features_target"], k=2)
    print(f"{len(matches.distances)} matches")
    return gmcr.register_correspondences(
        data["points_source"][matches.source_indices],
        data["points_target"][matches.target_indices],
        noise_bound=NOISE_BOUND,
    )


def main() -> None:
    print(register(np.load(sys.argv[1]) if len(sys.argv) > 1 else make_features()))


if __name__ == "__main__":
    main()
