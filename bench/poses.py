#!/usr/bin/env python3
"""Measures the returned poses: accuracy, at any bound, on any shape, and their covariance.

bench/poses.py [--docs docs]

Prints tables in Markdown, and writes them into the page. Needs the package (tools/make_venv) and the
real data: $GMCR_DATA, else ../shared/data. "held" is the pose that holds the most, the certificate's.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import gmcr
import numpy as np
from page_block import replace_block
from paper.data import pairs_of, read_points, read_pose
from paper.problem import Pose, Problem
from paper.scenarios.real import make_problem
from paper.scenarios.synthetic import load_model, problem_of

MATCHED = ("kitti_fpfh", "gore")
RAW = ("stanford_scans", "mian_views", "lidar", "mining_lidar")
FACTORS = (0.25, 0.5, 1.0, 1.5, 2.0, 3.0)
LINE_95 = {6: 12.592, 7: 14.067}  # of a chi-squared variable
WAYS = {
    "default": {},
    "counting": {"evidence": "count"},
    "certify": {"certify": True, "time_limit": 0.5},
}
MAX_ERROR_DEG = {"shapes": 15.0, "real": 5.0}


@dataclass(frozen=True)
class Outcome:
    """What a solve made of a problem. Errors are mean point errors, in noise bounds."""

    held: float
    returned: float
    oracle: float  # of the least-squares fit to the matches within the bound of the truth
    held_shift: float  # of the translation, metres
    shift: float
    is_held_right: bool
    is_right: bool
    distance: float | None  # d' C^-1 d of the true error d
    num_parameters: int
    evidence: float  # of the pose that holds the most


def pose_of(similarity: gmcr.Similarity) -> Pose:
    return Pose(similarity.scale, np.array(similarity.rotation), np.array(similarity.translation))


def point_error(pose: Pose, problem: Problem) -> float:
    moved = pose.apply(problem.model) - problem.truth.apply(problem.model)
    return float(np.linalg.norm(moved, axis=1).mean())


def turn_deg(pose: Pose, truth: Pose) -> float:
    cosine = (np.trace(pose.rotation @ truth.rotation.T) - 1) / 2
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def is_right(pose: Pose, problem: Problem, max_error_deg: float, max_error: float) -> bool:
    error = point_error(pose, problem)
    return turn_deg(pose, problem.truth) < max_error_deg and error < max_error


def fit_to(problem: Problem, inliers: np.ndarray) -> Pose:
    """Umeyama 1991."""
    source, target = problem.source[inliers], problem.target[inliers]
    a, b = source - source.mean(0), target - target.mean(0)
    u, spread, vt = np.linalg.svd(b.T @ a)
    signs = np.array([1, 1, np.linalg.det(u @ vt)])
    scale = 1.0 if problem.is_scale_known else float((spread * signs).sum() / (a**2).sum())
    rotation = u @ np.diag(signs) @ vt
    return Pose(scale, rotation, target.mean(0) - scale * rotation @ source.mean(0))


def squared_distance(result: gmcr.Result, truth: Pose) -> float | None:
    """Of the true error, by the stated covariance; None where none is stated."""
    if result.covariance is None:
        return None
    matrix = np.array(result.covariance.matrix)
    found = pose_of(result.target_from_source)
    turn = truth.rotation @ found.rotation.T
    axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
    angle = np.radians(turn_deg(found, truth))
    omega = axis * (angle / np.sin(angle) if angle > 1e-6 else 1.0)
    error = np.concatenate([omega, truth.translation - found.translation])
    if len(matrix) == 7:
        error = np.append(error, np.log(truth.scale / found.scale))
    return float(error @ np.linalg.solve(matrix, error))


def solve(problem: Problem, max_error_deg: float, max_error: float, **options: object) -> Outcome:
    result = gmcr.register_correspondences(
        problem.source,
        problem.target,
        noise_bound=problem.noise_bound,
        scale_mode="known" if problem.is_scale_known else "estimated",
        **options,
    )
    inliers = problem.is_inlier
    oracle = np.inf
    if inliers.sum() >= 3:
        oracle = point_error(fit_to(problem, inliers), problem) / problem.noise_bound
    if result.status not in ("ok", "degenerate"):
        return Outcome(np.inf, np.inf, oracle, np.inf, np.inf, False, False, None, 6, 0)
    held, returned = (pose_of(p.target_from_source) for p in (result.certificate, result))
    return Outcome(
        point_error(held, problem) / problem.noise_bound,
        point_error(returned, problem) / problem.noise_bound,
        oracle,
        *(
            float(np.linalg.norm(p.translation - problem.truth.translation))
            for p in (held, returned)
        ),
        is_right(held, problem, max_error_deg, max_error),
        is_right(returned, problem, max_error_deg, max_error),
        squared_distance(result, problem.truth),
        6 if problem.is_scale_known else 7,
        result.certificate.evidence.lower,
    )


@cache
def raw_problem(folder: Path) -> Problem:
    """The matches of two raw clouds, as the front end makes them."""
    source, target = (read_points(folder / f"{side}.ply") for side in ("source", "target"))
    matches = gmcr.match(source, target)
    return Problem(
        np.array(matches.source),
        np.array(matches.target),
        read_pose(folder / "T_target_source.txt"),
        matches.noise_bound,
        is_scale_known=True,
        model=source[::20],
    )


def real_problems(set_name: str, factor: float = 1.0) -> Iterator[Problem]:
    for folder in pairs_of(set_name):
        if set_name in MATCHED:
            yield make_problem(set_name, folder, seed=0, bound_factor=factor)
        else:
            problem = raw_problem(folder)
            yield replace(problem, noise_bound=factor * problem.noise_bound)


def gaussian_problem(seed: int, num_right: int, bound: float, sigma: float = 0.01) -> Problem:
    """Right matches with Gaussian noise, and as many wrong ones."""
    random = np.random.default_rng([seed, num_right])
    ball = gmcr.make_synthetic(
        num_correspondences=2 * num_right, outlier_rate=0.5, noise_extent=0.0, seed=seed
    )
    problem = problem_of(ball, is_scale_known=True, seed=seed)
    noise = sigma * random.standard_normal(problem.target.shape)
    target = problem.target + noise * np.array(ball.is_inlier)[:, None]
    return replace(problem, target=target, noise_bound=bound)


def shapes() -> dict[str, np.ndarray]:
    """The models as they are, squeezed along their axes, and a rod with bumps."""
    models = {}
    for name in ("bunny", "armadillo", "dragon"):
        model = load_model(name)
        models[name] = model
        centred = model - model.mean(0)
        axes = np.linalg.svd(centred[::10], full_matrices=False)[2]
        box = centred @ axes.T / np.ptp(centred @ axes.T, axis=0)
        for label, edges in {
            "1 x 0.4 x 0.4": (1, 0.4, 0.4),
            "1 x 0.15 x 0.15": (1, 0.15, 0.15),
            "1 x 1 x 0.15": (1, 1, 0.15),
        }.items():
            models[f"{name} {label}"] = box * edges
    random = np.random.default_rng(1)
    along, around = random.uniform(0, 1, 6000), random.uniform(0, 2 * np.pi, 6000)
    bumps = 0.03 * np.exp(-(((along - 0.3) / 0.05) ** 2)) * (np.cos(around) > 0)
    radius = 0.05 + bumps + 0.04 * np.exp(-(((along - 0.75) / 0.04) ** 2)) * (np.sin(around) > 0.2)
    models["rod"] = np.stack([radius * np.cos(around), radius * np.sin(around), along], axis=1)
    return models


def shape_problems(kind: str, bound: float, count: int, rate: float) -> Iterator[Problem]:
    for model in shapes().values():
        for seed in range(900, 906):
            drawn = gmcr.make_synthetic(
                kind=kind,
                model=model,
                num_correspondences=count,
                noise_bound=bound,
                outlier_rate=rate,
                seed=seed,
            )
            yield problem_of(drawn, is_scale_known=False, seed=seed)


def table(header: list[str], rows: Iterable[list[object]]) -> str:
    lines = [header, ["---"] * len(header), *rows]
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n" for line in lines) + "\n"


def accuracy() -> str:
    groups: dict[str, Callable[[], Iterable[Problem]]] = {
        f"{name}, {factor} bounds": (lambda n=name, f=factor: real_problems(n, f))
        for name in (*MATCHED, *RAW)
        for factor in (1.0, 2.0)
    }
    for kind, count, bound in (("random", 80, 0.02), ("structured", 90, 0.07)):
        for rate in (0.0, 0.5, 0.8):
            groups[f"{kind}, N = {count}, {100 * rate:.0f} % wrong"] = (
                lambda k=kind, b=bound, c=count, r=rate: [
                    problem
                    for place, problem in enumerate(shape_problems(k, b, c, r))
                    if place // 6 in (0, 4, 8)  # the models as they are
                ]
            )
    for factor in (1.2, 2.0, 3.0, 5.0, 6.0):
        groups[f"Gaussian noise, bound of {factor} sigma"] = lambda f=factor: [
            gaussian_problem(seed, 100, f * 0.01) for seed in range(50)
        ]
    rows = []
    for name, problems in groups.items():
        outcomes = [solve(problem, 180, np.inf) for problem in problems()]
        good = [o for o in outcomes if o.held < 10]
        ratios = [o.distance / o.num_parameters for o in good if o.distance is not None]
        errors = [
            f"{np.median([getattr(o, which) for o in good]):.3f}"
            for which in ("held", "returned", "oracle")
        ]
        rows.append([name, len(good), *errors, f"{np.median(ratios):.2f}"])
    return (
        "Median of the mean point error, in noise bounds, where the pose that holds the most is within ten\n"
        "of them; `true inliers` is the least-squares fit to the matches within the bound of the truth. The\n"
        "last column is the median of d' C^-1 d / k of the true error d: 0.9 for k = 6 where the covariance\n"
        "is true.\n\n"
        + table(["problems", "n", "held", "returned", "true inliers", "d' C^-1 d / k"], rows)
    )


def any_bound() -> str:
    rows = []
    for name, max_shift in (("kitti_fpfh", 0.6), ("gore", np.inf)):
        for factor in FACTORS:
            problems = list(real_problems(name, factor))
            outcomes = [solve(p, MAX_ERROR_DEG["real"], np.inf) for p in problems]
            near = [o.is_right and o.shift < max_shift for o in outcomes]
            held = [o.is_held_right and o.held_shift < max_shift for o in outcomes]
            medians = [
                np.median(
                    [getattr(o, w) * p.noise_bound for o, p in zip(outcomes, problems, strict=True)]
                )
                for w in ("held", "returned")
            ]
            rows.append(
                [name, factor, f"{sum(held)} of {len(held)}", f"{sum(near)} of {len(near)}"]
                + [f"{median:.3f}" for median in medians]
            )
    return (
        "Times the customary bound. Right: 5 degrees, and for KITTI a translation within 0.6 m. Median\n"
        "of the mean point error in metres, and in GORE's units.\n\n"
        + table(
            ["set", "times", "held right", "returned right", "held error", "returned error"], rows
        )
    )


def any_shape() -> str:
    rows = []
    for kind, bound, count, rates in (
        ("structured", 0.07, 90, (0.6, 0.8, 0.9, 0.95)),
        ("random", 0.02, 80, (0.9, 0.95)),
        ("random", 0.07, 90, (0.9, 0.95)),
    ):
        for rate in rates:
            problems = list(shape_problems(kind, bound, count, rate))
            for family in ("", "1 x 0.4 x 0.4", "1 x 0.15 x 0.15", "1 x 1 x 0.15", "rod"):
                names = [name for name in shapes() for _ in range(6)]
                chosen = [
                    problem
                    for name, problem in zip(names, problems, strict=True)
                    if (name.partition(" ")[2] or ("rod" if name == "rod" else "")) == family
                ]
                outcomes = {
                    name: [solve(p, MAX_ERROR_DEG["shapes"], 0.3, **options) for p in chosen]
                    for name, options in WAYS.items()
                }
                right = [sum(o.is_right for o in outcomes[name]) for name in WAYS]
                below = sum(
                    own.evidence < best.evidence - 1e-6
                    for own, best in zip(outcomes["default"], outcomes["certify"], strict=True)
                )
                rows.append(
                    [kind, bound, f"{100 * rate:.0f}", family or "as they are", len(chosen)]
                    + [*right, below]
                )
    return (
        "Unknown scale; right: mean point error below 0.3 m and turned by less than 15 degrees, by default,"
        "\nby counting, and with `certify` within half a second; below: problems in which that has more"
        "\nevidence than the default.\n\n"
        + table(
            ["outliers", "bound", "%", "shape", "n", "right", "counting", "certify", "below"], rows
        )
    )


def calibration() -> str:
    rows = []
    for num_right in (30, 60, 200):
        for factor in (2.0, 3.0, 5.0):
            outcomes = [
                solve(gaussian_problem(seed, num_right, factor * 0.01), 180, np.inf)
                for seed in range(300)
            ]
            outside = [
                o.distance is None or o.distance > LINE_95[o.num_parameters] for o in outcomes
            ]
            rows.append([num_right, factor, f"{100 * np.mean(outside):.1f}"])
    return (
        "Gaussian noise, as many wrong matches as right ones, 300 problems each: how often the truth is\n"
        "outside the 95 % line of the stated covariance.\n\n"
        + table(["right matches", "bound, sigma", "outside, %"], rows)
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--docs", type=Path, help="folder of the page whose block is replaced")
    given = parser.parse_args()
    text = "\n".join(
        f"## {title}\n\n{part()}"
        for title, part in (
            ("Accuracy and covariance", accuracy),
            ("At any bound", any_bound),
            ("On any shape", any_shape),
            ("Calibration", calibration),
        )
    )
    print(text)
    if given.docs:
        replace_block(given.docs, "poses", text)


if __name__ == "__main__":
    main()
