#!/usr/bin/python3
"""Writes BENCHMARK.md, one screen, from the recorded tables of docs/benchmarks.

bench/summary.py [--check]    --check writes nothing, and fails where the page would be another

Every figure is looked up in a table by its heading, row and column; ratios are of one table, whose
runs were recorded together.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
RECORDS = ROOT / "docs/benchmarks"
PAGE = ROOT / "BENCHMARK.md"
COMPARED = ("success %", "median ms", "median error")  # theirs against ours
RIVALS = ("KISS-Matcher", "FGR (Open3D)", "RANSAC (Open3D)", "RANSAC10k")

Row = dict[str, str]


class Records:
    """The tables of pages, by the heading that they stand under."""

    def __init__(self, pages: str) -> None:
        self._sections = dict(_sections(pages))
        self._pages = pages

    @classmethod
    def read(cls) -> Records:
        """Those of the project."""
        return cls("\n".join(page.read_text() for page in sorted(RECORDS.glob("*.md"))))

    def rows(self, heading: str, column: str) -> list[Row]:
        """Rows of the first table under a heading that has a column of that name."""
        for table in _tables(self._sections[heading]):
            if column in table[0]:
                return table
        raise KeyError(f"no table under '{heading}' has a column '{column}'")

    def row(self, heading: str, column: str, **key: str) -> Row:
        """The row whose cells are those of the key, with blanks for underscores in its names."""
        wanted = {name.replace("_", " "): value for name, value in key.items()}
        for row in self.rows(heading, column):
            if all(row.get(name) == value for name, value in wanted.items()):
                return row
        raise KeyError(f"no row {wanted} under '{heading}'")

    def bounds(self) -> str:
        """How often the truth lies above a proven bound, of all runs of all pages."""
        found = re.findall(r"above a proven upper bound in (\d+) of (\d+) runs", self._pages)
        above, runs = (sum(map(int, counts)) for counts in zip(*found, strict=True))
        return f"The truth lies above a proven upper bound in {above} of {runs} runs"

    def sentence(self, heading: str, pattern: str) -> str:
        """The first match of a pattern under a heading, on one line."""
        found = re.search(pattern, self._sections[heading])
        if not found:
            raise KeyError(f"under '{heading}' no page says '{pattern}'")
        return " ".join(found[0].split())


def _sections(pages: str) -> Iterator[tuple[str, str]]:
    parts = re.split(r"^#+ (.+)$", pages, flags=re.MULTILINE)
    yield from zip(parts[1::2], parts[2::2], strict=True)


def _tables(text: str) -> list[list[Row]]:
    return [_rows(table) for table in re.findall(r"^\|.+(?:\n\|.*)+", text, re.MULTILINE)]


def _rows(table: str) -> list[Row]:
    cells = [
        [cell.strip() for cell in line.strip().strip("|").split("|")] for line in table.split("\n")
    ]
    names = cells[0]
    # of two columns of one name, such as those of an earlier run, the first is meant
    return [dict(reversed(list(zip(names, line, strict=False)))) for line in cells[2:]]


def number(cell: str) -> float:
    """The first number of a cell, such as 22.1 of '22.1 (12.8-28.6)'."""
    found = re.search(r"-?[\d,]*\.?\d+(?:e-?\d+)?", cell)
    if not found:
        raise ValueError(f"no number in '{cell}'")
    return float(found[0].replace(",", ""))


def ratio(cell: str, ours: str) -> str:
    """How many times as long as ours, such as '4.2 x'."""
    times = number(cell) / number(ours)
    more = "> " if cell.startswith(">") else ""
    return f"{more}{times:.0f} x" if times >= 10 else f"{more}{times:.1f} x"


def markdown(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table."""
    lines = [f"| {' | '.join(row)} |" for row in (head, ["---"] * len(head), *rows)]
    return "\n".join(lines)


def real_matches(records: Records) -> str:
    heading = "Real matches, known scale"
    rows = []
    for method in ("gmcr", *RIVALS):
        cells = [method]
        for name in ("kitti_fpfh", "gore"):
            of = records.row(heading, "time ms", set=name, method=method)
            ours = records.row(heading, "time ms", set=name, method="gmcr")
            share = f"{number(of['success %']):.0f} %"
            time = (
                f"{number(of['time ms']):.3g} ms"
                if method == "gmcr"
                else ratio(of["time ms"], ours["time ms"])
            )
            cells += [share, time]
        rows.append(cells)
    head = ("", "KITTI, FPFH: right", "time", "GORE, PFH: right", "time")
    return markdown(head, rows)


def structured(records: Records) -> str:
    heading = "Robust registration with structured outliers, unknown scale"
    methods = ("gmcr", "gmcr-paper", "RANSAC10k", "RANSAC (Open3D)")
    rows = [
        [
            f"{wrong} % wrong",
            *(
                f"{number(records.row(heading, 'gmcr', **{'outliers_%': wrong})[m]):.0f} %"
                for m in methods
            ),
        ]
        for wrong in ("80", "90", "95")
    ]
    return markdown(("matches in clusters", "gmcr", "the paper's stages", *methods[2:]), rows)


