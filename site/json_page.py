#!/usr/bin/env python3
"""Writes the tables of docs/json.md from docs/result.schema.json.

site/json_page.py [--check] [PAGE]

The schema is the one place that says type, unit and meaning of a field. A table stands between
<!-- begin NAME --> and <!-- end NAME -->; what is around it is prose. --check writes nothing, and
fails where the page would be another.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parents[1] / "docs"
SCHEMA: dict[str, Any] = json.loads((DOCS / "result.schema.json").read_text(encoding="utf-8"))
_PARTS = SCHEMA["$defs"]
#: The parts of the schema that each table holds, in their order.
TABLES = {
    "pose": (_PARTS["pose"], _PARTS["consensus"], _PARTS["instance"]),
    "work": (SCHEMA,),
    "clouds": (_PARTS["clouds"],),
}


def compose(page: str) -> str:
    """The page with the tables that the schema makes.

    Raises
    ------
    ValueError
        Where the page has no place for a table, or several.
    """
    for name, parts in TABLES.items():
        begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
        if (page.count(begin), page.count(end)) != (1, 1):
            raise ValueError(f"the page has not one block '{name}'")
        lines = ["| field | type | unit | meaning |", "|---|---|---|---|"]
        lines += [row for part in parts for row in _rows(part, "")]
        before, after = page.partition(begin)[0], page.partition(end)[2]
        page = f"{before}{begin}\n" + "\n".join(lines) + f"\n\n{end}{after}"
    return page


def _rows(part: dict[str, Any], prefix: str) -> Iterator[str]:
    for name, field in part["properties"].items():
        meaning = field["description"].replace("|", "\\|")
        yield f"| `{prefix}{name}` | {_type(field)} | {field['unit']} | {meaning} |"
        if "properties" in field:
            yield from _rows(field, f"{prefix}{name}.")
        elif "properties" in field.get("items", {}):
            yield from _rows(field["items"], f"{prefix}{name}[].")


def _type(field: dict[str, Any]) -> str:
    kind = field.get("type", "object")
    if isinstance(kind, list):
        return " or ".join(kind)
    if kind != "array":
        return str(kind)
    least, most = field.get("minItems"), field.get("maxItems")
    size = "" if least is None else str(least) if least == most else f"{least} or {most}"
    item = _type(field["items"])
    return f"[{size}]{'' if item.startswith('[') else ' '}{item}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("page", type=Path, nargs="?", default=DOCS / "json.md")
    parser.add_argument(
        "--check", action="store_true", help="fail where the page is not up to date"
    )
    given = parser.parse_args()
    before = given.page.read_text(encoding="utf-8")
    page = compose(before)
    if not given.check:
        given.page.write_text(page, encoding="utf-8")
        return 0
    if before == page:
        return 0
    print(f"{given.page} is not what the schema says: run site/json_page.py", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
