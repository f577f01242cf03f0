#!/usr/bin/python3
"""Turns the records of the benchmarks (*.jsonl) into Markdown tables (*.md) and figures (*.png)."""

import argparse
import json
import shutil
from pathlib import Path

from reports import batch, clique, clouds, correspondences, micro, paper_synthetic, scaling
from reports.page import TEMPLATES, compose, missing
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

FIGURES = {"scaling": scaling.draw}


def write_reports(folder, before):
    """Writes a report beside each file of records.

    Returns the reports by name and the paths of the figures.
    """
    reports, figures = {}, []
    for name, report in REPORTS.items():
        records = read_records(folder / f"{name}.jsonl")
        if not records:
            continue
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
    return reports, figures


def write_pages(docs, reports, figures):
    """Writes the pages whose reports are there into benchmarks/, their figures into images/."""
    for template in sorted(TEMPLATES.glob("*.md")):
        page, text = docs / "benchmarks" / template.name, template.read_text()
        if absent := missing(text, reports):
            print(f"{page} is left as it is: no records of {', '.join(absent)}")
            continue
        page.write_text(compose(text, reports, page.read_text() if page.exists() else ""))
        print(page)
    for figure in figures:
        print(shutil.copy(figure, docs / "images"))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "folder", type=Path, nargs="?", default=Path("out/bench"), help="where the records are"
    )
    parser.add_argument("--before", type=Path, help="folder of an earlier run, to compare with")
    parser.add_argument("--docs", type=Path, help="folder of the pages to write from them")
    arguments = parser.parse_args()
    reports, figures = write_reports(arguments.folder, arguments.before)
    if arguments.docs:
        write_pages(arguments.docs, reports, figures)


if __name__ == "__main__":
    main()
