"""Order, retries and back-pressure, with workers that are no processes."""

import itertools

import pytest
from gmcr.batch import Pair, Row
from gmcr.batch.schedule import Lost, schedule


class FakeBackend:
    """Two workers; those that get a pair of ``deadly`` die."""

    def __init__(self, deadly=(), seconds=0.1):
        self.deadly = set(deadly)
        self.seconds = seconds
        self.running = []
        self.chunks = []

    def num_free(self):
        return 2 - len(self.running)

    def num_running(self):
        return len(self.running)

    def submit(self, chunk):
        self.chunks.append([pair.id for pair in chunk.pairs])
        self.running.append(chunk)

    def wait(self, seconds):
        chunk = self.running.pop(0)
        if self.deadly & {pair.id for pair in chunk.pairs}:
            return [(chunk, Lost("the worker died"))]
        rows = [Row(p.id, "ok", seconds=self.seconds, attempts=chunk.attempt) for p in chunk.pairs]
        return [(chunk, rows)]

    def close(self):
        pass


def ids(count):
    return [f"p{k}" for k in range(count)]


def rows_of(backend, count, **options):
    pairs = (Pair(id, matches="m.npy") for id in ids(count))
    return list(itertools.chain.from_iterable(schedule(pairs, backend, **options)))


@pytest.mark.parametrize("chunk_pairs", [0, 1, 3, 100])
@pytest.mark.parametrize("retries", [0, 2])
def test_every_pair_has_one_row_and_only_the_deadly_ones_are_errors(chunk_pairs, retries):
    backend = FakeBackend(deadly={"p0", "p7", "p8"})
    rows = rows_of(backend, 20, retries=retries, chunk_pairs=chunk_pairs)
    assert sorted(row.id for row in rows) == sorted(ids(20))
    assert {row.id for row in rows if row.status == "error"} == backend.deadly
    assert {row.reason for row in rows if row.status == "error"} == {"the worker died"}


def test_a_deadly_pair_is_started_once_more_than_the_retries():
    backend = FakeBackend(deadly={"p1"})
    (row,) = (r for r in rows_of(backend, 3, retries=2, chunk_pairs=1) if r.status == "error")
    assert row.attempts == 3
    assert backend.chunks.count(["p1"]) == 3


def test_the_others_of_a_lost_chunk_are_started_again_one_by_one():
    backend = FakeBackend(deadly={"p1"})
    rows = rows_of(backend, 3, retries=0, chunk_pairs=3)
    assert backend.chunks == [["p0", "p1", "p2"], ["p0"], ["p1"], ["p2"]]
    assert [row.status for row in sorted(rows, key=lambda row: row.id)] == ["ok", "error", "ok"]


def test_pairs_are_read_no_faster_than_they_are_worked_on():
    read = []

    def pairs():
        for id in ids(1000):
            read.append(id)
            yield Pair(id, matches="m.npy")

    backend = FakeBackend()
    rows = schedule(pairs(), backend, retries=0, chunk_pairs=5)
    next(rows)
    assert len(read) == 10
    next(rows)
    assert len(read) == 15


@pytest.mark.parametrize(("seconds", "expected"), [(0.1, 10), (5.0, 1), (0.0, 512)])
def test_automatic_chunks_grow_to_about_a_second(seconds, expected):
    backend = FakeBackend(seconds=seconds)
    rows_of(backend, 4000, retries=0, chunk_pairs=0)
    assert len(backend.chunks[0]) == 1
    assert max(len(chunk) for chunk in backend.chunks) == expected


def test_no_pairs_are_no_rows():
    assert rows_of(FakeBackend(), 0, retries=0) == []
