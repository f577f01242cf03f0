"""Files of point clouds, by extension.

>>> from gmcr.io import read_points
>>> points = read_points("scan.laz")  # (N, 3) float64

PLY, PCD, text tables, NumPy, KITTI and nuScenes files and meshes (PLY, OBJ, OFF, STL) are read by
the same code as in the tool and need nothing else. Others need an extra:

===============================  ================  ==================
files                            extra             library
===============================  ================  ==================
.las, .laz                       ``gmcr[las]``     laspy with lazrs
.e57                             ``gmcr[e57]``     pye57
.bag, .mcap, .db3, ROS 2 folder  ``gmcr[rosbag]``  rosbags
===============================  ================  ==================
"""

from .._gmcr import CloudFileError
from ._cloud import Cloud, StampedCloud
from ._read import read_cloud, read_clouds, read_points
from ._write import write_points

__all__ = [
    "Cloud",
    "CloudFileError",
    "StampedCloud",
    "read_cloud",
    "read_clouds",
    "read_points",
    "write_points",
]
