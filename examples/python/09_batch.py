"""Registers many pairs on all cores, reads the results, and goes on where a run was ended."""

import csv
import tempfile
from pathlib import Path

import gmcr
import numpy as np
from gmcr import batch


def write_problems(folder: Path, count: int) -> Path:
    """Files of matches, 90 % of them wrong, and the list of the pairs."""
    pairs = folder / "pairs.csv"
    with pairs.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["id", "matches", "noise_bound"])
        for seed in range(count):
            problem = gmcr.make_synthetic(num_correspondences=300, outlier_rate=0.9, seed=seed)
            np.save(folder / f"{seed}.npy", np.hstack([problem.source, problem.target]))
            writer.writerow([f"pair-{seed}", f"{seed}.npy", problem.noise_bound])
        writer.writerow(["broken", "missing.npy", 0.05])  # costs one row, not the run
    return pairs


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        pairs = write_problems(folder, 12)

        # address="auto" would use the Ray cluster that this machine belongs to
        summary = batch.run(pairs, folder / "results", format="jsonl", show_progress=True)
        print(f"{summary.num_pairs} pairs: {summary.statuses}")

        for row in batch.read_results(folder / "results"):
            if row.status == "error":
                print(f"{row.id}: {row.reason.split(':')[0]}")
            else:
                print(f"{row.id}: {row.num_inliers} inliers, at most {row.max_inliers}")

        # the same call again has nothing left to do
        print(f"{batch.run(pairs, folder / 'results', format='jsonl').num_skipped} done before")


if __name__ == "__main__":  # workers import this file
    main()
