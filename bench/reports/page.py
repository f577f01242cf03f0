"""The pages of the benchmarks: templates that hold the prose, filled in with the reports."""

import re
from collections.abc import Mapping
from pathlib import Path

TEMPLATES = Path(__file__).with_name("pages")  # of docs/benchmarks, by the same names

PLACE = re.compile(
    r"^\{\{(?P<name>\w+)(?: (?P<side>until|from) (?P<heading>.+))?\}\}$", re.MULTILINE
)
BLOCK = re.compile(r"<!-- begin (?P<name>\S+) -->\n.*?<!-- end (?P=name) -->", re.DOTALL)

LONGEST = 8  # rows of a table that is not folded
_TABLE = re.compile(r"(?P<summary></summary>\n\n)?^\|.*\n\|[ -|]*\n(?:\|.*\n)+", re.MULTILINE)


def compose(template: str, reports: Mapping[str, str], page_before: str) -> str:
    """The page that a template and reports make.

    Parameters
    ----------
    template
        Markdown. A line ``{{name}}`` stands for a report; ``{{name until Heading}}`` and
        ``{{name from Heading}}`` for what it holds before, and from, one of its headings of the
        second level.
    reports
        Markdown by name. Headings go down by one level, as the page has one title.
    page_before
        The page that this one replaces. What stands there between ``<!-- begin name -->`` and
        ``<!-- end name -->``, where other programs write, is kept.

    Raises
    ------
    ValueError
        Where the template names a report, a heading or a block that is not there.
    """
    page = PLACE.sub(lambda place: _text_at(place, reports), template)
    kept = {block["name"]: block[0] for block in BLOCK.finditer(page_before)}
    lost = kept.keys() - {block["name"] for block in BLOCK.finditer(page)}
    if lost:
        raise ValueError(f"the template has no place for the blocks {sorted(lost)}")
    page = BLOCK.sub(lambda block: kept.get(block["name"], block[0]), page)
    return fold_tables(re.sub(r"\n{3,}", "\n\n", page).strip() + "\n")


def missing(template: str, reports: Mapping[str, str]) -> list[str]:
    """The reports that a template asks for and that are not there."""
    return sorted({place["name"] for place in PLACE.finditer(template)} - reports.keys())


def _text_at(place: re.Match[str], reports: Mapping[str, str]) -> str:
    name, side, heading = place["name"], place["side"], place["heading"]
    if name not in reports:
        raise ValueError(f"{place[0]}: no records of {name}")
    text = reports[name]
    if side:
        start = text.find(f"\n## {heading}\n") + 1
        if start == 0:
            raise ValueError(f"{place[0]}: no heading {heading}")
        text = text[:start] if side == "until" else text[start:]
    return re.sub(r"^(#+ )", r"#\1", text, flags=re.MULTILINE).strip()


def fold_tables(page: str) -> str:
    """The page with its long tables folded, so that it can be read; folded ones stay so."""
    return _TABLE.sub(_folded, page)


def _folded(table: re.Match[str]) -> str:
    head, _, *rows = table[0].strip().split("\n")
    if len(rows) <= LONGEST or table["summary"]:
        return table[0]
    columns = [cell.strip() for cell in head.strip("|").split("|")]
    shown = ", ".join(column for column in columns[:3] if column)
    summary = f"{len(rows)} rows: {shown}{', ...' if len(columns) > 3 else ''}"
    return (
        f'<details markdown="1"><summary>{summary}</summary>\n\n{table[0].strip()}\n\n</details>\n'
    )
