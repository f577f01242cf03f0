#!/usr/bin/python3
"""Turns the records of the benchmarks (*.jsonl) into Markdown tables (*.md) and figures (*.png)."""

import argparse
from pathlib import Path

from reports import clique, clouds, correspondences, paper_synthetic, scaling
from reports.records import read_records

REPORTS = {
    "correspondences": correspondences.report,
    "paper_synthetic": paper_synthetic.report,
    "paper_certified": paper_synthetic.report_certified,
    "scaling": scaling.report,
    "clouds": clouds.report,
    "clique": clique.report,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=Path("out/bench"), help="where the records are")
    folder = parser.parse_args().folder
    for name, report in REPORTS.items():
        records = read_records(folder / f"{name}.jsonl")
        if not records:
            continue
        path = folder / f"{name}.md"
        path.write_text(report(records))
        print(path)
        if name == "paper_synthetic":
            figure = folder / f"{name}.png"
            paper_synthetic.draw_success(records, figure)
            print(figure)


if __name__ == "__main__":
    main()
