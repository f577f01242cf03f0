"""The schema of results, docs/result.schema.json, and the rows that docs/json.md has to hold."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parents[2] / "docs"
SCHEMA: dict[str, Any] = json.loads((DOCS / "result.schema.json").read_text(encoding="utf-8"))

Row = tuple[str, str, str, str]


def closed() -> dict[str, Any]:
    """The schema with every object closed: a field that it does not list is an error."""
    schema = copy.deepcopy(SCHEMA)
    for part in (schema, *schema["$defs"].values()):
        for field in part["properties"].values():
            _close(field)
    schema["unevaluatedProperties"] = False
    return schema


def rows() -> list[Row]:
    """Path, type, unit and meaning of each field, in the order of the page."""
    parts = SCHEMA["$defs"]
    order = (parts["pose"], parts["consensus"], parts["instance"], SCHEMA, parts["clouds"])
    return [row for part in order for row in _rows(part, "")]


def rows_of_page() -> list[Row]:
    """What the tables of the page say."""
    lines = (DOCS / "json.md").read_text(encoding="utf-8").splitlines()
    cells = (
        [cell.strip() for cell in line.strip("|").split(" | ")]
        for line in lines
        if line[:3] == "| `"
    )
    return [(path.strip("`"), kind, unit, meaning) for path, kind, unit, meaning in cells]


def _close(field: dict[str, Any]) -> None:
    for inner in field.get("properties", {}).values():
        _close(inner)
    if "items" in field:
        _close(field["items"])
    is_object = any(key in field for key in ("properties", "allOf", "$ref"))
    if is_object and "additionalProperties" not in field:
        field["unevaluatedProperties"] = False


def _rows(part: dict[str, Any], prefix: str) -> Iterator[Row]:
    for name, field in part["properties"].items():
        yield prefix + name, _type(field), field["unit"], field["description"]
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
