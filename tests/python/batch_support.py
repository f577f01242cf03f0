"""Pairs for the tests of the batch, and workers that misbehave by the id of the pair."""

import csv
import dataclasses
import os
import signal
import time
from pathlib import Path

import gmcr
import numpy as np
from gmcr.batch import Row, register_pair

UNREPEATABLE = dict.fromkeys(("seconds", "cpu_seconds", "read_seconds", "attempts"))


def write_matches(path, seed=1, num_correspondences=60):
    problem = gmcr.make_synthetic(
        num_correspondences=num_correspondences, outlier_rate=0.5, seed=seed
    )
    np.save(path, np.hstack([problem.source, problem.target]))


def write_pairs(folder, ids, num_files=3):
    """A list of pairs with these ids, over a few files of matches."""
    for seed in range(num_files):
        write_matches(folder / f"matches{seed}.npy", seed)
    path = folder / "pairs.csv"
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["id", "matches"])
        writer.writerows([id, f"matches{k % num_files}.npy"] for k, id in enumerate(ids))
    return path


def repeatable(row):
    return dataclasses.replace(row, **UNREPEATABLE)


def by_id(pair, options):
    """``register_pair``, after what the first word of the id says."""
    word = pair.id.split("-")[0]
    if word == "exit":
        os._exit(7)
    if word in ("kill", "node") and _is_first_time(pair):
        os.kill(os.getpid() if word == "kill" else os.getppid(), signal.SIGKILL)
        time.sleep(10)
    if word == "fault" and _is_first_time(pair):
        raise OSError(5, "Input/output error")
    if word == "slow":
        _note_start(pair)
        time.sleep(0.06)
    if word == "hang":
        time.sleep(60)
    return register_pair(pair, options)


def count_rows(pair, options):
    """The number of matches, by no registration."""
    return Row(id=pair.id, status="ok", num_correspondences=len(np.load(pair.matches)))


def starts(folder):
    """Ids of the slow pairs, as often as they were started."""
    return (folder / "starts.txt").read_text().split()


def _note_start(pair):
    with (Path(pair.matches).parent / "starts.txt").open("a") as file:
        file.write(pair.id + "\n")


def _is_first_time(pair):
    marker = Path(pair.matches).parent / f"{pair.id}.started"
    if marker.exists():
        return False
    marker.touch()
    return True
