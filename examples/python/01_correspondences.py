"""Pose from putative correspondences, nine in ten of them wrong."""

from __future__ import annotations

import gmcr


def main() -> None:
    problem = gmcr.make_synthetic(num_correspondences=1000, outlier_rate=0.9, seed=1)
    result = gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.01)
    print(result)
    print(result.matrix())
    print(f"{len(result.inliers)} inliers; no pose has more than {result.certificate.upper}")
    print(gmcr.evaluate(result, problem, problem.source))


if __name__ == "__main__":
    main()
