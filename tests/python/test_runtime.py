"""Threads, signals, and the same bits as the tool."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import threading
import time

import gmcr
import numpy as np
import pytest

PREAMBLE = """
import signal
import gmcr
import numpy as np
signal.signal(signal.SIGINT, signal.default_int_handler)  # background jobs of a shell ignore it
"""
SEARCHES = {
    "many short searches": """
problem = gmcr.make_synthetic(num_correspondences=6000, outlier_rate=0.995, seed=1,
                              scale_range=(1, 3))
def search():
    gmcr.register_correspondences(problem.source, problem.target, noise_mode="estimated",
                                  scale_mode="estimated", time_limit=60)
""",
    "one long certificate": """
problem = gmcr.make_synthetic(kind="structured", num_correspondences=90, outlier_rate=0.95, seed=2)
def search():
    gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.07,
                                  scale_mode="estimated", certify=True, time_limit=60)
""",
    "a hard graph": """
upper = np.triu(np.random.default_rng(1).random((600, 600)) < 0.9, 1)
def search():
    gmcr.max_clique(upper | upper.T)
""",
    "a hard graph with weights": """
upper = np.triu(np.random.default_rng(1).random((600, 600)) < 0.9, 1)
weights = np.random.default_rng(2).random(600)
def search():
    gmcr.max_weight_clique(upper | upper.T, weights)
""",
}
UNTIL_INTERRUPTED = """
print("ready", flush=True)
try:
    while True:
        search()
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_other_threads_run_during_a_solve():
    problem = gmcr.make_synthetic(num_correspondences=4000, outlier_rate=0.97, seed=1)
    ticks, done = [0], threading.Event()

    def count():
        while not done.is_set():
            ticks[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = ticks[0]
    started = time.perf_counter()
    while time.perf_counter() - started < 0.3:
        gmcr.register_correspondences(
            problem.source, problem.target, noise_bound=0.01, num_threads=1
        )
    during = ticks[0] - before
    done.set()
    thread.join()
    assert during > 10


def test_two_threads_get_the_results_of_one(problem):
    expected = gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.01)
    results = []

    def solve():
        for _ in range(5):
            results.append(
                gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.01)
            )

    threads = [threading.Thread(target=solve) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 10
    assert all(np.array_equal(result.matrix(), expected.matrix()) for result in results)


@pytest.mark.parametrize("search", SEARCHES)
def test_ctrl_c_stops(search):
    program = PREAMBLE + SEARCHES[search] + UNTIL_INTERRUPTED
    process = subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        assert process.stdout.readline() == "ready\n"
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=10)
    finally:
        process.kill()
    assert out == "interrupted\n", err
    assert process.returncode == 0


def test_the_tool_gives_the_same_bits(problem, tool, tmp_path):
    path = tmp_path / "matches.npy"
    np.save(path, np.hstack([problem.source, problem.target]))
    for flags, keywords in (
        ([], {}),
        (["--estimate-scale"], {"scale_mode": "estimated"}),
        (["--method", "paper"], {"method": "paper"}),
        (["--evidence", "count"], {"evidence": "count"}),
    ):
        command = [tool, "solve", path, "--noise-bound", "0.01", "--json", *flags]
        fields = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        result = gmcr.register_correspondences(
            problem.source, problem.target, noise_bound=0.01, **keywords
        )
        assert fields["target_from_source"] == result.matrix().tolist()
        assert fields["inliers"] == result.inliers.tolist()
        assert fields["certificate"]["upper"] == result.certificate.upper
        assert fields["covariance"]["matrix"] == result.covariance.matrix.tolist()


def test_the_defaults_are_those_of_the_tool(tool):
    info = json.loads(subprocess.run([tool, "info", "--json"], capture_output=True).stdout)
    defaults = info["defaults"]
    assert info["version"] == gmcr.__version__
    assert info["isa"] == gmcr.instruction_set() == gmcr.instruction_sets()[0]
    assert info["threads"] == gmcr.hardware_threads()
    for kind in (gmcr.Options, gmcr.FrontendOptions, gmcr.InstanceOptions):
        for name, value in kind().__getstate__().items():
            if defaults.get(name) is not None:  # those that are infinite or not given are null
                assert np.array_equal(value, defaults[name]), name
    assert {"scale", "time_limit", "memory_limit", "max_ratio", "min_instance_share"} <= set(
        defaults
    )
