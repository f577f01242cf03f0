"""The C++ reference from the comments of the public headers."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

_COMMENT = re.compile(r"^\s*/// ?(?P<text>.*)$")
_SKIPPED = re.compile(r"^(#|namespace|using |template|public:|private:|}|$)")


def reference(headers: Path) -> str:
    """A page of Markdown: a section a header, its documented names and what their comments say.

    Parameters
    ----------
    headers : Path
        Folder of the public headers.
    """
    parts = [
        "# C++ reference",
        "What the public headers declare, namespace `gmcr`. Made from their comments.",
    ]
    for path in sorted(headers.glob("*.hpp")):
        entries = list(_entries(path.read_text().splitlines()))
        if not entries:
            continue
        parts.append(f"## gmcr/{path.name}")
        for comment, declaration in entries:
            parts += [f"```cpp\n{declaration}\n```", _prose(comment)]
    return "\n\n".join(parts) + "\n"


def _entries(lines: list[str]) -> Iterator[tuple[list[str], str]]:
    """Comments outside of structs, each with the whole declaration that follows it."""
    index = 0
    while index < len(lines):
        comment = []
        while index < len(lines) and (found := _COMMENT.match(lines[index])):
            comment.append(found["text"])
            index += 1
        if not comment:
            index += 1
            continue
        end = _end_of_declaration(lines, index)
        declaration = "\n".join(_without_body(lines[index:end])).strip()
        if declaration and not declaration.startswith(("#", "namespace")):
            yield comment, declaration
        index = end


def _end_of_declaration(lines: list[str], start: int) -> int:
    """Line after the declaration: at the semicolon, or where its braces are closed."""
    depth = 0
    for index in range(start, len(lines)):
        code = lines[index].split("//")[0]
        depth += code.count("{") + code.count("(") - code.count("}") - code.count(")")
        if depth <= 0 and code.rstrip().endswith((";", "}")):
            return index + 1
    return len(lines)


def _without_body(lines: list[str]) -> list[str]:
    """What a caller needs: the declaration, without what is private."""
    private = next((i for i, line in enumerate(lines) if line.strip() == "private:"), None)
    return lines if private is None else [*lines[:private], "};"]


def _prose(comment: list[str]) -> str:
    """A comment as Markdown: its tags as a list."""
    text = ""
    for line in comment:
        tag = re.match(r"@(param|return|throws|tparam)\s+(.*)", line)
        if tag:
            name = {"param": "", "return": "returns ", "throws": "throws ", "tparam": ""}[tag[1]]
            text += f"\n- {name}{tag[2]}"
        elif text.rpartition("\n")[2].startswith("- ") and line.startswith("  "):
            text += " " + line.strip()
        elif text.rpartition("\n")[2].startswith("- "):
            text += "\n\n" + line
        else:
            text += "\n" + line
    return _escaped(re.sub(r"(?<!\n)\n- ", "\n\n- ", text.strip(), count=1))


def _escaped(text: str) -> str:
    """Text whose angle brackets, pipes and stars outside of code are no markup."""
    spans = re.split(r"(`[^`]*`)", text)
    return "".join(
        span if span.startswith("`") else re.sub(r"([<>|*_\[\]])", r"\\\1", span) for span in spans
    )
