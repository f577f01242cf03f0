"""Records survive a stop, and figures and tables come from them alone."""

import json

import pytest
from paper import runner as running
from paper.figures import FIGURES
from paper.figures.style import save
from paper.losses import losses
from paper.methods.registry import Outcome
from paper.problem import easy_problem
from paper.records import RecordFile, key_of, read_records
from paper.report import HEADING, write_report
from paper.scenarios import EXPERIMENTS, is_success
from paper.scenarios.registry import Case, Experiment
from paper.tables import TABLES
from paper.worker import Timed

METHODS = ["least-squares", "ransac10k"]
CRITERION = {"mean_point": 0.3}


def small_experiment(name="small"):
    def cases(quick):
        for seed in range(4):
            yield Case({"seed": seed}, easy_problem, CRITERION, tuple(METHODS))

    return Experiment(name, "Small", "", cases)


def test_a_stopped_run_goes_on_without_repeats_or_losses(tmp_path):
    experiment = small_experiment()
    with running.Runner(tmp_path, METHODS, 5.0) as runner:
        assert runner.run(experiment, quick=True, max_runs=3) == 3
        path = tmp_path / "small.jsonl"
        # Killed while it wrote: the torn line is dropped, its run is done again.
        path.write_text(path.read_text()[:-40])
        assert runner.run(experiment, quick=True) == 6
        assert runner.run(experiment, quick=True) == 0
    keys = [record["key"] for record in read_records(path)]
    expected = {key_of("small", {"seed": k}, m) for k in range(4) for m in METHODS}
    assert len(keys) == len(set(keys)) and set(keys) == expected


def test_a_record_tells_input_machine_versions_and_errors(tmp_path):
    with running.Runner(tmp_path, ["least-squares"], 5.0) as runner:
        runner.run(small_experiment(), quick=True, max_runs=1)
    (record,) = read_records(tmp_path / "small.jsonl")
    assert record["input_hash"] == easy_problem().input_hash()
    assert record["success"] and record["errors"]["mean_point"] < 1e-6
    assert record["num_true_inliers"] == 40 and record["inlier_share"] == 1
    for field in ("gmcr", "numpy", "cpu", "isa", "cores", "date", "seed", "wall_ms", "time_limit"):
        assert record[field] is not None


def test_a_method_that_is_not_there_is_skipped_with_its_reason(tmp_path, capsys):
    teaser = running.METHODS["teaser++"]
    reason = teaser.unavailable_reason()
    if reason is None:
        pytest.skip("TEASER++ is installed")
    with running.Runner(tmp_path, ["teaser++"], 5.0):
        pass
    assert f"skipped: teaser++: {reason}" in capsys.readouterr().err
    assert "teaserpp_python" in json.loads((tmp_path / running.SKIPPED).read_text())["teaser++"]


def test_a_time_out_is_recorded_as_a_failure():
    timed = Timed(Outcome("time_limit", reason="more than 1 s"))
    record = running.describe_result(timed, easy_problem(), CRITERION)
    assert record["success"] is False
    assert record["wall_ms"] is None and record["errors"] is None
    assert not is_success(None, CRITERION)


def test_record_files_keep_what_is_complete(tmp_path):
    path = tmp_path / "x.jsonl"
    path.write_text('{"key": "a"}\n{"key": "b"')
    records = RecordFile(path)
    assert records.keys == {"a"}
    records.append({"key": "c"})
    assert [record["key"] for record in read_records(path)] == ["a", "c"]


