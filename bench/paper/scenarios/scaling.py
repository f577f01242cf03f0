"""Time against the number of matches and against the outlier rate, known scale."""

from __future__ import annotations

from collections.abc import Iterator

import gmcr

from paper.problem import Problem
from paper.scenarios.drawing import seed_of
from paper.scenarios.registry import KNOWN_SCALE, Case, experiment
from paper.scenarios.synthetic import problem_of

NOISE_BOUND = 0.01  # metres, of a cube of edge 1 m
SIZES = (100, 200, 500, 1000, 2000, 5000)
SIZE_RATES = (0.5, 0.9)
RATES = (0.0, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95, 0.99)
RATES_SIZE = 1000
CRITERION = {"mean_point": 0.05}


PROTOCOL = """\
Beyond the paper: points in a cube of 1 m, noise of 0.01 m, outliers uniform in the ball around it
(`gmcr.make_synthetic(kind="ball")`); right: a mean point error below 0.05 m."""


@experiment("scaling", "Time against N and outlier rate, known scale", PROTOCOL)
def cases(quick: bool) -> Iterator[Case]:
    sizes = SIZES[::2] if quick else SIZES
    grid = {(size, rate) for size in sizes for rate in SIZE_RATES}
    grid |= {(RATES_SIZE, rate) for rate in (RATES[::3] if quick else RATES)}
    for size, rate in sorted(grid):
        for seed in range(1 if quick else 3):
            fields = {"num_correspondences": size, "outlier_rate": rate, "seed": seed}
            yield Case(
                fields, lambda n=size, r=rate, s=seed: make_problem(n, r, s), CRITERION, KNOWN_SCALE
            )


def make_problem(count: int, rate: float, seed: int) -> Problem:
    own_seed = seed_of("ball", count, rate, seed)
    drawn = gmcr.make_synthetic(
        kind="ball",
        num_correspondences=count,
        outlier_rate=rate,
        noise_bound=NOISE_BOUND,
        seed=own_seed,
    )
    return problem_of(drawn, is_scale_known=True, seed=own_seed)
