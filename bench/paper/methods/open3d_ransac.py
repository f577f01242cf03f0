"""Open3D's RANSAC on given matches."""

from __future__ import annotations

from typing import Any

from paper.methods.open3d_clouds import Open3dMethod
from paper.methods.registry import Look, Outcome, outcome_of_pose, register
from paper.problem import Problem, pose_from_matrix


@register
class Open3dRansac(Open3dMethod):
    name = "open3d-ransac"
    look = Look("RANSAC (Open3D)", 30, "#009e73", "v", (0, (4, 2)))
    settings = (
        "Open3D, 3 points a sample, 10,000 iterations, confidence 0.99, distance checker at the "
        "noise bound; with known scale the edge-length checker at 0.9 too (it presumes scale 1); "
        "`with_scaling` where the scale is unknown; its pose as returned"
    )

    def prepare(self, problem: Problem, time_limit: float) -> None:
        import open3d

        registration = open3d.pipelines.registration
        self.load(problem)
        checkers = [registration.CorrespondenceCheckerBasedOnDistance(problem.noise_bound)]
        if problem.is_scale_known:
            checkers.append(registration.CorrespondenceCheckerBasedOnEdgeLength(0.9))
        estimation = registration.TransformationEstimationPointToPoint(not problem.is_scale_known)
        criteria = registration.RANSACConvergenceCriteria(10_000, 0.99)
        self._arguments = (problem.noise_bound, estimation, 3, checkers, criteria)
        self._seed = problem.seed

    def solve(self) -> Any:
        import open3d

        open3d.utility.random.seed(self._seed)
        return open3d.pipelines.registration.registration_ransac_based_on_correspondence(
            self.source, self.target, self.matches, *self._arguments
        )

    def outcome(self, result: Any) -> Outcome:
        if len(result.correspondence_set) == 0:
            return Outcome("no_pose", reason="no sample passed the checkers")
        pose = pose_from_matrix(result.transformation)
        return outcome_of_pose(pose.rotation, pose.translation, pose.scale)
