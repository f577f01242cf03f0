"""Formats that Open3D decodes: compressed PCD, and the vertices of meshes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from ._cloud import CloudFileError, import_extra, reading_with


def read_with_open3d(path: Path) -> npt.NDArray[np.float64]:
    """Coordinates of the points or vertices, (N, 3)."""
    open3d = import_extra("open3d", "open3d", path)
    path.open("rb").close()  # Open3D returns an empty cloud where there is no file
    quiet = open3d.utility.VerbosityContextManager(open3d.utility.VerbosityLevel.Error)
    with quiet, reading_with("Open3D", path):
        if path.suffix.lower() == ".pcd":
            cloud = open3d.io.read_point_cloud(
                str(path), remove_nan_points=False, remove_infinite_points=False
            )
            points = np.asarray(cloud.points)
        else:
            points = np.asarray(open3d.io.read_triangle_mesh(str(path)).vertices)
    if len(points) == 0:
        raise CloudFileError(path, "Open3D found no points in it")
    return points
