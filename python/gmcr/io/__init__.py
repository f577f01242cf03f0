"""Files of point clouds, by extension.

>>> from gmcr.io import read_points
>>> points = read_points("scan.laz")  # (N, 3) float64

PLY, PCD, XYZ, PTS, CSV, NumPy, KITTI and nuScenes files need nothing else. Others need an extra:

===============================  ================  ==================
files                            extra             library
===============================  ================  ==================
.las, .laz                       ``gmcr[las]``     laspy with lazrs
.e57                             ``gmcr[e57]``     pye57
.bag, .mcap, .db3, ROS 2 folder  ``gmcr[rosbag]``  rosbags
compressed .pcd, .obj .stl .off  ``gmcr[open3d]``  Open3D
===============================  ================  ==================
"""

from ._cloud import Cloud, CloudFileError, StampedCloud
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
