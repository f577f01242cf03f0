"""Runs on a Ray cluster of several nodes, of which some die. Every pair exactly once."""

import socket
import subprocess
import sys
from pathlib import Path

import batch_support
import pytest
from batch_support import by_id, repeatable, write_pairs
from gmcr import batch

ray = pytest.importorskip("ray")
pytest.importorskip("pyarrow")

OPTIONS = {"noise_bound": 0.05}


@pytest.fixture(scope="module")
def cluster():
    """A head without cores, which survives, and two nodes of one core."""
    from ray.cluster_utils import Cluster

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(Path(batch_support.__file__).parent), prepend=":")
        nodes = Cluster(
            initialize_head=True,
            head_node_args={
                "num_cpus": 0,
                "include_dashboard": False,
                "_system_config": {"health_check_period_ms": 500},
            },
        )
        for _ in range(2):
            nodes.add_node(num_cpus=1, object_store_memory=80 * 2**20)
        ray.init(address=nodes.address, log_to_driver=False)
        yield nodes
        ray.shutdown()
        nodes.shutdown()


def run(pairs, out, cluster, **settings):
    settings = {"options": OPTIONS, "address": cluster.address, **settings}
    return batch.run(pairs, out, **settings)


def rows_by_id(out):
    rows = list(batch.read_results(out))
    assert len({row.id for row in rows}) == len(rows)
    return {row.id: row for row in rows}


def test_the_rows_of_the_cluster_are_those_of_this_machine(tmp_path, cluster):
    pairs = write_pairs(tmp_path, [f"p{k}" for k in range(30)])
    summary = run(pairs, tmp_path / "ray", cluster, keep_inliers=True)
    batch.run(pairs, tmp_path / "here", options=OPTIONS, keep_inliers=True, num_workers=1)
    assert summary.statuses == {"ok": 30}
    here = rows_by_id(tmp_path / "here")
    for id, row in rows_by_id(tmp_path / "ray").items():
        assert repeatable(row) == repeatable(here[id])


def test_poisoned_pairs_are_error_rows_and_killed_workers_cost_only_time(tmp_path, cluster):
    ids = ["exit-0", "kill-1", *(f"p-{k}" for k in range(10))]
    pairs = write_pairs(tmp_path, ids)
    with pairs.open("a") as file:
        file.write("missing,nowhere.npy\n")
    summary = run(pairs, tmp_path / "out", cluster, register=by_id, chunk_pairs=3, retries=1)
    assert summary.statuses == {"ok": 11, "error": 2}
    rows = rows_by_id(tmp_path / "out")
    assert rows.keys() == {*ids, "missing"}
    assert rows["exit-0"].reason.startswith("the worker died")
    assert rows["exit-0"].attempts == 3  # with its chunk, and alone twice
    assert rows["kill-1"].status == "ok"


def test_a_node_that_dies_loses_no_pair_and_a_second_call_repeats_none(tmp_path, cluster):
    ids = [f"p-{k}" for k in range(24)]
    ids[8] = "node-8"
    pairs = write_pairs(tmp_path, ids)
    summary = run(pairs, tmp_path / "out", cluster, register=by_id, chunk_pairs=2)
    assert summary.statuses == {"ok": 24}
    rows = rows_by_id(tmp_path / "out")
    assert rows.keys() == set(ids)
    assert rows["node-8"].attempts == 2
    again = run(pairs, tmp_path / "out", cluster, register=by_id)
    assert (again.num_skipped, again.statuses) == (24, {})


def run_tool(pairs, out, address):
    command = [sys.executable, "-m", "gmcr.batch", str(pairs), "--out", str(out)]
    return subprocess.run(
        [*command, "--noise-bound", "0.05", "--address", address],
        capture_output=True,
        text=True,
        timeout=100,
    )


def test_the_tool_connects_to_a_cluster_by_its_address(tmp_path, cluster):
    pairs = write_pairs(tmp_path, [f"p{k}" for k in range(5)])
    done = run_tool(pairs, tmp_path / "out", cluster.address)
    assert done.returncode == 0, done.stderr
    assert rows_by_id(tmp_path / "out").keys() == {f"p{k}" for k in range(5)}


@pytest.mark.parametrize("protocol", ["", "ray://"])
def test_an_address_where_nothing_listens_is_a_clear_error_at_once(tmp_path, protocol):
    pairs = write_pairs(tmp_path, ["p"])
    with socket.socket() as unused:
        unused.bind(("127.0.0.1", 0))  # not listening: connections are refused
        address = f"{protocol}127.0.0.1:{unused.getsockname()[1]}"
        done = run_tool(pairs, tmp_path / "out", address)
    assert done.returncode == 3
    assert done.stderr == f"gmcr.batch: Ray cluster {address}: Connection refused\n"


def test_an_address_of_no_known_form_is_a_usage_error(tmp_path):
    done = run_tool(write_pairs(tmp_path, ["p"]), tmp_path / "out", "nonsense")
    assert done.returncode == 2
    assert "nonsense" in done.stderr
