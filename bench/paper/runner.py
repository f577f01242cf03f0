"""Runs what is not yet recorded."""

from __future__ import annotations

import json
import os
import sys
from datetime import datetime, timezone
from pathlib import Path
from statistics import median

import numpy as np
from tqdm import tqdm

from paper.data import DataAbsent
from paper.methods import METHODS
from paper.problem import Problem, errors_of
from paper.records import RecordFile, environment, key_of
from paper.scenarios import Case, Experiment, is_success
from paper.worker import Timed, Worker

SKIPPED = "skipped.json"  # methods that were not available in the last run, with the reasons


class Runner:
    """Holds a process for each method; use as a context manager.

    Parameters
    ----------
    out : folder of the records, a file an experiment.
    methods : names of the methods to run.
    time_limit : seconds a solve.
    """

    def __init__(self, out: Path, methods: list[str], time_limit: float):
        # Idle OpenMP threads of one rival would otherwise spin beside the solve of the next.
        os.environ.setdefault("OMP_WAIT_POLICY", "passive")
        self._out = out
        self._time_limit = time_limit
        self._workers: dict[str, Worker] = {}
        skipped: dict[str, str] = {}
        for name in methods:
            worker = Worker(name)
            reason = worker.unavailable_reason()
            if reason is None:
                self._workers[name] = worker
            else:
                skipped[name] = reason
                print(f"skipped: {name}: {reason}", file=sys.stderr)
        out.mkdir(parents=True, exist_ok=True)
        (out / SKIPPED).write_text(json.dumps(skipped, indent=1) + "\n")

    def __enter__(self) -> Runner:
        return self

    def __exit__(self, *_: object) -> None:
        for worker in self._workers.values():
            worker.stop()

    def run(self, experiment: Experiment, quick: bool, max_runs: int | None = None) -> int:
        """Run an experiment from where it was left, at most `max_runs`; how many runs were made."""
        records = RecordFile(self._out / f"{experiment.name}.jsonl")
        try:
            todo = self._todo(experiment, quick, records)
        except DataAbsent as absence:
            print(f"skipped: {experiment.name}: {absence}", file=sys.stderr)
            return 0
        num_runs = 0
        with tqdm(total=sum(len(names) for _, names in todo), desc=experiment.name) as progress:
            for case, names in todo:
                problem = case.make()
                for name in names:
                    if num_runs == max_runs:
                        return num_runs
                    records.append(self._record(experiment.name, case, name, problem))
                    num_runs += 1
                    progress.update()
        return num_runs

    def _todo(
        self, experiment: Experiment, quick: bool, records: RecordFile
    ) -> list[tuple[Case, list[str]]]:
        todo = []
        for case in experiment.cases(quick):
            names = [
                name
                for name in case.methods
                if name in self._workers
                and key_of(experiment.name, case.fields, name) not in records.keys
            ]
            if names:
                todo.append((case, names))
        return todo

    def _record(self, experiment: str, case: Case, name: str, problem: Problem) -> dict:
        method = METHODS[name]
        time_limit = min(self._time_limit, method.max_time_limit)
        timed = self._workers[name].solve(problem, time_limit)
        return {
            "key": key_of(experiment, case.fields, name),
            "experiment": experiment,
            **case.fields,
            "method": name,
            "method_version": method.version(),
            "time_limit": time_limit,
            "criterion": case.criterion,
            **describe_problem(problem),
            **describe_result(timed, problem, case.criterion),
            **environment(),
            "date": datetime.now(timezone.utc).isoformat(timespec="seconds"),
        }


def describe_problem(problem: Problem) -> dict:
    return {
        "input_hash": problem.input_hash(),
        "num_correspondences": len(problem.source),
        "num_true_inliers": int(problem.is_inlier.sum()),
        "noise_bound": problem.noise_bound,
        "scale": "known" if problem.is_scale_known else "estimated",
        "true_scale": problem.truth.scale,
    }


def describe_result(timed: Timed, problem: Problem, criterion: dict[str, float]) -> dict:
    """Times, status, errors and consensus of a run; the consensus is judged alike for all."""
    outcome = timed.outcome
    pose_errors = None if outcome.pose is None else errors_of(outcome.pose, problem)
    record = {
        "status": outcome.status,
        "status_reason": outcome.reason,
        "wall_ms": 1e3 * median(timed.seconds) if outcome.status in ("ok", "no_pose") else None,
        "all_wall_ms": [1e3 * seconds for seconds in timed.seconds],
        "stages_ms": {stage: 1e3 * seconds for stage, seconds in outcome.stages.items()},
        "threads": outcome.threads,
        "certificate": outcome.certificate,
        "limits_hit": outcome.limits_hit,
        "errors": pose_errors,
        "success": is_success(pose_errors, criterion),
        "num_inliers": None,
        "inlier_share": None,
    }
    if outcome.pose is not None:
        gaps = np.linalg.norm(problem.target - outcome.pose.apply(problem.source), axis=1)
        consensus = gaps <= problem.noise_bound
        record["num_inliers"] = int(consensus.sum())
        if consensus.any():
            record["inlier_share"] = float(problem.is_inlier[consensus].mean())
    return record
