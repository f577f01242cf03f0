"""Pose of two clouds: 02_clouds.py SOURCE TARGET, as .npy, or whatever Open3D reads."""

from __future__ import annotations

import sys
from pathlib import Path

import gmcr
import numpy as np
import numpy.typing as npt


def read(path: Path) -> npt.NDArray[np.float64]:
    """Points of a file, (N, 3), metres."""
    if path.suffix == ".npy":
        return np.asarray(np.load(path), dtype=np.float64)
    try:
        import open3d  # type: ignore[import-not-found, unused-ignore]
    except ImportError:
        sys.exit(f"{path}: needs Open3D, pip install 'gmcr[open3d]'")
    return np.asarray(open3d.io.read_point_cloud(str(path)).points)


def main() -> None:
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    source, target = (read(Path(name)) for name in sys.argv[1:])
    result = gmcr.register_clouds(source, target)
    print(result)
    print(f"{result.verdict}: {result.verdict_reason}")
    print(result.matrix())


if __name__ == "__main__":
    main()
