"""Files of clouds that other libraries read: each test writes with the library itself."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from gmcr.io import CloudFileError, StampedCloud, read_cloud, read_clouds, read_points

POINTS = np.array([[0.25, -2, 3], [1, 0, 0.5], [-7, 8.5, 9]])
FAR = np.array([2_600_000.123, 1_200_000.456, 431.789])  # metres, a national grid


@pytest.mark.parametrize(
    ("extension", "library", "extra"),
    [
        (".las", "laspy", "las"),
        (".laz", "laspy", "las"),
        (".e57", "pye57", "e57"),
        (".bag", "rosbags", "rosbag"),
        (".mcap", "rosbags", "rosbag"),
        (".db3", "rosbags", "rosbag"),
    ],
)
def test_an_absent_library_is_an_import_error_that_names_the_extra(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, extension: str, library: str, extra: str
) -> None:
    original = importlib.import_module

    def without_library(name: str, package: str | None = None) -> Any:
        if name.split(".")[0] == library:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return original(name, package)

    monkeypatch.setattr(importlib, "import_module", without_library)
    (tmp_path / f"a{extension}").touch()
    with pytest.raises(ImportError, match=rf"this needs {library}; pip install 'gmcr\[{extra}\]'"):
        read_points(tmp_path / f"a{extension}")


def test_a_library_that_lacks_a_module_of_its_own_says_so_itself(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def broken(name: str, package: str | None = None) -> Any:
        raise ModuleNotFoundError("No module named 'lost'", name="lost")

    monkeypatch.setattr(importlib, "import_module", broken)
    with pytest.raises(ImportError, match="lost"):
        read_points(tmp_path / "a.las")


@pytest.mark.parametrize(
    ("extension", "library"),
    [
        (".las", "laspy"),
        (".laz", "laspy"),
        (".e57", "pye57"),
        (".bag", "rosbags"),
        (".mcap", "rosbags"),
        (".db3", "rosbags"),
    ],
)
def test_bytes_that_are_no_such_file_are_errors_that_name_it(
    tmp_path: Path, extension: str, library: str
) -> None:
    pytest.importorskip(library)
    for name, content in (("empty", b""), ("noise", bytes(range(256)) * 20)):
        path = tmp_path / f"{name}{extension}"
        path.write_bytes(content)
        with pytest.raises(CloudFileError, match=f"{name}{extension}: "):
            read_points(path)
        assert path.read_bytes() == content


@pytest.mark.parametrize("extension", [".las", ".laz"])
def test_las_coordinates_keep_their_millimetres_far_from_the_origin(
    tmp_path: Path, extension: str
) -> None:
    laspy = pytest.importorskip("laspy")
    header = laspy.LasHeader(point_format=3, version="1.2")
    header.scales, header.offsets = np.full(3, 0.001), np.floor(FAR)
    las = laspy.LasData(header)
    las.x, las.y, las.z = (POINTS + FAR).T
    path = tmp_path / f"tile{extension}"
    las.write(str(path))
    cloud = read_cloud(path)
    np.testing.assert_allclose(cloud.points, POINTS + FAR, rtol=0, atol=1e-9)
    assert cloud.num_dropped == 0
    path.write_bytes(path.read_bytes()[:-20])
    with pytest.raises(CloudFileError):
        read_cloud(path)


def _write_e57(path: Path) -> None:
    pye57 = pytest.importorskip("pye57")
    invalid = np.array([0, 1, 0], dtype=np.int8)
    with pye57.E57(str(path), mode="w") as file:
        for index in range(2):
            columns = {f"cartesian{axis}": POINTS[:, i] for i, axis in enumerate("XYZ")}
            if index == 1:
                columns["cartesianInvalidState"] = invalid
            half_turn_about_z = np.array([0.0, 0, 0, 1])
            file.write_scan_raw(
                columns,
                rotation=half_turn_about_z if index else np.array([1.0, 0, 0, 0]),
                translation=10.0 * index * np.ones(3),
            )


def test_the_scans_of_an_e57_file_come_in_its_frame_together_or_one_by_one(tmp_path: Path) -> None:
    _write_e57(tmp_path / "site.e57")
    turned = POINTS[[0, 2]] * [-1, -1, 1] + 10
    whole = read_cloud(tmp_path / "site.e57")
    np.testing.assert_allclose(whole.points, np.vstack([POINTS, turned]), atol=1e-6)
    assert whole.num_dropped == 1
    first, second = read_clouds(tmp_path / "site.e57")
    np.testing.assert_allclose(first.points, POINTS, atol=1e-6)
    np.testing.assert_allclose(second.points, turned, atol=1e-6)
    assert (first.num_dropped, second.num_dropped) == (0, 1)


def _point_cloud2(
    store: Any, points: npt.NDArray[np.float64], sec: int, *, is_ros1: bool, is_bigendian: bool
) -> Any:
    """Organised in one column whose rows are padded; x is a double, y and z are floats."""
    types = store.types
    row = np.dtype(
        {
            "names": ["intensity", "x", "y", "z"],
            "formats": ["u2", "f8", "f4", "f4"],
            "offsets": [0, 4, 12, 20],
            "itemsize": 28,
        }
    ).newbyteorder(">" if is_bigendian else "<")
    records = np.zeros(len(points), row)
    for i, axis in enumerate("xyz"):
        records[axis] = points[:, i]
    field = types["sensor_msgs/msg/PointField"]
    header = {"stamp": types["builtin_interfaces/msg/Time"](sec, 7), "frame_id": "lidar"}
    padded = [record.tobytes() + b"\xff" * 4 for record in records]
    return types["sensor_msgs/msg/PointCloud2"](
        header=types["std_msgs/msg/Header"](**header, **({"seq": 0} if is_ros1 else {})),
        height=len(points),
        width=1,
        fields=[
            field("intensity", 0, 4, 1),
            field("x", 4, 8, 1),
            field("y", 12, 7, 1),
            field("z", 20, 7, 1),
        ],
        is_bigendian=is_bigendian,
        point_step=28,
        row_step=32,
        data=np.frombuffer(b"".join(padded), np.uint8),
        is_dense=False,
    )


def _write_recording(folder: Path, kind: str, topics: tuple[str, ...]) -> Path:
    """Three messages a topic, the second without a point, the third with a NaN; gives its path."""
    pytest.importorskip("rosbags")
    from rosbags import rosbag1, rosbag2
    from rosbags.typesys import Stores, get_typestore

    is_ros1 = kind == ".bag"
    store = get_typestore(Stores.ROS1_NOETIC if is_ros1 else Stores.ROS2_HUMBLE)
    name = "sensor_msgs/msg/PointCloud2"
    if is_ros1:
        writer: Any = rosbag1.Writer(folder / "drive.bag")
    else:
        plugin = rosbag2.StoragePlugin
        storage = plugin.SQLITE3 if kind == ".db3" else plugin.MCAP
        writer = rosbag2.Writer(folder / "drive", version=9, storage_plugin=storage)
    serialize = store.serialize_ros1 if is_ros1 else store.serialize_cdr
    with writer:
        for topic in topics:
            connection = writer.add_connection(topic, name, typestore=store)
            with_nan = POINTS + 1
            with_nan[0, 1] = np.nan
            for sec, points in enumerate([POINTS, POINTS[:0], with_nan]):
                message = _point_cloud2(store, points, sec, is_ros1=is_ros1, is_bigendian=sec == 2)
                writer.write(connection, sec * 1_000_000_000, serialize(message, name))
    return folder / ("drive.bag" if is_ros1 else "drive")


@pytest.mark.parametrize("kind", [".bag", ".mcap", ".db3", "folder"])
def test_recordings_give_the_clouds_of_a_topic_in_order(tmp_path: Path, kind: str) -> None:
    path = _write_recording(tmp_path, kind, ("/points",))
    if kind in (".mcap", ".db3"):
        (path,) = path.glob(f"*{kind}")
    first, third = read_clouds(path)
    assert isinstance(first, StampedCloud)
    assert isinstance(third, StampedCloud)
    assert (first.topic, first.frame) == ("/points", "lidar")
    assert (first.time_ns, third.time_ns) == (7, 2_000_000_007)
    assert np.array_equal(first.points, POINTS)
    assert np.array_equal(third.points, POINTS[1:] + 1)
    assert (first.num_dropped, third.num_dropped) == (0, 1)
    assert np.array_equal(read_cloud(path).points, first.points)
    assert np.array_equal(read_points(path, topic="/points", index=1), third.points)
    with pytest.raises(ValueError, match=r"index: .* has no 3 clouds"):
        read_cloud(path, index=2)


def test_a_recording_of_several_topics_needs_the_choice(tmp_path: Path) -> None:
    path = _write_recording(tmp_path, ".bag", ("/front", "/rear"))
    with pytest.raises(ValueError, match="choose one of /front, /rear"):
        read_cloud(path)
    with pytest.raises(ValueError, match=r"'/roof' is not among those of .*: /front, /rear"):
        next(read_clouds(path, topic="/roof"))
    clouds = list(read_clouds(path, topic="/rear"))
    assert {cloud.topic for cloud in clouds if isinstance(cloud, StampedCloud)} == {"/rear"}
    assert len(clouds) == 2


def test_a_recording_without_clouds_is_an_error(tmp_path: Path) -> None:
    path = _write_recording(tmp_path, ".bag", ())
    with pytest.raises(CloudFileError, match="no topic of type sensor_msgs/msg/PointCloud2"):
        read_cloud(path)


def test_compressed_pcd_of_open3d_is_read(tmp_path: Path) -> None:
    open3d = pytest.importorskip("open3d")
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(POINTS))
    open3d.io.write_point_cloud(str(tmp_path / "a.pcd"), cloud, compressed=True)
    assert b"binary_compressed" in (tmp_path / "a.pcd").read_bytes()
    assert np.array_equal(read_points(tmp_path / "a.pcd"), POINTS)
