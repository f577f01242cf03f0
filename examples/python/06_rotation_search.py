"""A consensus function of one's own: which of many matched directions agree on a rotation.

Two matches can both be right only where the angle between their directions stays. The largest set
in which all pairs agree is a maximum clique, and no larger one exists.
"""

from __future__ import annotations

import gmcr
import numpy as np
import numpy.typing as npt

Directions = npt.NDArray[np.float64]

NOISE = 0.01  # radians: largest error of a right match


def angles(directions: Directions) -> npt.NDArray[np.float64]:
    """Angle between each two of them, radians, (N, N)."""
    cosines: npt.NDArray[np.float64] = np.clip(directions @ directions.T, -1, 1)
    return np.arccos(cosines)


def consistency(source: Directions, target: Directions) -> npt.NDArray[np.bool_]:
    """Which pairs of matches can be right together, (N, N)."""
    graph = np.abs(angles(target) - angles(source)) <= 2 * NOISE
    np.fill_diagonal(graph, False)
    return graph


def fit(source: Directions, target: Directions) -> npt.NDArray[np.float64]:
    """Rotation that turns the directions best, (3, 3) (Kabsch 1976)."""
    u, _, vt = np.linalg.svd(target.T @ source)
    rotation: npt.NDArray[np.float64] = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
    return rotation


def main() -> None:
    rng = np.random.default_rng(1)
    source, target = rng.normal(size=(2, 300, 3))
    truth = gmcr.make_synthetic(num_correspondences=3, seed=2).target_from_source.rotation
    target[:30] = source[:30] @ truth.T
    source /= np.linalg.norm(source, axis=1, keepdims=True)
    target /= np.linalg.norm(target, axis=1, keepdims=True)
    target[:30] += rng.uniform(-0.003, 0.003, (30, 3))
    target /= np.linalg.norm(target, axis=1, keepdims=True)

    consensus = gmcr.max_clique(consistency(source, target))
    rotation = fit(source[consensus.vertices], target[consensus.vertices])
    error = np.degrees(np.arccos(min(1.0, (np.trace(rotation @ truth.T) - 1) / 2)))
    print(
        f"{len(consensus.vertices)} of 300 agree, at most {consensus.upper_bound} can; "
        f"rotation {error:.2f} deg off"
    )


if __name__ == "__main__":
    main()
