"""Pose of two clouds: 02_clouds.py SOURCE TARGET, of any format that gmcr.io reads."""

from __future__ import annotations

import sys

import gmcr
import gmcr.io


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    source, target = (gmcr.io.read_points(name) for name in sys.argv[1:])
    result = gmcr.register_clouds(source, target)
    print(result)
    print(f"{result.verdict}: {result.verdict_reason}")
    print(result.matrix())


if __name__ == "__main__":
    main()
