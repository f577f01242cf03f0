"""Where the real data lies, and how its clouds, poses and matches are read."""

from __future__ import annotations

import csv
import os
from pathlib import Path

import numpy as np

from paper.problem import Pose, pose_from_matrix

CHECKOUT = Path(__file__).resolve().parents[2]

# pairs of raw clouds, a folder each
CLOUD_SETS = (
    "stanford_scans",
    "mian_views",
    "mining_lidar",
    "lidar",
    "3dmatch",
    "rgbd_frames",
    "objects_uwa",
    "objects_ycb",
    "object_scans",
    "objects_rgbd",
)


class DataAbsent(Exception):
    """A set that an experiment needs is not there; the message says which."""


def data_root() -> Path:
    return Path(os.environ.get("GMCR_DATA", CHECKOUT.parent / "shared" / "data"))


def pairs_of(set_name: str) -> list[Path]:
    """Folders of the pairs of a set, in order of their names.

    Raises
    ------
    DataAbsent
        Where the set is absent or empty.
    """
    folders = sorted(path.parent for path in (data_root() / set_name).glob("*/T_target_source.txt"))
    if not folders:
        raise DataAbsent(f"{data_root() / set_name} is absent; set GMCR_DATA")
    return folders


def read_points(path: Path) -> np.ndarray:
    """(N, 3) finite points of a binary little-endian PLY of float x, y, z, as the data sets hold.

    Raises
    ------
    DataAbsent
        Where the file is absent.
    ValueError
        Where it is laid out otherwise.
    """
    if not path.exists():
        raise DataAbsent(f"{path} is absent; set GMCR_DATA")
    header, _, body = path.read_bytes().partition(b"end_header\n")
    lines = [line for line in header.decode("ascii").splitlines() if not line.startswith("comment")]
    properties = [line.split()[1:] for line in lines if line.startswith("property")]
    if "binary_little_endian" not in lines[1] or properties != [["float", axis] for axis in "xyz"]:
        raise ValueError(f"{path}: not a binary little-endian PLY of float x, y, z")
    points = np.frombuffer(body, dtype="<f4").reshape(-1, 3).astype(float)
    return points[np.isfinite(points).all(axis=1)]


def read_pose(path: Path) -> Pose:
    return pose_from_matrix(np.loadtxt(path))


def read_matches(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Matched (N, 3) source and target points of a correspondences.csv."""
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    columns = ["sx", "sy", "sz", "tx", "ty", "tz"]
    values = np.array([[float(row[column]) for column in columns] for row in rows])
    return values[:, :3], values[:, 3:]


def listed(set_name: str, pair: str, column: str) -> float:
    """A number of the pair in INVENTORY.csv, such as its radius or resolution."""
    with (data_root() / "INVENTORY.csv").open(newline="") as file:
        for row in csv.DictReader(file):
            if row["set"] == set_name and row["name"] == pair:
                return float(row[column])
    raise DataAbsent(f"{data_root() / 'INVENTORY.csv'} does not list {set_name}/{pair}")
