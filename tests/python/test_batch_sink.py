"""The folder of the results."""

import dataclasses
import json

import pytest
from gmcr.batch import Row, SinkError, read_results
from gmcr.batch.sink import Sink

FULL = Row(
    id="full",
    status="ok",
    reason="because",
    target_from_source=[float(k) for k in range(16)],
    scale=1.5,
    num_correspondences=10,
    num_inliers=7,
    max_inliers=8,
    certified=False,
    evidence=6.5,
    noise_bound=0.1,
    verdict="trusted",
    verdict_reason="many",
    fitness=0.75,
    limits_hit=["time"],
    inliers=[1, 2],
    seconds=0.25,
    cpu_seconds=0.1875,
    read_seconds=0.125,
    attempts=2,
)
EMPTY = Row(id="empty", status="error")


@pytest.fixture(params=["jsonl", "parquet"])
def kind(request):
    if request.param == "parquet":
        pytest.importorskip("pyarrow")
    return request.param


def rows_in(folder):
    return sorted(read_results(folder), key=lambda row: row.id)


def test_rows_come_back_as_they_were(tmp_path, kind):
    assert None not in dataclasses.asdict(FULL).values()
    with Sink(tmp_path, kind, {}) as sink:
        sink.write([FULL, EMPTY])
        sink.write([])
    assert rows_in(tmp_path) == [EMPTY, FULL]


def test_the_folder_is_a_data_set(tmp_path):
    dataset = pytest.importorskip("pyarrow.dataset")
    for id in ("a", "b"):
        with Sink(tmp_path, "parquet", {}) as sink:
            sink.write([Row(id, "ok")])
    assert dataset.dataset(tmp_path).to_table()["id"].to_pylist() == ["a", "b"]


def test_numbers_that_are_not_finite_are_null_in_json(tmp_path):
    with Sink(tmp_path, "jsonl", {}) as sink:
        sink.write([Row("a", "ok", fitness=float("nan"), target_from_source=[float("inf")] * 16)])
    (part,) = tmp_path.glob("part-*")
    row = json.loads(part.read_text(), parse_constant=pytest.fail)
    assert row["fitness"] is None and row["target_from_source"] == [None] * 16


def test_a_part_is_written_when_it_is_full_or_old(tmp_path, kind):
    with Sink(tmp_path, kind, {}, part_rows=3, part_seconds=1e9) as sink:
        for k in range(7):
            sink.write([Row(f"{k}", "ok")])
        assert len(list(read_results(tmp_path))) == 6
    assert len(list(read_results(tmp_path))) == 7
    with Sink(tmp_path, kind, {}, part_seconds=0) as sink:
        sink.write([Row("7", "ok")])
        assert len(list(read_results(tmp_path))) == 8


def test_what_a_killed_run_left_half_written_does_not_count(tmp_path, kind):
    with Sink(tmp_path, kind, {}) as sink:
        sink.write([Row("a", "ok")])
    torn = tmp_path / f".part-000001.{kind}.tmp"
    torn.write_bytes(b'{"id": "b", "sta')
    with Sink(tmp_path, kind, {}) as sink:
        assert sink.statuses() == {"a": "ok"}
        sink.write([Row("b", "ok")])
    assert [row.id for row in rows_in(tmp_path)] == ["a", "b"]
    assert not torn.exists()


def test_another_setup_is_refused_until_a_restart(tmp_path, kind):
    with Sink(tmp_path, kind, {"options": {"noise_bound": 1}}) as sink:
        sink.write([EMPTY])
    with pytest.raises(SinkError, match=r"options was \{'noise_bound': 1\}, is \{\}"):
        Sink(tmp_path, kind, {"options": {}})
    with Sink(tmp_path, kind, {"options": {}}, restart=True) as sink:
        assert sink.statuses() == {}
    assert rows_in(tmp_path) == []


def test_another_format_is_another_setup(tmp_path):
    pytest.importorskip("pyarrow")
    with Sink(tmp_path, "jsonl", {}) as sink:
        sink.write([EMPTY])
    with pytest.raises(SinkError, match="format was 'jsonl', is 'parquet'"):
        Sink(tmp_path, "parquet", {})
    with Sink(tmp_path, "parquet", {}, restart=True):
        assert rows_in(tmp_path) == []


def test_two_runs_cannot_write_to_one_folder(tmp_path):
    with Sink(tmp_path, "jsonl", {}), pytest.raises(SinkError, match="another run writes to it"):
        Sink(tmp_path, "jsonl", {})
    with Sink(tmp_path, "jsonl", {}):
        pass


def test_error_rows_can_be_dropped(tmp_path, kind):
    with Sink(tmp_path, kind, {}) as sink:
        sink.write([FULL, EMPTY])
        sink.flush()
        assert sink.drop_errors() == 1
        assert sink.statuses().keys() == {"full"}
    assert rows_in(tmp_path) == [FULL]


def test_an_unknown_format_is_refused(tmp_path):
    with pytest.raises(ValueError, match="format: 'csv' is none of parquet, jsonl"):
        Sink(tmp_path, "csv", {})
