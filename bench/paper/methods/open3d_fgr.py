"""Open3D's fast global registration (Zhou et al. 2016) on given matches."""

from __future__ import annotations

from typing import Any

from paper.methods.open3d_clouds import Open3dMethod
from paper.methods.registry import Outcome, outcome_of_pose, register
from paper.problem import Problem, pose_from_matrix


@register
class Open3dFgr(Open3dMethod):
    name = "open3d-fgr"
    settings = (
        "Open3D, `use_absolute_scale` with the noise bound as the correspondence distance, "
        "`decrease_mu`, tuple test, 64 iterations; known scale only"
    )
    needs_known_scale = True

    def prepare(self, problem: Problem, time_limit: float) -> None:
        import open3d

        self.load(problem)
        self._option = open3d.pipelines.registration.FastGlobalRegistrationOption(
            use_absolute_scale=True,
            decrease_mu=True,
            maximum_correspondence_distance=problem.noise_bound,
        )

    def solve(self) -> Any:
        import open3d

        return open3d.pipelines.registration.registration_fgr_based_on_correspondence(
            self.source, self.target, self.matches, self._option
        )

    def outcome(self, result: Any) -> Outcome:
        pose = pose_from_matrix(result.transformation)
        return outcome_of_pose(pose.rotation, pose.translation)
