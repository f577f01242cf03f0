"""Point clouds in recordings of ROS 1 and ROS 2 and in MCAP files, by rosbags."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from ._cloud import StampedCloud, file_error, finite_rows, import_extra, reading_with
from ._fields import coordinates_dtype, coordinates_of

_CLOUD_TYPE = "sensor_msgs/msg/PointCloud2"
# PointField.datatype
_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}


def is_recording(path: Path) -> bool:
    """Whether this is a recording: a file by its name, a folder by its metadata."""
    return path.suffix.lower() in (".bag", ".mcap", ".db3") or (path / "metadata.yaml").is_file()


def read_recording(path: Path, topic: str | None) -> Iterator[StampedCloud]:
    """The clouds of one topic in the order of recording, without those that have no finite point.

    Raises
    ------
    ValueError
        where the topic is not there, or is not given though there are several.
    """
    highlevel = import_extra("rosbags.highlevel", "rosbag", path)
    typesys = import_extra("rosbags.typesys", "rosbag", path)
    with reading_with("rosbags", path):
        # the store is for recordings that do not define their messages
        store = typesys.get_typestore(typesys.Stores.LATEST)
        reader = highlevel.AnyReader([path], default_typestore=store)
        reader.open()
    with closing(reader):
        for name, message in _messages(path, reader, topic):
            points = _decode(path, message)
            kept = finite_rows(points)
            if len(kept):
                stamp = message.header.stamp
                time_ns = int(stamp.sec) * 1_000_000_000 + int(stamp.nanosec)
                yield StampedCloud(
                    kept, len(points) - len(kept), name, message.header.frame_id, time_ns
                )


def _messages(path: Path, reader: Any, topic: str | None) -> Iterator[tuple[str, Any]]:
    clouds = [each for each in reader.connections if each.msgtype == _CLOUD_TYPE]
    topics = sorted({each.topic for each in clouds})
    if not topics:
        raise file_error(path, f"no topic of type {_CLOUD_TYPE}")
    if topic is None and len(topics) > 1:
        raise ValueError(f"topic: {path} has several, choose one of {', '.join(topics)}")
    if topic is not None and topic not in topics:
        raise ValueError(f"topic: {topic!r} is not among those of {path}: {', '.join(topics)}")
    chosen = [each for each in clouds if each.topic == (topic or topics[0])]
    with reading_with("rosbags", path):
        for connection, _, data in reader.messages(chosen):
            yield connection.topic, reader.deserialize(data, connection.msgtype)


def _decode(path: Path, message: Any) -> npt.NDArray[np.float64]:
    """Coordinates of a PointCloud2, whose rows may be padded, (height * width, 3)."""
    byte_order = ">" if message.is_bigendian else "<"
    try:
        fields = {
            each.name: (byte_order + _TYPES[each.datatype], each.offset) for each in message.fields
        }
        records = np.ndarray(
            (message.height, message.width),
            coordinates_dtype(fields, message.point_step),
            np.ascontiguousarray(message.data),
            strides=(message.row_step, message.point_step),
        )
    except (KeyError, ValueError, TypeError) as error:
        raise file_error(path, f"bad PointCloud2: {error}") from error
    return coordinates_of(records)
