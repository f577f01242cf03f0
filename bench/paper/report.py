"""Tables and figures of recorded runs: docs/benchmarks/paper.md."""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Sequence
from os.path import relpath
from pathlib import Path

from reports.page import fold_tables

from paper.data import CHECKOUT
from paper.figures import FIGURES
from paper.figures.style import methods_of, save
from paper.losses import losses
from paper.methods import METHODS
from paper.records import read_records
from paper.runner import SKIPPED
from paper.scenarios import EXPERIMENTS
from paper.tables import TABLES

HEADING = "# The paper's experiments"
PAGE = Path("benchmarks/paper.md")  # in the folder of the documents
DISCUSSION = Path(__file__).with_name("discussion.md")

INTRODUCTION = """\
The experiments of Gentner, Murali and Kaboli (GMCR, 2023), and some beyond them, with today's
methods side by side; all get the same bytes. Medians and quartiles are over all runs: one without a
pose has an infinite error, one that was ended at the time limit an infinite time, and neither is a
success. Times are taken inside the process of each method around its solve alone (median of up to
three), one method at a time, with all cores. Success rates have Wilson intervals at 95 %.
"""


def write_report(out: Path, document: Path, figures: Path) -> None:
    """Write the page of a folder of records, and its figures."""
    document.write_text(fold_tables(compose(out, figures, document.parent)))


def compose(out: Path, figures: Path, base: Path) -> str:
    """The page, and its figures drawn into a folder; links are relative to `base`."""
    records = {name: read_records(out / f"{name}.jsonl") for name in EXPERIMENTS}
    records = {name: group for name, group in records.items() if group}
    if not records:
        return f"{HEADING}\n\nNo records.\n"
    everything = [record for group in records.values() for record in group]
    text = (
        f"{HEADING}\n\n{INTRODUCTION}\n{provenance(everything)}\n{method_list(everything, out)}\n"
    )
    for name, group in records.items():
        experiment = EXPERIMENTS[name]
        caption, draw = FIGURES[name]
        path = figures / f"experiment_{name}.png"
        save(draw(group), path)
        text += f"## {experiment.title}\n\n{experiment.protocol}\n\n"
        text += f"![{caption}]({relpath(path, base)})\n\n{caption}. {size_of(group)}\n\n"
        text += TABLES[name](group) + "\n"
    text += "## Where we lose\n\n" + DISCUSSION.read_text() + "\n"
    text += (
        "All groups of runs in which a method (the exact search aside) was right more often than "
        "`gmcr`; or as often, and a "
        "rival in less time, or with a median error that is at least a fifth smaller (degrees for "
        "real and noise, else metres; over all runs):\n\n"
    )
    return text + (losses(records) or "None.\n")


def provenance(records: Sequence[dict]) -> str:
    """Command, machine, date and limits of the recorded run."""
    first = records[0]
    dates = sorted(record["date"][:10] for record in records)
    when = dates[0] if dates[0] == dates[-1] else f"{dates[0]} to {dates[-1]}"
    commits = ", ".join(sorted({str(record["commit"]) for record in records}))
    limits = max(record["time_limit"] for record in records)
    statuses = Counter(record["status"] for record in records)
    ended = ", ".join(f"{count} {status}" for status, count in statuses.most_common())
    return (
        f"Recorded on {when} by `make bench-paper` (`bench/paper/run`): gmcr {first['gmcr']} "
        f"({commits}), {first['cpu']}, {first['isa']}, {first['cores']} cores, Python "
        f"{first['python']}; at most {limits:g} s a solve; {len(records):,} runs ({ended}). Each "
        "problem is drawn from a seed of its own, made from the experiment, its fields and the "
        "run's number, so a new run has the same bytes. Open3D's RANSAC and the paper's method "
        "where it runs out of time vary between runs all the same.\n"
    )


def method_list(records: Sequence[dict], out: Path) -> str:
    """Settings and versions of the methods, and which were not there."""
    versions = {record["method"]: record["method_version"] for record in records}
    lines = []
    for name in methods_of(records):
        version = f" {versions[name]}" if versions[name] else ""
        lines.append(f"- `{name}`{version}: {METHODS[name].settings}.")
    skipped = out / SKIPPED
    for name, reason in json.loads(skipped.read_text()).items() if skipped.exists() else ():
        lines.append(f"- `{name}` ({METHODS[name].settings}): skipped, {reason}.")
    return "\n".join(lines) + "\n"


def size_of(records: Sequence[dict]) -> str:
    problems = {record["key"].rpartition("|")[0] for record in records}
    last = max(record["seed"] for record in records)
    return f"{len(problems)} problems (runs 0 to {last} of each case), {len(records)} solves."


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="bench/paper/report",
        description="Composes docs/benchmarks/paper.md and its figures from the records of a run.",
    )
    parser.add_argument("out", type=Path, help="folder of the records, such as out/bench-paper")
    parser.add_argument(
        "--docs", type=Path, default=CHECKOUT / "docs", help="folder of the documents"
    )
    options = parser.parse_args()
    write_report(options.out, options.docs / PAGE, options.docs / "images")
    return 0


if __name__ == "__main__":
    sys.exit(main())
