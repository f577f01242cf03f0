"""TEASER++ (Yang et al. 2021), where its Python module or its CMake package is installed."""

from __future__ import annotations

import subprocess
from dataclasses import replace
from functools import cache
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from paper.data import CHECKOUT
from paper.methods.registry import Look, Method, Outcome, outcome_of_pose, register
from paper.problem import Problem

MODULE = "teaserpp_python"
PROGRAM = Path(__file__).parents[1] / "teaser"
BUILD = CHECKOUT / "build" / "teaser"


@cache
def built_program(build: Path = BUILD) -> Path | str:
    """The program that links the installed CMake package, or why there is none."""
    for step in (["-S", PROGRAM, "-B", build, "-DCMAKE_BUILD_TYPE=Release"], ["--build", build]):
        try:
            done = subprocess.run(["cmake", *step], capture_output=True, text=True)
        except FileNotFoundError:
            return "cmake is not installed"
        if done.returncode != 0:
            is_missing = "teaserppConfig.cmake" in done.stderr
            return "no CMake package teaserpp" if is_missing else (done.stderr + done.stdout)[-300:]
    return build / "teaser_method"


@register
class Teaser(Method):
    name = "teaser++"
    look = Look("TEASER++", 42, "#a6761d", ">", (0, (5, 2, 2, 2)))
    settings = (
        "the parameters of its example: cbar2 = 1, GNC-TLS, exact clique; the given noise bound; of "
        "matches whose source points coincide the first, since two make its scale NaN"
    )
    _process: subprocess.Popen[str] | None = None
    _num_left_out = 0

    @classmethod
    def unavailable_reason(cls) -> str | None:
        if find_spec(MODULE):
            return None
        program = built_program()
        return f"no Python module {MODULE}, {program}" if isinstance(program, str) else None

    @classmethod
    def version(cls) -> str | None:
        if find_spec(MODULE):
            try:
                return metadata.version(MODULE)
            except metadata.PackageNotFoundError:
                return "unknown"
        program = built_program()
        if isinstance(program, str):
            return None
        said = subprocess.run([program, "version"], capture_output=True, text=True).stdout.strip()
        return said or "unknown"

    def prepare(self, problem: Problem, time_limit: float) -> None:
        problem, self._num_left_out = without_coincident_sources(problem)
        self._solve = self._of_module(problem) if find_spec(MODULE) else self._of_program(problem)

    def _of_module(self, problem: Problem) -> Any:
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
        source, target = (np.asfortranarray(p.T) for p in (problem.source, problem.target))

        def solve() -> tuple[bool, float, np.ndarray, np.ndarray]:
            # a second solve of one solver would scale its noise bound again
            made = solver(parameters)
            made.solve(source, target)
            found = made.getSolution()
            return True, found.scale, found.rotation, found.translation

        return solve

    def _of_program(self, problem: Problem) -> Any:
        """The program holds the problem and solves it once for each line that it is sent."""
        if self._process:
            self._process.kill()
        process = self._process = subprocess.Popen(
            [built_program()], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        matches = np.hstack([problem.source, problem.target])
        head = f"{len(matches)} {problem.noise_bound!r} {int(not problem.is_scale_known)}\n"
        process.stdin.write(head + "\n".join(" ".join(map(repr, m)) for m in matches.tolist()))
        process.stdin.write("\n")
        process.stdin.flush()

        def solve() -> tuple[bool, float, np.ndarray, np.ndarray]:
            process.stdin.write("solve\n")
            process.stdin.flush()
            values = np.array(process.stdout.readline().split(), dtype=float)
            return bool(values[0]), values[1], values[2:11].reshape(3, 3), values[11:14]

        return solve

    def solve(self) -> Any:
        return self._solve()

    def outcome(self, result: Any) -> Outcome:
        is_valid, scale, rotation, translation = result
        if not is_valid:
            return Outcome("no_pose", reason="the solution is not valid")
        outcome = outcome_of_pose(rotation, translation, scale)
        if self._num_left_out > 0:
            outcome.reason += f"{self._num_left_out} matches whose source coincides were left out"
        return outcome


def without_coincident_sources(problem: Problem) -> tuple[Problem, int]:
    """The problem with the first match of each source point, and how many were left out."""
    first = np.sort(np.unique(problem.source, axis=0, return_index=True)[1])
    left_out = len(problem.source) - len(first)
    if left_out == 0:
        return problem, 0
    return replace(problem, source=problem.source[first], target=problem.target[first]), left_out
