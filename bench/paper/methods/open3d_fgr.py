"""Open3D's fast global registration (Zhou et al. 2016) on given matches."""

from __future__ import annotations

from typing import Any

import numpy as np

from paper.methods.open3d_clouds import Open3dMethod
from paper.methods.registry import Look, Outcome, outcome_of_pose, register
from paper.problem import Problem, pose_from_matrix

NUM_ITERATIONS = 128  # mu falls by 1.4 every fourth: down to the noise of a scan of 100 m


@register
class Open3dFgr(Open3dMethod):
    name = "open3d-fgr"
    look = Look("FGR (Open3D)", 40, "#e69f00", "P", (0, (6, 2, 1, 2)))
    settings = (
        "Open3D, normalised, `decrease_mu` until mu is the square of the noise bound over the "
        "size, tuple test, 128 iterations, seeded; known scale only"
    )
    needs_known_scale = True

    def prepare(self, problem: Problem, time_limit: float) -> None:
        import open3d

        self.load(problem)
        # Open3D compares mu with squared residuals of clouds shrunk to the unit ball. With absolute
        # scale mu would start at the size, not at its square, which loses most of the real pairs.
        size = max(
            np.linalg.norm(points - points.mean(axis=0), axis=1).max()
            for points in (problem.source, problem.target)
        )
        self._option = open3d.pipelines.registration.FastGlobalRegistrationOption(
            use_absolute_scale=False,
            decrease_mu=True,
            maximum_correspondence_distance=(problem.noise_bound / size) ** 2,
            iteration_number=NUM_ITERATIONS,
        )
        self._seed = problem.seed

    def solve(self) -> Any:
        import open3d

        open3d.utility.random.seed(self._seed)
        return open3d.pipelines.registration.registration_fgr_based_on_correspondence(
            self.source, self.target, self.matches, self._option
        )

    def outcome(self, result: Any) -> Outcome:
        pose = pose_from_matrix(result.transformation)
        return outcome_of_pose(pose.rotation, pose.translation)