def times(records: Records) -> str:
    heading = "Time against N and outlier rate, known scale"
    rows = []
    for num, wrong in (("1,000", "50"), ("1,000", "95"), ("1,000", "99"), ("5,000", "90")):
        row = records.row(heading, "gmcr", N=num, **{"outliers_%": wrong})
        cells = [f"{num}, {wrong} % wrong", f"{number(row['gmcr']):.3g} ms"]
        for method in RIVALS:
            right = row[method].partition("; ")[2]
            cells.append(
                ratio(row[method], row["gmcr"]) + ("" if right == "3 of 3" else f", {right} right")
            )
        rows.append(cells)
    return markdown(("matches", "gmcr", *RIVALS), rows)


def clouds(records: Records) -> str:
    rows = records.rows("Raw clouds, default options", "right by translation")
    total: Counter[str] = Counter()
    for row in rows:
        if row["refine"] != "icp":
            continue
        right, _, pairs = row["right"].split()
        total.update(right=int(right), pairs=int(pairs), trusted=int(row["trusted"]))
        total.update(wrong=int(row["trusted but wrong"]))
    return (
        f"{total['right']} of {total['pairs']} real pairs (scans, objects, LiDAR, RGB-D) right "
        f"with nothing chosen, {total['trusted']} of them trusted, {total['wrong']} wrong ones "
        "trusted."
    )


def verdicts(records: Records) -> str:
    rows = records.rows("The verdict on matches", "untrusted")
    tried = sum(int(row["n"]) for row in rows if "not found" not in row)
    trusted = sum(int(row["trusted"]) for row in rows if "not found" not in row)
    return f"{trusted} of {tried:,} problems without a right match are trusted."


def scaling(records: Records) -> str:
    rows = []
    for scenario, num, wrong in (
        ("known scale", "10,000", "99"),
        ("known scale", "100,000", "99"),
        ("unknown scale", "1,000", "98"),
        ("unknown scale", "10,000", "90"),
    ):
        row = records.row("Budgets", "budget ms", scenario=scenario, N=num, **{"outliers_%": wrong})
        rows.append(
            [
                f"{scenario}, {num}, {wrong} % wrong",
                row["right"],
                f"{row['ms']} ms",
                f"{row['MB']} MB",
            ]
        )
    return markdown(("matches", "right", "time", "memory"), rows)


def losses(records: Records) -> str:
    """Each group of runs in which a rival beats us, and in how many counting does."""
    rows = records.rows("Where we lose", "how")
    rivals = [row for row in rows if row["method"] in RIVALS]
    cells = [
        [
            row["method"], row["how"], f"{row['experiment']}: {_brief(row['where'])}",
            *(row[name].replace(" against ", " / ") for name in COMPARED),
        ]
        for row in rivals
    ]  # fmt: skip
    own = len(rows) - len(rivals)
    return (
        markdown(["method", "", "where", "right, %", "ms", "error"], cells)
        + f"\n\nOur own other methods, the plain count and the paper's stages: {own} groups more."
    )


def _brief(where: str) -> str:
    """A group of runs without the names of those fields that its values tell."""
    rate = r"outlier_rate ([\d.]+)"
    said = re.sub(rate, lambda found: f"{100 * float(found[1]):g} % wrong", where)
    said = re.sub(r"bound_factor ([\d.]+)", r"\1 x the bound", said)
    return re.sub(r"\b(?:kind|setting|set|scan) ", "", said)


def teaser(records: Records) -> str:
    """Whether TEASER++ was among the rivals."""
    said = records.sentence("The paper's experiments", r"(?s)`teaser\+\+`.{0,300}")
    return "TEASER++ could not be installed where this was recorded." if "skipped" in said else ""


def compose(records: Records) -> str:
    """The page."""
    experiments = "The paper's experiments"
    machine = records.sentence(experiments, r"Recorded on [\d-]+ by `make bench-paper`")
    computer = records.sentence(experiments, r"(?<=\), )[^,;]+, \w+, \d+ cores, Python [\d.]+")
    return f"""# Benchmarks on one screen

Written by `bench/summary.py` from the recorded tables of [docs/benchmarks.md](docs/benchmarks.md);
a test holds them together. Ratios are of one run: how many times as long as gmcr the others take
on the same bytes, all cores each. {machine}
on {computer}; the rest by `make bench` on the same machine.

**Real matches, 95 to 99.5 % wrong** (7 and 6 pairs, three rotations each)

{real_matches(records)}

**Wrong matches that agree with each other** (N = 90, unknown scale, right poses)

{structured(records)}

**Time, known scale**

{times(records)}

**Large problems**

{scaling(records)}

**Raw clouds.** {clouds(records)}
**The verdict.** {verdicts(records)}
**The certificate.** {records.bounds()}.

## Where we lose

Theirs / ours, of all groups of runs (medians; errors in degrees for noise, else metres):

{losses(records)}

Why: [where we lose](docs/benchmarks/paper.md#where-we-lose). {teaser(records)}

A method or a data set of yours: [how](docs/adding_benchmarks.md).
"""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--check", action="store_true", help="fail where the page is not up to date"
    )
    given = parser.parse_args()
    page = compose(Records.read())
    if not given.check:
        PAGE.write_text(page)
        return 0
    if PAGE.read_text() == page:
        return 0
    print("BENCHMARK.md is not what the records say: run bench/summary.py", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
