"""The consensus graph for another model: the plane that most points with normals agree on.

Two points can lie on one plane only where their normals agree and each lies in the plane of the
other.
"""

from __future__ import annotations

import gmcr
import numpy as np
import numpy.typing as npt

Vectors = npt.NDArray[np.float64]

THICKNESS = 0.02  # metres: largest distance of a point from its plane
TILT = 0.1  # radians: largest error of a normal


def consistency(points: Vectors, normals: Vectors) -> npt.NDArray[np.bool_]:
    """Which pairs of points can lie on one plane, (N, N)."""
    between = points[None, :] - points[:, None]
    slack = 2 * THICKNESS + np.sin(TILT) * np.linalg.norm(between, axis=2)
    is_flat = np.abs(np.einsum("ijk,ik->ij", between, normals)) <= slack
    is_parallel = normals @ normals.T >= np.cos(2 * TILT)
    graph: npt.NDArray[np.bool_] = is_parallel & is_flat & is_flat.T
    np.fill_diagonal(graph, False)
    return graph


def main() -> None:
    rng = np.random.default_rng(2)
    truth = np.array([0.2, -0.3, 1]) / np.linalg.norm([0.2, -0.3, 1])
    points, normals = rng.uniform(-1, 1, (2, 400, 3))
    heights = points[:40] @ truth - rng.uniform(-THICKNESS / 2, THICKNESS / 2, 40)
    points[:40] -= heights[:, None] * truth
    normals[:40] = truth + rng.uniform(-0.04, 0.04, (40, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)

    consensus = gmcr.max_clique(consistency(points, normals))
    chosen = points[consensus.vertices]
    normal = np.linalg.svd(chosen - chosen.mean(axis=0))[2][2]  # of the least-squares plane
    error = np.degrees(np.arccos(min(1.0, abs(float(normal @ truth)))))
    print(
        f"{len(consensus.vertices)} of 400 points lie on the plane, no plane has more than "
        f"{consensus.upper_bound}; {error:.2f} deg off"
    )


if __name__ == "__main__":
    main()
