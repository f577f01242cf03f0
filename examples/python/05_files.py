"""Files of clouds: what is written comes back as the same bits, and notes say what was decided."""

from __future__ import annotations

import tempfile
from pathlib import Path

import gmcr.io
import numpy as np


def main() -> None:
    points = np.array([[0.1, 2, 3], [4, 5.25, -6], [7, 8, 1e-3]])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        gmcr.io.write_points(folder / "cloud.ply", points)  # aside, renamed once it is whole
        print("the same bits:", np.array_equal(gmcr.io.read_points(folder / "cloud.ply"), points))

        (folder / "table.txt").write_text("x;y;z;intensity\n0,5;2;3;17\n4;5,25;-6;18\n")
        cloud = gmcr.io.read_cloud(folder / "table.txt")
        print(f"{len(cloud.points)} points;", *cloud.notes)
        try:
            gmcr.io.read_points(folder / "cloud.docx")
        except (OSError, ValueError) as error:  # missing or broken, or of no kind that is read
            print(str(error).partition(" .ply")[0])


if __name__ == "__main__":
    main()
