"""``gmcr`` and ``python -m gmcr``: the command-line tool, which the wheel holds."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

TOOL = Path(__file__).parent / "bin" / "gmcr"


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the tool; 0 pose found, 1 no pose, 2 bad usage or input, 3 file cannot be read."""
    given = sys.argv[1:] if arguments is None else list(arguments)
    if not TOOL.exists():
        print(
            f"gmcr: {TOOL} is missing: the package was built with GMCR_BUILD_APPS=OFF",
            file=sys.stderr,
        )
        return 3
    # reports are drawn by the Python that runs this
    environment = {"GMCR_PYTHON": sys.executable, **os.environ}
    return subprocess.call([str(TOOL), *given], env=environment)


if __name__ == "__main__":
    sys.exit(main())
