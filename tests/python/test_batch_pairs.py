"""The list of pairs, the files of matches, and the options."""

import json

import numpy as np
import pytest
from gmcr.batch import OPTION_NAMES, Pair, PairsError, read_matches, read_pairs
from gmcr.batch.options import check_options, frontend_options, solver_options
from gmcr.batch.pairs import count_pairs

ROWS = [
    {"id": "a", "matches": "a.npy", "noise_bound": 0.05, "scale_range": [0.5, 2]},
    {"id": "b", "source": "s.ply", "target": "t.ply", "certify": True},
    {"id": "3", "matches": "/data/c.csv", "scale_mode": "estimated"},
]


def as_csv(path):
    path.write_text(
        "id,matches,source,target,noise_bound,scale_range,certify,scale_mode\n"
        'a,a.npy,,,0.05,"[0.5, 2]",,\n'
        "\n"
        "b,,s.ply,t.ply,,,true,\n"
        "3,/data/c.csv,,,,,,estimated\n"
    )


def as_jsonl(path):
    path.write_text("".join(json.dumps(row) + "\n" for row in ROWS))


def as_parquet(path):
    pa = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    names = sorted({name for row in ROWS for name in row})
    full = [{name: row.get(name) for name in names} for row in ROWS]
    parquet.write_table(pa.Table.from_pylist(full), path)


@pytest.mark.parametrize("write", [as_csv, as_jsonl, as_parquet])
def test_every_format_gives_the_same_pairs(tmp_path, write):
    path = tmp_path / f"pairs.{write.__name__[3:]}"
    write(path)
    assert list(read_pairs(path)) == [
        Pair(
            "a",
            matches=str(tmp_path / "a.npy"),
            options={"noise_bound": 0.05, "scale_range": [0.5, 2]},
        ),
        Pair(
            "b",
            source=str(tmp_path / "s.ply"),
            target=str(tmp_path / "t.ply"),
            options={"certify": True},
        ),
        Pair("3", matches="/data/c.csv", options={"scale_mode": "estimated"}),
    ]
    assert count_pairs(path) == 3


def test_pairs_are_read_one_at_a_time(tmp_path):
    path = tmp_path / "pairs.jsonl"
    path.write_text('{"id": "a", "matches": "a.npy"}\nbroken\n')
    pairs = read_pairs(path)
    assert next(pairs).id == "a"
    with pytest.raises(PairsError, match=r"pairs.jsonl:2: no JSON"):
        next(pairs)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("id,matches\na,a.npy\nb\n", r":3: 1 cells"),
        ("id,matches\n,a.npy\n", r":2: id: is missing"),
        (
            "id,matches,nois_bound\na,a.npy,1\n",
            r":2: unknown column 'nois_bound'; did you mean 'noise_bound'",
        ),
        (
            "id,matches,num_threads\na,a.npy,1\n",
            r":2: unknown column 'num_threads'; one thread works on each pair, --workers",
        ),
        ("id,match\na,a.npy\n", r":2: unknown column 'match'; did you mean 'matches'\?"),
        ("id,matches,noise\na,a.npy,1\n", r":2: unknown column 'noise'; write noise_bound="),
        ("id,matches,voxel_size\na,m.npy,1\n", r":2: voxel_size: is for clouds"),
        ("id,source\na,a.ply\n", r":2: expected matches, or source and target"),
        ("id,source,target,matches\na,s,t,m\n", r":2: expected matches, or source and target"),
        ("id,matches\na,x.npy\nb,x.npy\na,y.npy\n", r"pair 3 has the id 'a' of pair 1"),
    ],
)
def test_a_malformed_list_is_refused_with_its_line(tmp_path, text, message):
    path = tmp_path / "pairs.csv"
    path.write_text(text)
    with pytest.raises(PairsError, match=message):
        count_pairs(path)


def test_an_unknown_format_is_refused(tmp_path):
    with pytest.raises(PairsError, match=r"expected a file of \.csv, \.jsonl, \.parquet"):
        count_pairs(tmp_path / "pairs.txt")


TABLE = np.arange(1.0, 15.0).reshape(2, 7)


@pytest.mark.parametrize(
    ("header", "columns"),
    [
        (None, range(7)),
        ("ax,ay,az,bx,by,bz,noise_bound", range(7)),
        ("beta,ax,ay,az,bx,by,bz", [1, 2, 3, 4, 5, 6, 0]),
        ("sx,sy,sz,tx,ty,tz,gt_residual", range(6)),
        ("tx,ty,tz,sx,sy,sz,gt_residual", [3, 4, 5, 0, 1, 2]),
    ],
)
def test_matches_come_from_the_columns_that_the_header_names(tmp_path, header, columns):
    path = tmp_path / "matches.csv"
    np.savetxt(path, TABLE, delimiter=",", header=header or "", comments="")
    if header is None:
        path.write_text(path.read_text().lstrip("\n"))
    source, target, bounds = read_matches(path)
    expected = TABLE[:, list(columns)]
    np.testing.assert_array_equal(source, expected[:, :3])
    np.testing.assert_array_equal(target, expected[:, 3:6])
    if expected.shape[1] == 7:
        np.testing.assert_array_equal(bounds, expected[:, 6])
    else:
        assert bounds is None


def test_matches_come_from_npy(tmp_path):
    np.save(tmp_path / "m.npy", TABLE[:, :6].astype(np.float32))
    source, target, bounds = read_matches(tmp_path / "m.npy")
    np.testing.assert_array_equal(source, TABLE[:, :3])
    np.testing.assert_array_equal(target, TABLE[:, 3:6])
    assert bounds is None and source.dtype == np.float64


@pytest.mark.parametrize("shape", [(4, 5), (6,), (4, 8)])
def test_matches_of_another_shape_are_refused(tmp_path, shape):
    np.save(tmp_path / "m.npy", np.zeros(shape))
    with pytest.raises(OSError, match=r"expected \(N, 6\) or \(N, 7\)"):
        read_matches(tmp_path / "m.npy")


def test_options_reach_the_solver_and_the_front_end():
    values = {"noise_bound": 0.1, "scale_range": [0.5, 2], "scale_mode": "estimated"}
    solver = solver_options({**values, "voxel_size": 0.3})
    assert (solver.noise_bound, solver.scale_range, solver.num_threads) == (0.1, (0.5, 2), 1)
    assert frontend_options({**values, "voxel_size": 0.3}).voxel_size == 0.3


def test_every_option_can_be_set():
    assert {"noise_bound", "time_limit", "voxel_size", "max_attempts"} <= OPTION_NAMES
    assert not {"num_threads", "progress", "validate", "noise_bounds"} & OPTION_NAMES


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"noise": 1}, "unknown name 'noise'"),
        ({"noise_bound": -1}, "noise_bound"),
        ({"noise_bound": "much"}, "options"),
        ({"voxel_size": -1}, "voxel_size"),
    ],
)
def test_options_that_no_pair_could_use_are_refused(values, message):
    with pytest.raises(ValueError, match=message):
        check_options(values)


def test_a_noise_bound_may_be_left_to_the_pairs():
    check_options({})
