"""The back end of KISS-Matcher (Lim et al. 2025) on given matches."""

from __future__ import annotations

from typing import Any

import numpy as np

from paper.methods.registry import Look, Method, Outcome, outcome_of_pose, register
from paper.problem import Problem


@register
class KissMatcher(Method):
    name = "kiss-matcher"
    look = Look("KISS-Matcher", 41, "#7f4fc9", "X", (0, (2, 2)))
    settings = (
        "`prune_and_solve` (its k-core pruning, then GNC) with the noise bound as its voxel size, "
        "which sets its own bounds by its default gains; known scale only"
    )
    modules = ("kiss_matcher",)
    distribution = "kiss-matcher"
    needs_known_scale = True
    VOXEL_SIZE = 0.3  # its default; it rejects small ones and computes in single precision

    def prepare(self, problem: Problem, time_limit: float) -> None:
        import kiss_matcher

        config = kiss_matcher.KISSMatcherConfig(self.VOXEL_SIZE, use_voxel_sampling=False)
        self._matcher = kiss_matcher.KISSMatcher(config)
        self._unit = problem.noise_bound / self.VOXEL_SIZE
        self._source = list((problem.source / self._unit).astype(np.float32))
        self._target = list((problem.target / self._unit).astype(np.float32))

    def solve(self) -> Any:
        return self._matcher.prune_and_solve(self._source, self._target)

    def outcome(self, result: Any) -> Outcome:
        if not result.valid:
            return Outcome("no_pose", reason="the solution is not valid")
        return outcome_of_pose(np.array(result.rotation), self._unit * np.array(result.translation))
