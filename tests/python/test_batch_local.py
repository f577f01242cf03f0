"""Runs on this machine: poisoned pairs, dead workers, ended runs. Every pair exactly once."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import batch_support
import gmcr
import numpy as np
import pytest
from batch_support import by_id, count_rows, repeatable, starts, write_pairs
from gmcr import batch
from gmcr.batch.__main__ import main

pytest.importorskip("tqdm")
OPTIONS = {"noise_bound": 0.05}


def run(pairs, out, **settings):
    settings = {"options": OPTIONS, "format": "jsonl", "num_workers": 1, **settings}
    return batch.run(pairs, out, **settings)


def rows_by_id(out):
    rows = list(batch.read_results(out))
    assert len({row.id for row in rows}) == len(rows)
    return {row.id: row for row in rows}


def test_rows_are_those_of_the_direct_call(tmp_path):
    pairs = write_pairs(tmp_path, ["a", "b", "c"])
    summary = run(pairs, tmp_path / "out", keep_inliers=True)
    assert (summary.num_pairs, summary.num_skipped, summary.statuses) == (3, 0, {"ok": 3})
    rows = rows_by_id(tmp_path / "out")
    for k, id in enumerate("abc"):
        table = np.load(tmp_path / f"matches{k}.npy")
        result = gmcr.register_correspondences(table[:, :3], table[:, 3:], num_threads=2, **OPTIONS)
        row = rows[id]
        np.testing.assert_array_equal(np.reshape(row.target_from_source, (4, 4)), result.matrix())
        assert row.inliers == result.inliers.tolist() and len(row.inliers) == row.num_inliers
        assert row.max_inliers == result.certificate.upper
        assert row.certified == result.certificate.certified
        assert (row.evidence, row.scale) == (result.evidence, result.scale)
        assert (row.num_correspondences, row.noise_bound) == (60, 0.05)
        assert row.seconds >= row.read_seconds > 0 and row.cpu_seconds > 0


def test_inliers_are_written_only_where_they_are_asked_for(tmp_path):
    run(write_pairs(tmp_path, ["a"]), tmp_path / "out")
    assert rows_by_id(tmp_path / "out")["a"].inliers is None


def test_the_options_of_a_pair_come_before_those_of_the_run(tmp_path):
    write_pairs(tmp_path, ["a"])
    pairs = tmp_path / "own.csv"
    pairs.write_text(
        "id,matches,noise_bound,noise_mode\n"
        "own,matches0.npy,0.08,\nrun,matches0.npy,,\nauto,matches0.npy,,estimated\n"
    )
    run(pairs, tmp_path / "out")
    rows = rows_by_id(tmp_path / "out")
    assert (rows["own"].noise_bound, rows["run"].noise_bound) == (0.08, 0.05)
    assert rows["auto"].status == "error" or rows["auto"].noise_bound not in (0.05, 0.08)


def test_bounds_in_the_file_are_those_of_the_matches(tmp_path):
    problem = gmcr.make_synthetic(num_correspondences=50, outlier_rate=0.5, seed=3)
    bounds = np.full((50, 1), 0.05)
    np.save(tmp_path / "m.npy", np.hstack([problem.source, problem.target, bounds]))
    pairs = tmp_path / "pairs.csv"
    pairs.write_text("id,matches\na,m.npy\n")
    run(pairs, tmp_path / "out", options={})
    row = rows_by_id(tmp_path / "out")["a"]
    expected = gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.05)
    assert (row.status, row.noise_bound) == ("ok", None)
    assert row.num_inliers == len(expected.inliers)


def test_two_clouds_become_a_pose_and_a_verdict(tmp_path, monkeypatch):
    io = pytest.importorskip("gmcr.io")
    rng = np.random.default_rng(0)
    clouds = {"s.npy": rng.normal(size=(400, 3)), "t.npy": rng.normal(size=(400, 3))}
    monkeypatch.setattr(io, "read_points", lambda path: clouds[Path(path).name])
    pair = batch.Pair("a", source="s.npy", target="t.npy")
    row = batch.register_pair(pair, {"voxel_size": 0.2})
    result = gmcr.register_clouds(
        clouds["s.npy"], clouds["t.npy"], gmcr.FrontendOptions(voxel_size=0.2), num_threads=1
    )
    assert row.verdict == result.verdict and row.verdict_reason == result.verdict_reason
    assert row.fitness == result.fitness
    assert row.noise_bound == result.matches.noise_bound
    assert row.status == result.registration.status


def test_a_poisoned_pair_is_an_error_row_and_the_others_are_untouched(tmp_path):
    write_pairs(tmp_path, ["a"])
    np.save(tmp_path / "nan.npy", np.full((50, 6), np.nan))
    (tmp_path / "text.csv").write_text("these,are,no\nnumbers,at,all\n")
    pairs = tmp_path / "poisoned.csv"
    pairs.write_text(
        "id,matches,noise_bound\n"
        "nan,nan.npy,\nmissing,nowhere.npy,\ntext,text.csv,\nbound,matches0.npy,-1\n"
        "exit-1,matches0.npy,\ngood-1,matches0.npy,\ngood-2,matches0.npy,\n"
    )
    summary = run(pairs, tmp_path / "out", register=by_id, retries=1, chunk_pairs=7, num_workers=2)
    assert summary.statuses == {"ok": 2, "error": 5}
    rows = rows_by_id(tmp_path / "out")
    assert rows["nan"].reason.startswith("CloudFileError: ")
    assert rows["missing"].reason.startswith("FileNotFoundError: ")
    assert "nowhere.npy" in rows["missing"].reason
    assert rows["text"].reason.startswith("CloudFileError: ")
    assert "noise_bound" in rows["bound"].reason
    assert rows["exit-1"].reason == "the worker died (exit code 7)"
    assert rows["exit-1"].target_from_source is None
    assert rows["good-1"].status == rows["good-2"].status == "ok"


def test_a_killed_worker_costs_nothing_but_time(tmp_path):
    ids = [f"p-{k}" for k in range(20)]
    run(write_pairs(tmp_path, ids), tmp_path / "calm", register=by_id)
    ids[3], ids[11] = "kill-3", "kill-11"
    pairs = write_pairs(tmp_path, ids)
    summary = run(pairs, tmp_path / "out", register=by_id, chunk_pairs=4, num_workers=2)
    assert summary.statuses == {"ok": 20}
    rows, calm = rows_by_id(tmp_path / "out"), rows_by_id(tmp_path / "calm")
    assert {row.attempts for row in rows.values()} == {1, 2}
    assert rows["kill-3"].attempts == 2
    for k, id in enumerate(ids):
        calm[f"p-{k}"].id = id
        assert repeatable(rows[id]) == repeatable(calm[f"p-{k}"])


def test_a_fault_of_the_disk_is_tried_again(tmp_path):
    pairs = write_pairs(tmp_path, ["fault-1"])
    run(pairs, tmp_path / "out", register=by_id)
    assert rows_by_id(tmp_path / "out")["fault-1"].attempts == 2


def test_a_pair_that_takes_too_long_is_an_error_row(tmp_path):
    pairs = write_pairs(tmp_path, ["hang-1", "good-1"])
    summary = run(pairs, tmp_path / "out", register=by_id, pair_timeout=2.0)
    assert summary.statuses == {"error": 1, "ok": 1}
    assert "longer than 2 s" in rows_by_id(tmp_path / "out")["hang-1"].reason


def test_the_same_call_again_does_only_what_is_new(tmp_path):
    pairs = write_pairs(tmp_path, ["a", "b"])
    run(pairs, tmp_path / "out")
    before = rows_by_id(tmp_path / "out")
    assert run(pairs, tmp_path / "out").num_skipped == 2
    with pairs.open("a") as file:
        file.write("c,matches0.npy\n")
    summary = run(pairs, tmp_path / "out")
    assert (summary.num_skipped, summary.statuses) == (2, {"ok": 1})
    rows = rows_by_id(tmp_path / "out")
    assert rows.keys() == {"a", "b", "c"}
    assert all(rows[id] == row for id, row in before.items())


def test_other_options_are_refused(tmp_path):
    pairs = write_pairs(tmp_path, ["a"])
    run(pairs, tmp_path / "out")
    with pytest.raises(batch.SinkError, match="restart"):
        run(pairs, tmp_path / "out", options={"noise_bound": 0.06})
    with pytest.raises(batch.SinkError, match="register"):
        run(pairs, tmp_path / "out", register=count_rows)
    run(pairs, tmp_path / "out", options={"noise_bound": 0.06}, restart=True)
    assert rows_by_id(tmp_path / "out")["a"].noise_bound == 0.06


def test_error_rows_are_done_again_on_request(tmp_path):
    pairs = write_pairs(tmp_path, ["a", "b"])
    (tmp_path / "matches1.npy").rename(tmp_path / "away.npy")
    first = run(pairs, tmp_path / "out")
    assert first.statuses == {"ok": 1, "error": 1}
    assert first.num_errors == 1
    assert first.first_error.startswith("b: FileNotFoundError: ")
    (tmp_path / "away.npy").rename(tmp_path / "matches1.npy")
    again = run(pairs, tmp_path / "out")
    assert (again.statuses, again.num_errors, again.first_error) == ({}, 1, "")
    retried = run(pairs, tmp_path / "out", retry_errors=True)
    assert (retried.statuses, retried.num_errors) == ({"ok": 1}, 0)
    assert rows_by_id(tmp_path / "out")["b"].status == "ok"


@pytest.mark.parametrize(
    "settings",
    [{"num_workers": -1}, {"chunk_pairs": -1}, {"retries": -1}, {"pair_timeout": 0.0}],
)
def test_settings_out_of_range_are_refused(tmp_path, settings):
    (name,) = settings
    with pytest.raises(ValueError, match=name):
        run(write_pairs(tmp_path, ["a"]), tmp_path / "out", **settings)


def test_workers_and_a_cluster_are_one_too_many(tmp_path):
    with pytest.raises(ValueError, match="num_workers: 1 with an address"):
        run(write_pairs(tmp_path, ["a"]), tmp_path / "out", address="auto")


DRIVER = """
from batch_support import by_id
from gmcr import batch
batch.run({pairs!r}, {out!r}, options={options!r}, format={format!r}, num_workers=2,
          chunk_pairs=2, part_seconds=0.1, register=by_id)
