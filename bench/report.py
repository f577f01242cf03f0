#!/usr/bin/python3
"""Turns the records of the benchmarks (*.jsonl) into Markdown tables (*.md) and figures (*.png)."""

import argparse
import json
from pathlib import Path

from reports import batch, clique, clouds, correspondences, micro, paper_synthetic, scaling
from reports.records import read_records

REPORTS = {
    "correspondences": correspondences.report,
    "paper_synthetic": paper_synthetic.report,
    "paper_certified": paper_synthetic.report_certified,
    "scaling": scaling.report,
    "clouds": clouds.report,
    "clique": clique.report,
    "batch": batch.report,
}

FIGURES = {"paper_synthetic": paper_synthetic.draw_success, "scaling": scaling.draw}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("out/bench"), help="where the records are")
    parser.add_argument("--before", type=Path, help="folder of an earlier run, to compare with")
    arguments = parser.parse_args()
    folder = arguments.folder
    for name, report in REPORTS.items():
        records = read_records(folder / f"{name}.jsonl")
        if not records:
            continue
        path = folder / f"{name}.md"
        if name == "scaling":
            before = read_records(arguments.before / "scaling.jsonl") if arguments.before else []
            path.write_text(report(records, before))
        else:
            path.write_text(report(records))
        print(path)
        if name in FIGURES:
            figure = folder / f"{name}.png"
            FIGURES[name](records, figure)
            print(figure)
    if (folder / "micro.json").exists():
        path = folder / "micro.md"
        path.write_text(micro.report(json.loads((folder / "micro.json").read_text())))
        print(path)


if __name__ == "__main__":
    main()
