"""Parts of a page that programs write: between <!-- begin NAME --> and <!-- end NAME -->."""

from __future__ import annotations

import re
from pathlib import Path

from reports.page import fold_tables


def replace_block(page: Path, name: str, text: str) -> None:
    """Writes the text into its block of the page.

    Raises
    ------
    SystemExit
        Where the page has no such block, or several.
    """
    begin, end = f"<!-- begin {name} -->\n", f"<!-- end {name} -->"
    changed, count = re.subn(
        f"{begin}.*?{end}",
        lambda _: f"{begin}{text}{end}",
        page.read_text(),
        flags=re.DOTALL,
    )
    if count != 1:
        raise SystemExit(f"{page}: no block of {name}")
    page.write_text(fold_tables(changed))
