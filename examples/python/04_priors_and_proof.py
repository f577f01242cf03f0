"""What is known beforehand, a proof, other answers, and how sure the pose is."""

from __future__ import annotations

import gmcr
import numpy as np


def main() -> None:
    # 40 points that turned by 40 degrees about gravity, 25 of which also match as if the whole had
    # been turned upside down; 60 more matches are wrong
    rng = np.random.default_rng(1)
    source, target = rng.uniform(-1, 1, (2, 125, 3))
    source[40:65] = source[:25]
    angle = np.radians(40)
    turn = np.array(
        [[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]]
    )
    target[:40] = source[:40] @ turn.T
    target[40:65] = source[40:65] * [1, -1, -1] @ turn.T
    target[:65] += rng.uniform(-0.005, 0.005, (65, 3))

    options = gmcr.Options(noise_bound=0.01, num_hypotheses=2, certify=True)
    free = gmcr.register_correspondences(source, target, options)
    print(
        f"without gravity: {len(free.inliers)} agree, proven best: {free.certificate.certified}, "
        f"runner-up {free.runner_up_ratio:.0%}"
    )
    options.gravity = gmcr.GravityPrior(source=[0, 0, 1], target=[0, 0, 1], max_tilt=np.radians(5))
    upright = gmcr.register_correspondences(source, target, options)
    print(f"with gravity: {len(upright.inliers)} agree, runner-up {upright.runner_up_ratio:.0%}")
    if upright.covariance is not None:
        deviations = np.sqrt(np.diag(upright.covariance.matrix))
        print(f"the translation is known to {deviations[3:6].max():.2g} m")


if __name__ == "__main__":
    main()
