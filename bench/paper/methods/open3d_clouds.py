"""What the methods of Open3D share."""

from __future__ import annotations

import numpy as np

from paper.methods.registry import Method
from paper.problem import Problem


class Open3dMethod(Method):
    """Holds the matches as two clouds and a list of index pairs."""

    modules = ("open3d",)
    distribution = "open3d"

    def load(self, problem: Problem) -> None:
        import open3d

        vectors = open3d.utility.Vector3dVector
        self.source = open3d.geometry.PointCloud(vectors(problem.source))
        self.target = open3d.geometry.PointCloud(vectors(problem.target))
        pairs = np.repeat(np.arange(len(problem.source), dtype=np.int32)[:, None], 2, axis=1)
        self.matches = open3d.utility.Vector2iVector(pairs)
