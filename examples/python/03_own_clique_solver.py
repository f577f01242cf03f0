"""The steps of a registration one by one, with a clique solver of one's own.

The graph is the library's: which pairs of matches can be right together. Any solver may search it;
here a greedy one of a few lines against the exact one of the library.
"""

from __future__ import annotations

import gmcr
import numpy as np
import numpy.typing as npt


def greedy_clique(graph: npt.NDArray[np.bool_]) -> list[int]:
    """A clique, not always the largest one: vertices by degree, each that fits."""
    clique: list[int] = []
    for vertex in np.argsort(-graph.sum(axis=1), kind="stable"):
        if graph[vertex, clique].all():
            clique.append(int(vertex))
    return sorted(clique)


def fit(source: npt.NDArray[np.float64], target: npt.NDArray[np.float64]) -> gmcr.Similarity:
    """Least-squares rigid transform of matches without outliers (Arun et al. 1987)."""
    centre_a, centre_b = source.mean(axis=0), target.mean(axis=0)
    u, _, vt = np.linalg.svd((target - centre_b).T @ (source - centre_a))
    rotation = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, centre_b - rotation @ centre_a
    return gmcr.Similarity.from_matrix(matrix)


def main() -> None:
    problem = gmcr.make_synthetic(num_correspondences=400, outlier_rate=0.8, seed=1)
    source, target = problem.source, problem.target
    graph = gmcr.consistency_graph(source, target, noise_bound=0.01)
    cliques = {"greedy": greedy_clique(graph), "exact": list(gmcr.max_clique(graph).vertices)}
    for name, clique in cliques.items():
        pose = fit(source[clique], target[clique])
        inliers = gmcr.evaluate_consensus(pose, source, target, noise_bound=0.01).inliers
        errors = gmcr.evaluate(pose, problem, source)
        print(
            f"{name}: clique of {len(clique)}, {len(inliers)} inliers, "
            f"{errors.rotation_error_deg:.2f} deg off"
        )


if __name__ == "__main__":
    main()