def made_up_records(experiment):
    """Records of two methods, one of which is always right and one never."""
    records = []
    fields = {
        "synthetic": {"num_correspondences": 40, "kind": "random"},
        "structured": {"kind": "structured"},
        "objects": {"set": "objects_ycb", "object": "mug", "setting": "fpfh"},
        "lidar": {"scan": "nuscenes"},
        "real": {"set": "gore", "pair": "bunny"},
        "noise": {"set": "gore", "pair": "bunny"},
        "scaling": {},
    }[experiment]
    for method, right in (("gmcr", False), ("ransac10k", True)):
        for seed in range(3):
            for rate, count, factor in ((0.5, 1000, 1.0), (0.9, 5000, 2.0)):
                error = {"rotation_deg": 1.0, "translation": 0.1, "mean_point": 0.1, "scale": 0.0}
                records.append(
                    {
                        "key": f"{method}{seed}{rate}",
                        "experiment": experiment,
                        "seed": seed,
                        "method": method,
                        "method_version": "1",
                        "outlier_rate": rate,
                        "num_correspondences": count,
                        "bound_factor": factor,
                        "input_hash": f"{seed}{rate}",
                        "status": "ok" if right else "time_limit",
                        "success": right,
                        "wall_ms": 2.0 if right else None,
                        "errors": error if right else None,
                        "criterion": CRITERION,
                        "certificate": None,
                        "num_true_inliers": 5,
                        "num_inliers": 9 if right else None,
                        "inlier_share": 1.0 if right else None,
                        "time_limit": 10.0,
                        "gmcr": "0.1.0",
                        "python": "3.11",
                        "cpu": "cpu",
                        "commit": "0123456789",
                        "isa": "AVX2",
                        "cores": 2,
                        "date": "2026-01-02T03:04:05+00:00",
                        **fields,
                    }
                )
    return records


@pytest.mark.parametrize("experiment", EXPERIMENTS)
def test_a_figure_is_drawn_from_records(experiment, tmp_path):
    path = tmp_path / "figure.png"
    save(FIGURES[experiment][1](made_up_records(experiment)), path)
    assert path.read_bytes().startswith(b"\x89PNG")
    assert 5_000 < path.stat().st_size < 150_000


@pytest.mark.parametrize("experiment", EXPERIMENTS)
def test_a_table_shows_successes_and_time_outs(experiment):
    text = TABLES[experiment](made_up_records(experiment))
    assert "100 (" in text or "3 of 3" in text
    assert "> 10,000" in text or experiment == "noise"


def test_losses_list_where_another_method_is_right_more_often():
    text = losses({"lidar": made_up_records("lidar")})
    assert "RANSAC10k | right more often | 100 against 0 | 2 against inf | 0.1 against none" in text
    assert losses({"lidar": [r for r in made_up_records("lidar") if r["method"] == "gmcr"]}) == ""


def test_a_rival_that_is_as_often_right_loses_only_by_time():
    records = made_up_records("lidar")
    right = [record for record in records if record["success"]]
    ours = [{**record, "method": "gmcr", "wall_ms": 5.0} for record in right]
    assert "faster | 100 against 100 | 2 against 5" in losses({"lidar": [*ours, *right]})
    counting = [{**record, "method": "gmcr-count"} for record in right]
    assert losses({"lidar": [*ours, *counting]}) == ""


def test_a_method_that_is_as_often_right_wins_by_a_fifth_of_the_error():
    right = [record for record in made_up_records("lidar") if record["success"]]
    ours = [{**record, "method": "gmcr"} for record in right]

    def counting(share):
        error = {**right[0]["errors"], "translation": share * 0.1}
        return [{**record, "method": "gmcr-count", "errors": error} for record in right]

    text = losses({"lidar": [*ours, *counting(0.7)]})
    assert "| more accurate | 100 against 100 | 2 against 2 | 0.07 against 0.1" in text
    assert losses({"lidar": [*ours, *counting(0.9)]}) == ""


def test_the_page_is_composed_from_a_folder_of_records(tmp_path):
    records = RecordFile(tmp_path / "lidar.jsonl")
    for record in made_up_records("lidar"):
        records.append(record)
    write_report(tmp_path, tmp_path / "page.md", tmp_path / "images")
    text = (tmp_path / "page.md").read_text()
    assert text.startswith(HEADING)
    assert "![" in text and "(images/experiment_lidar.png)" in text
    assert "2026-01-02" in text and "AVX2" in text and "0123456789" in text
    assert (tmp_path / "images" / "experiment_lidar.png").exists()
