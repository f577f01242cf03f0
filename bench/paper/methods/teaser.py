"""TEASER++ (Yang et al. 2021), where its Python module is installed."""

from __future__ import annotations

from typing import Any

import numpy as np

from paper.methods.registry import Method, Outcome, outcome_of_pose, register
from paper.problem import Problem


@register
class Teaser(Method):
    name = "teaser++"
    settings = (
        "the parameters of its example: cbar2 = 1, GNC-TLS, exact clique; the given noise bound"
    )
    modules = ("teaserpp_python",)

    def prepare(self, problem: Problem, time_limit: float) -> None:
        import teaserpp_python

        solver = teaserpp_python.RobustRegistrationSolver
        parameters = solver.Params()
        parameters.cbar2 = 1
        parameters.noise_bound = problem.noise_bound
        parameters.estimate_scaling = not problem.is_scale_known
        parameters.rotation_estimation_algorithm = solver.ROTATION_ESTIMATION_ALGORITHM.GNC_TLS
        parameters.rotation_gnc_factor = 1.4
        parameters.rotation_max_iterations = 100
        parameters.rotation_cost_threshold = 1e-12
        self._make = lambda: solver(parameters)
        self._source = np.asfortranarray(problem.source.T)
        self._target = np.asfortranarray(problem.target.T)

    def solve(self) -> Any:
        # A second solve of one solver would scale its noise bound again.
        solver = self._make()
        solver.solve(self._source, self._target)
        return solver.getSolution()

    def outcome(self, result: Any) -> Outcome:
        if not result.valid:
            return Outcome("no_pose", reason="the solution is not valid")
        return outcome_of_pose(result.rotation, result.translation, result.scale)
