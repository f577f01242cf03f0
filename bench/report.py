#!/usr/bin/python3
"""Turns the records of the benchmarks (*.jsonl) into Markdown tables (*.md) and figures (*.png)."""

import argparse
import json
import shutil
from pathlib import Path

from reports import batch, clique, clouds, correspondences, micro, paper_synthetic, scaling
from reports.markdown import bounds_note
from reports.page import TEMPLATE, compose
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


def write_reports(folder, before):
    """Writes a report beside each file of records.

    Returns the reports by name and the paths of the figures.
    """
    reports, figures, all_records = {}, [], []
    for name, report in REPORTS.items():
        records = read_records(folder / f"{name}.jsonl")
        if not records:
            continue
        all_records += records
        if name == "scaling":
            reports[name] = report(
                records, read_records(before / "scaling.jsonl") if before else []
            )
        else:
            reports[name] = report(records)
        if name in FIGURES:
            figures.append(folder / f"{name}.png")
            FIGURES[name](records, figures[-1])
    if (folder / "micro.json").exists():
        reports["micro"] = micro.report(json.loads((folder / "micro.json").read_text()))
    for name, text in reports.items():
        (folder / f"{name}.md").write_text(text)
    for path in [*(folder / f"{name}.md" for name in reports), *figures]:
        print(path)
    return reports | {"bounds": bounds_note(all_records)}, figures


def write_page(path, reports, figures):
    """Writes the page and puts its figures into images/ beside it."""
    before = path.read_text() if path.exists() else ""
    path.write_text(compose(TEMPLATE.read_text(), reports, before))
    print(path)
    for figure in figures:
        print(shutil.copy(figure, path.parent / "images"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "folder", type=Path, nargs="?", default=Path("out/bench"), help="where the records are"
    )
    parser.add_argument("--before", type=Path, help="folder of an earlier run, to compare with")
    parser.add_argument("--docs", type=Path, help="page to write from them all, docs/benchmarks.md")
    arguments = parser.parse_args()
    reports, figures = write_reports(arguments.folder, arguments.before)
    if arguments.docs:
        write_page(arguments.docs, reports, figures)


if __name__ == "__main__":
    main()
