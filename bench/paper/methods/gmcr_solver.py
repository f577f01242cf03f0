"""What the methods of this library share."""

from __future__ import annotations

from typing import Any, ClassVar

import gmcr

from paper.methods.registry import Method, Outcome
from paper.problem import Pose, Problem

LIMIT_SHARE = 0.95  # of the time limit: an answer at the limit still has to be returned


class GmcrSolver(Method):
    """A call of `gmcr.register_correspondences`."""

    modules = ("gmcr",)
    distribution = "gmcr"
    options: ClassVar[dict[str, Any]] = {}  # besides noise bound, scale mode and time limit

    def prepare(self, problem: Problem, time_limit: float) -> None:
        self._source, self._target = problem.source, problem.target
        self._options = gmcr.Options(
            noise_bound=problem.noise_bound,
            scale_mode="known" if problem.is_scale_known else "estimated",
            time_limit=LIMIT_SHARE * time_limit,
            **self.options,
        )

    def solve(self) -> Any:
        return gmcr.register_correspondences(self._source, self._target, self._options)

    def outcome(self, result: Any) -> Outcome:
        has_pose = result.status in ("ok", "degenerate")
        pose = Pose(result.scale, result.rotation, result.translation) if has_pose else None
        certificate, diagnostics = result.certificate, result.diagnostics
        return Outcome(
            "ok" if has_pose else "no_pose",
            pose,
            result.status_reason,
            stages=dict(diagnostics.stages),
            certificate={
                "lower": certificate.lower,
                "upper": certificate.upper,
                "certified": certificate.certified,
            },
            limits_hit=list(diagnostics.limits_hit),
            threads=diagnostics.num_threads,
        )
