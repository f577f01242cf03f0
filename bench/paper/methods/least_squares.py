"""Least squares on the true inliers: the limit of what any method can reach."""

from __future__ import annotations

from typing import Any

from paper.methods.registry import Look, Method, Outcome, register
from paper.problem import Pose, Problem, fit_similarity


@register
class LeastSquares(Method):
    name = "least-squares"
    look = Look("true inliers", 90, "#999999", "", (0, (1, 3)))
    settings = "on the true inliers, which no other method is told: the limit of accuracy"

    def prepare(self, problem: Problem, time_limit: float) -> None:
        inliers = problem.is_inlier
        self._source, self._target = problem.source[inliers], problem.target[inliers]
        self._is_scale_known = problem.is_scale_known

    def solve(self) -> Any:
        if len(self._source) < 3:
            return None
        return fit_similarity(self._source, self._target, self._is_scale_known)

    def outcome(self, result: Pose | None) -> Outcome:
        if result is None:
            return Outcome("no_pose", reason="fewer than 3 true inliers")
        return Outcome("ok", result)
