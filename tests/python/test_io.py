"""Files of clouds that need no other library."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest
from gmcr.io import CloudFileError, read_cloud, read_clouds, read_points, write_points

POINTS = np.array([[0.1, -2, 3e6], [1 / 3, 0, 1e-300], [-7, 8.5, 9]])


@pytest.mark.parametrize("extension", [".ply", ".npy", ".xyz", ".csv", ".PLY"])
def test_what_is_written_reads_back_as_the_same_bits(tmp_path: Path, extension: str) -> None:
    path = tmp_path / f"cloud{extension}"
    write_points(path, POINTS)
    cloud = read_cloud(path)
    assert np.array_equal(cloud.points, POINTS)
    assert cloud.points.dtype == np.float64
    assert cloud.points.flags.c_contiguous
    assert cloud.num_dropped == 0


@pytest.mark.parametrize("extension", [".ply", ".npy", ".xyz", ".csv"])
def test_points_that_are_not_finite_are_dropped_and_counted(tmp_path: Path, extension: str) -> None:
    path = tmp_path / f"cloud{extension}"
    write_points(path, [[1, 2, 3], [np.nan, 0, 0], [4, 5, 6], [0, np.inf, 0]])
    cloud = read_cloud(str(path))
    assert cloud.points.tolist() == [[1, 2, 3], [4, 5, 6]]
    assert cloud.num_dropped == 2


@pytest.mark.parametrize("extension", [".ply", ".npy", ".xyz", ".csv"])
def test_a_file_without_a_finite_point_is_an_error(tmp_path: Path, extension: str) -> None:
    for name, points in (("empty", np.empty((0, 3))), ("nan", np.full((2, 3), np.nan))):
        path = tmp_path / f"{name}{extension}"
        write_points(path, points)
        reason = "no finite point|file is empty"
        with pytest.raises(CloudFileError, match=f"{name}{extension}: ({reason})"):
            read_points(path)


@pytest.mark.parametrize(
    "extension", ["ply", "pcd", "npy", "xyz", "pts", "csv", "pcd.bin", "las", "e57", "mcap", "obj"]
)
def test_a_missing_file_is_an_os_error_that_names_it(tmp_path: Path, extension: str) -> None:
    with pytest.raises((OSError, ImportError), match="absent") as caught:
        read_cloud(tmp_path / f"absent.{extension}")
    assert not isinstance(caught.value, CloudFileError)


def test_unknown_extensions_are_value_errors(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"cloud\.docx has none of the extensions"):
        read_cloud(tmp_path / "cloud.docx")
    with pytest.raises(ValueError, match=r"cloud\.las does not end in"):
        write_points(tmp_path / "cloud.las", POINTS)
    with pytest.raises(ValueError, match="shape"):
        write_points(tmp_path / "cloud.ply", POINTS[:, :2])


def test_topic_and_index_are_for_recordings_only(tmp_path: Path) -> None:
    write_points(tmp_path / "cloud.ply", POINTS)
    with pytest.raises(ValueError, match="for recordings"):
        read_cloud(tmp_path / "cloud.ply", topic="/points")
    with pytest.raises(ValueError, match="for recordings"):
        read_cloud(tmp_path / "cloud.ply", index=1)
    with pytest.raises(ValueError, match="for recordings"):
        read_clouds(tmp_path / "cloud.ply", topic="/points")
    with pytest.raises(ValueError, match="-1 is negative"):
        read_cloud(tmp_path / "cloud.ply", index=-1)


def test_the_clouds_of_a_plain_file_are_one(tmp_path: Path) -> None:
    write_points(tmp_path / "cloud.ply", POINTS)
    (cloud,) = read_clouds(tmp_path / "cloud.ply")
    assert np.array_equal(cloud.points, POINTS)


PLY_HEADER = """ply
format {format} 1.0
comment made by a test
obj_info none
element camera 2
property float view
element vertex 3
property uchar red
property float x
property double y
property short z
element face 1
property list uchar int vertex_indices
end_header
"""


def _ply_body(byte_order: str) -> bytes:
    views = struct.pack(f"{byte_order}2f", 5, 6)
    vertices = b"".join(
        struct.pack(f"{byte_order}Bfdh", 200, *row) for row in ((1, 2, 3), (4, 5, 6), (7, 8, -9))
    )
    return views + vertices + struct.pack(f"{byte_order}B3i", 3, 0, 1, 2)


@pytest.mark.parametrize(
    ("name", "body"),
    [
        ("binary_little_endian", _ply_body("<")),
        ("binary_big_endian", _ply_body(">")),
        ("ascii", b"5\n6\n200 1 2 3\n200 4 5 6\n200 7 8 -9\n3 0 1 2\n"),
    ],
)
def test_ply_with_further_elements_and_mixed_types_gives_its_vertices(
    tmp_path: Path, name: str, body: bytes
) -> None:
    path = tmp_path / "mesh.ply"
    path.write_bytes(PLY_HEADER.format(format=name).encode() + body)
    assert read_points(path, mesh_points=0).tolist() == [[1, 2, 3], [4, 5, 6], [7, 8, -9]]
    path.write_bytes(path.read_bytes()[: -len(body) + 24])
    with pytest.raises(CloudFileError, match="truncated"):
        read_points(path)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("plough\n", "not a PLY file"),
        ("ply\nformat ascii 1.0\nelement vertex 1\n", "no end_header"),
        ("ply\nelement vertex 0\nend_header\n", "no format line"),
        ("ply\nformat ascii 1.0\nelement face 0\nend_header\n", "no vertices"),
        ("ply\nformat ascii 1.0\nelement vertex many\nend_header\n", "element vertex many"),
        ("ply\nformat ascii 1.0\nproperty float x\nend_header\n", "property float x"),
        (
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
            "x, y and z",
        ),
        ("ply\nformat ascii 1.0\nelement vertex -1\nend_header\n1\n", "element vertex -1"),
        (
            "ply\nformat binary_little_endian 1.0\nelement vertex 9999999999999\nproperty float x\n"
            "property float y\nproperty float z\nend_header\n",
            "truncated: fewer than 9999999999999 points",
        ),
    ],
)
def test_malformed_ply_files_are_errors_with_the_reason(
    tmp_path: Path, text: str, reason: str
) -> None:
    (tmp_path / "bad.ply").write_text(text)
    with pytest.raises(CloudFileError, match=reason):
        read_points(tmp_path / "bad.ply")


PCD_HEADER = """# .PCD v0.7
VERSION 0.7
FIELDS normal x y z
SIZE 4 8 4 4
TYPE F F F I
COUNT 3 1 1 1
WIDTH 2
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS 2
DATA {encoding}
"""


@pytest.mark.parametrize(
    ("encoding", "body"),
    [
        ("ascii", b"0 0 1 1.5 2 3\n0 0 1 nan 5 6\n"),
        ("binary", struct.pack("<3fdfi3fdfi", 0, 0, 1, 1.5, 2, 3, 0, 0, 1, np.nan, 5, 6)),
    ],
)
def test_pcd_with_fields_of_several_values_gives_its_points(
    tmp_path: Path, encoding: str, body: bytes
) -> None:
    path = tmp_path / "cloud.pcd"
    path.write_bytes(PCD_HEADER.format(encoding=encoding).encode() + body)
    cloud = read_cloud(path)
    assert cloud.points.tolist() == [[1.5, 2, 3]]
    assert cloud.num_dropped == 1
    path.write_bytes(path.read_bytes()[: -len(body) // 2])
    with pytest.raises(CloudFileError, match=r"truncated|expected"):
        read_cloud(path)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("VERSION 0.7\n", "no DATA line"),
        ("FIELDS a\nSIZE 4\nTYPE F\nPOINTS 0\nDATA binary\n", "no x, y and z"),
        ("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 0\nDATA zipped\n", "zipped"),
        ("FIELDS x y z\nSIZE 4 4 4\nTYPE F F Q\nPOINTS 0\nDATA binary\n", "Q"),
        ("FIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 0\nDATA binary\n", "SIZE of 2 for 3 fields"),
    ],
)
def test_malformed_pcd_files_are_errors_with_the_reason(
    tmp_path: Path, text: str, reason: str
) -> None:
    (tmp_path / "bad.pcd").write_text(text)
    with pytest.raises(CloudFileError, match=reason):
        read_points(tmp_path / "bad.pcd")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.xyz", "# a comment\n1 2 3 255\n4 5 6 0\n"),
        ("a.txt", "\ufeff1\t2\t3\n4\t5\t6"),
        ("a.pts", "2\n1 2 3 9\n4 5 6 9\n"),
        ("a.csv", "1,2,3\n4,5,6\n"),
        ("a.csv", "label; Z; Y; X\na; 3; 2; 1\n\nb; 6; 5; 4\n"),
    ],
)
def test_text_files_of_the_usual_layouts_are_read(tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text, encoding="utf-8")
    assert read_points(tmp_path / name).tolist() == [[1, 2, 3], [4, 5, 6]]


@pytest.mark.parametrize(
    ("name", "text", "reason"),
    [
        ("a.xyz", "1 2 3\n4 5\n", "a.xyz"),
        ("a.xyz", "1 2 three\n", "three"),
        ("a.pts", "3\n1 2 3\n", "1 points, the first line says 3"),
        ("a.csv", "1,2,3,4\n", "4 columns"),
    ],
)
def test_malformed_text_files_are_errors_with_the_reason(
    tmp_path: Path, name: str, text: str, reason: str
) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(CloudFileError, match=reason):
        read_points(tmp_path / name)


@pytest.mark.parametrize(("name", "num_columns"), [("a.bin", 4), ("a.pcd.bin", 5)])
def test_lidar_rows_of_float32_give_their_first_three(
    tmp_path: Path, name: str, num_columns: int
) -> None:
    rows = np.arange(3 * num_columns, dtype="<f4").reshape(3, num_columns)
    rows.tofile(tmp_path / name)
    assert np.array_equal(read_points(tmp_path / name), rows[:, :3])
    (tmp_path / name).write_bytes(rows.tobytes()[:-4])
    with pytest.raises(CloudFileError, match="truncated"):
        read_points(tmp_path / name)


@pytest.mark.parametrize(
    ("array", "reason"),
    [
        (np.zeros((4, 2)), r"shape \(4, 2\), expected \(N, 3\)"),
        (np.array([["a", "b", "c"]]), "not an array of numbers"),
        (np.array([[None] * 3]), "not an array of numbers"),
    ],
)
def test_npy_files_of_other_arrays_are_errors(
    tmp_path: Path, array: npt.NDArray[np.generic], reason: str
) -> None:
    np.save(tmp_path / "a.npy", array)
    with pytest.raises(CloudFileError, match=reason):
        read_points(tmp_path / "a.npy")


OFF = "OFF\n3 1 0\n0.25 -2 3\n1 0 0.5\n-7 8.5 9\n3 0 1 2\n"


def test_meshes_are_sampled_on_their_surface_or_give_their_vertices(tmp_path: Path) -> None:
    (tmp_path / "a.off").write_text(OFF)
    vertices = [[0.25, -2, 3], [1, 0, 0.5], [-7, 8.5, 9]]
    assert read_points(tmp_path / "a.off", mesh_points=0).tolist() == vertices
    cloud = read_cloud(tmp_path / "a.off", mesh_points=500)
    assert cloud.points.shape == (500, 3)
    assert "500 points are spread over its surface" in cloud.notes[0]
    a, b, c = np.array(vertices)
    assert np.allclose((cloud.points - a) @ np.cross(b - a, c - a), 0)
    assert read_points(tmp_path / "a.off").shape == (100_000, 3)
    with pytest.raises(ValueError, match="mesh_points: -1"):
        read_points(tmp_path / "a.off", mesh_points=-1)


def test_the_layout_of_a_scan_can_be_said(tmp_path: Path) -> None:
    rows = np.arange(36, dtype="<f4").reshape(12, 3)
    rows.tofile(tmp_path / "a.bin")
    cloud = read_cloud(tmp_path / "a.bin")
    assert cloud.points.shape == (9, 3)
    assert "fits 3 or 4 or 6 float32 a point" in cloud.notes[0]
    assert np.array_equal(read_points(tmp_path / "a.bin", bin_columns=3), rows)


def test_what_is_written_is_whole_or_absent(tmp_path: Path) -> None:
    (tmp_path / "a.ply").write_text("old")
    with pytest.raises(CloudFileError, match=r"nowhere.*No such file"):
        write_points(tmp_path / "nowhere" / "a.ply", POINTS)
    write_points(tmp_path / "a.ply", POINTS)
    assert np.array_equal(read_points(tmp_path / "a.ply"), POINTS)
    assert [path.name for path in tmp_path.iterdir()] == ["a.ply"]
