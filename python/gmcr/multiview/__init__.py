"""Many scans in one frame: registration of pairs, consistent cycles, pose graph, merged cloud.

>>> from gmcr.multiview import merge_scans, register_scans
>>> result = register_scans(scans)  # list of (N_i, 3)
>>> print(result.summary())
>>> cloud = merge_scans(scans, result.poses, voxel_size=0.01)

The pose graph is optimised by Open3D: ``pip install 'gmcr[multiview]'``.
"""

from ._edge import Edge, point_information
from ._merge import merge_scans
from ._pairs import register_pairs
from ._place import place_scans
from ._register import register_scans
from ._result import Component, JudgedEdge, MultiviewResult

__all__ = [
    "Component",
    "Edge",
    "JudgedEdge",
    "MultiviewResult",
    "merge_scans",
    "point_information",
    "place_scans",
    "register_pairs",
    "register_scans",
]
