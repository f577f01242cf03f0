"""Parts of the pages that programs write: between <!-- begin NAME --> and <!-- end NAME -->."""

from __future__ import annotations

from pathlib import Path

from reports.page import BLOCK, fold_tables


def replace_block(docs: Path, name: str, text: str) -> None:
    """Writes the text into its block, on the page of docs/benchmarks that has it, or on this page.

    Raises
    ------
    SystemExit
        Where no page has such a block, or several have.
    """
    paths = [docs] if docs.is_file() else sorted((docs / "benchmarks").glob("*.md"))
    pages = {path: path.read_text() for path in paths}
    found = [(path, block) for path in pages for block in _blocks(pages[path], name)]
    if len(found) != 1:
        raise SystemExit(f"{docs}: {len(found)} blocks of {name}, not one")
    path, block = found[0]
    new = f"<!-- begin {name} -->\n{text.rstrip()}\n<!-- end {name} -->"
    path.write_text(fold_tables(pages[path].replace(block, new)))


def _blocks(page: str, name: str) -> list[str]:
    return [block[0] for block in BLOCK.finditer(page) if block["name"] == name]