"""


@pytest.mark.parametrize("format", ["jsonl", "parquet"])
def test_a_run_that_was_killed_goes_on_without_losing_or_repeating_a_pair(tmp_path, format):
    if format == "parquet":
        pytest.importorskip("pyarrow")
    ids = [f"slow-{k}" for k in range(60)]
    pairs, out = write_pairs(tmp_path, ids), tmp_path / "out"
    script = DRIVER.format(pairs=str(pairs), out=str(out), options=OPTIONS, format=format)
    driver = start([sys.executable, "-c", script])
    wait_for(lambda: len(list(out.glob("part-*"))) >= 2)
    driver.kill()
    driver.wait()
    done = rows_by_id(out).keys()
    assert 0 < len(done) < len(ids)
    summary = run(pairs, out, format=format, register=by_id, part_seconds=0.1)
    assert summary.num_skipped == len(done)
    assert rows_by_id(out).keys() == set(ids)
    started = starts(tmp_path)
    assert all(started.count(id) == 1 for id in done)


def test_a_script_whose_workers_cannot_start_is_told_so_and_has_no_error_rows(tmp_path):
    pairs, script = write_pairs(tmp_path, ["a"]), tmp_path / "no_guard.py"
    places = f"{str(pairs)!r}, {str(tmp_path / 'out')!r}"
    call = f"batch.run({places}, format='jsonl', options={OPTIONS!r})"
    script.write_text(f"from gmcr import batch\n{call}\n")
    driver = start([sys.executable, str(script)])
    _, errors = driver.communicate(timeout=30)
    assert driver.returncode == 1
    assert "the first worker ended before it could work (exit code 1)" in errors
    assert rows_by_id(tmp_path / "out") == {}


def test_an_interrupted_command_keeps_its_rows_and_says_how_to_go_on(tmp_path):
    pairs, out = tmp_path / "pairs.csv", tmp_path / "out"
    write_pairs(tmp_path, [f"p{k}" for k in range(20_000)])
    command = [*COMMAND, str(pairs), "--out", str(out), "--format", "jsonl", "--workers", "1"]
    driver = start([*command, "--noise-bound", "0.05", "--part-seconds", "0.1", "--quiet"])
    wait_for(lambda: any(out.glob("part-*")))
    driver.send_signal(signal.SIGINT)
    _, errors = driver.communicate(timeout=20)
    assert driver.returncode == 130
    assert "run the same command again to go on" in errors
    assert 0 < len(rows_by_id(out)) < 20_000


COMMAND = [sys.executable, "-m", "gmcr.batch"]


def test_the_command_says_what_it_did(tmp_path, capsys):
    pairs, out = write_pairs(tmp_path, ["a", "b"]), tmp_path / "out"
    arguments = [str(pairs), "--out", str(out), "--format", "jsonl", "--workers", "1"]
    assert main([*arguments, "--noise-bound", "0.05", "--set", "num_hypotheses=2"]) == 0
    error = capsys.readouterr().err
    assert "2 of 2 pairs" in error and "2 ok" in error and "100%" in error
    assert main([*arguments, "--noise-bound", "0.06", "--quiet"]) == 2
    assert "restart" in capsys.readouterr().err
    assert main([*arguments, "--noise-bound", "auto", "--estimate-scale", "--restart"]) == 0
    (tmp_path / "matches0.npy").unlink()
    assert main([*arguments, "--restart", "--noise-bound", "0.05"]) == 1
    error = capsys.readouterr().err
    assert "1 error" in error and "first error: a: FileNotFoundError" in error
    assert main([*arguments, "--noise-bound", "0.05"]) == 1  # the row is an error still
    assert "error rows of earlier runs: 1; --retry-errors" in capsys.readouterr().err


@pytest.mark.parametrize("suffix", [".npy", ".csv"])
def test_a_list_of_which_every_pair_lacks_a_bound_fails_at_once(tmp_path, capsys, suffix):
    problem = gmcr.make_synthetic(num_correspondences=50, outlier_rate=0.5, seed=3)
    matches = np.hstack([problem.source, problem.target])
    bounded = np.hstack([matches, np.full((50, 1), 0.05)])
    for name, table in (("plain", matches), ("bounded", bounded)):
        if suffix == ".npy":
            np.save(tmp_path / f"{name}.npy", table)
        else:
            np.savetxt(tmp_path / f"{name}.csv", table, delimiter=",")
    pairs, out = tmp_path / "pairs.csv", tmp_path / "out"
    pairs.write_text(f"id,matches\na,plain{suffix}\nb,plain{suffix}\n")
    assert main([str(pairs), "--out", str(out)]) == 2
    error = capsys.readouterr().err
    assert "noise_bound: is missing, so that each of the 2 pairs would fail" in error
    assert not out.exists()
    # one pair that may succeed is enough, by its file or by an option of its own
    pairs.write_text(f"id,matches\na,plain{suffix}\nb,bounded{suffix}\n")
    summary = run(pairs, out, options={})
    assert summary.statuses == {"error": 1, "ok": 1}
    assert summary.first_error.startswith("a: ValueError: noise_bound: ")
    pairs.write_text(f"id,matches,noise_bound\na,plain{suffix},\nb,plain{suffix},auto\n")
    assert run(pairs, tmp_path / "own", options={}).statuses == {"error": 1, "ok": 1}


@pytest.mark.parametrize(
    ("arguments", "code", "message"),
    [
        (["--noise-bound", "-1"], 2, "noise_bound"),
        (["--set", "noise_bound"], 2, "NAME=VALUE"),
        (["--set", "nonsense=1"], 2, "nonsense"),
        (["--set", "num_thread=1"], 2, "did you mean 'num_threads'? But one thread works on each"),
        (["--set", "initial_pose=1"], 2, "priors on the pose are for single registrations"),
        (["--set", "max_attempt=1"], 2, "did you mean 'max_attempts'?"),
        (["--set", "budget=1"], 2, "write time_limit=10, seconds"),
        (["--set", "memory_limit=4GB"], 2, "write memory_limit=4000000000"),
    ],
)
def test_bad_usage_is_one_line(tmp_path, capsys, arguments, code, message):
    pairs = write_pairs(tmp_path, ["a"])
    assert main([str(pairs), "--out", str(tmp_path / "out"), *arguments]) == code
    error = capsys.readouterr().err
    assert message in error and error.count("\n") == 1


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--noise_bound", "0.05"], "unrecognized argument --noise_bound; did you mean --noise-bo"),
        (["--voxel_size=0.05"], "unrecognized argument --voxel_size; did you mean --voxel-size?"),
        (["--num-hypotheses", "2"], "--num-hypotheses; write --set num_hypotheses=VALUE"),
        (["--num-threads", "2"], "--num-threads; one thread works on each pair, --workers"),
        (["--frobnicate"], "unrecognized argument --frobnicate\n"),
    ],
)
def test_an_unknown_flag_is_answered_with_what_to_write(tmp_path, capsys, arguments, message):
    pairs = write_pairs(tmp_path, ["a"])
    with pytest.raises(SystemExit) as ended:
        main([*arguments, str(pairs), "--out", str(tmp_path / "out")])
    assert ended.value.code == 2
    assert message in capsys.readouterr().err


def test_a_missing_list_is_an_error_of_the_file(tmp_path, capsys):
    assert main([str(tmp_path / "pairs.csv"), "--out", str(tmp_path / "out")]) == 3
    assert "pairs.csv" in capsys.readouterr().err


def start(command):
    folder = str(Path(batch_support.__file__).parent)
    path = os.pathsep.join([folder, *filter(None, [os.environ.get("PYTHONPATH")])])
    environment = {**os.environ, "PYTHONPATH": path}
    return subprocess.Popen(
        command,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        # background jobs of a shell ignore it, and so would what they start
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def wait_for(condition, seconds=30):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.02)
