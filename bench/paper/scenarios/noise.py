"""Recall over the noise bound that the methods are told, on real matches."""

from __future__ import annotations

from collections.abc import Iterator

from paper.data import pairs_of
from paper.scenarios.real import CRITERIA, make_problem
from paper.scenarios.registry import KNOWN_SCALE, Case, experiment

FACTORS = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0)  # of the customary bound


PROTOCOL = """\
Beyond the paper: the same pairs, one rotation each, where all methods are told a multiple of the
customary noise bound; 7 pairs of KITTI, 6 of GORE."""


@experiment("noise", "Recall over noise bounds, known scale", PROTOCOL)
def cases(quick: bool) -> Iterator[Case]:
    for set_name, criterion in CRITERIA.items():
        for folder in pairs_of(set_name)[: 2 if quick else None]:
            for factor in FACTORS[1::2] if quick else FACTORS:
                fields = {"set": set_name, "pair": folder.name, "bound_factor": factor, "seed": 0}
                yield Case(
                    fields,
                    lambda s=set_name, f=folder, x=factor: make_problem(s, f, 0, x),
                    criterion,
                    KNOWN_SCALE,
                )
