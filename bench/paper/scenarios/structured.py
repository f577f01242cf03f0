"""The paper's benchmark of structured outliers, next to the same with random ones."""

from __future__ import annotations

from collections.abc import Iterator

from paper.scenarios.registry import UNKNOWN_SCALE, Case, experiment
from paper.scenarios.synthetic import MODELS, QUICK_RATES, RATES, load_model, model_case

NUM_CORRESPONDENCES = 90
NOISE_BOUND = 0.07  # metres


PROTOCOL = """\
As before with N = 90, inliers matched to a neighbour of the true point and outliers in the
neighbourhoods of a few wrong matches; noise bound 0.07 m
(`gmcr.make_synthetic(kind="structured")`). The paper's panel (b) shows the consensus set of the
scale stage. Most methods here have no such stage, so it shows the consensus set of the returned
pose, the same for all: the matches within the noise bound. Panel (a) needs the same problems with
random outliers, N and bound alike."""


@experiment("structured", "Robust registration with structured outliers, unknown scale", PROTOCOL)
def cases(quick: bool) -> Iterator[Case]:
    load_model(MODELS[0])
    rates = QUICK_RATES if quick else sorted({*RATES, 0.75, 0.85})
    for kind in ("structured", "random"):
        for rate in rates:
            for model in MODELS[:1] if quick else MODELS:
                for seed in range(3 if quick else 10):
                    yield model_case(
                        kind, model, NUM_CORRESPONDENCES, NOISE_BOUND, rate, seed, UNKNOWN_SCALE
                    )
