"""The schema of results, docs/result.schema.json."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parents[2] / "docs"
SCHEMA: dict[str, Any] = json.loads((DOCS / "result.schema.json").read_text(encoding="utf-8"))


def closed() -> dict[str, Any]:
    """The schema with every object closed: a field that it does not list is an error."""
    schema = copy.deepcopy(SCHEMA)
    for part in (schema, *schema["$defs"].values()):
        for field in part["properties"].values():
            _close(field)
    schema["unevaluatedProperties"] = False
    return schema


def _close(field: dict[str, Any]) -> None:
    for inner in field.get("properties", {}).values():
        _close(inner)
    if "items" in field:
        _close(field["items"])
    is_object = any(key in field for key in ("properties", "allOf", "$ref"))
    if is_object and "additionalProperties" not in field:
        field["unevaluatedProperties"] = False
