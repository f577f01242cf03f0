"""Summaries of runs: known values, and failures that count."""

import math

import pytest
from paper.statistics import (
    errors,
    mean_and_deviation,
    quantile,
    quartiles,
    success_rate,
    times_ms,
)
from reports.records import wilson


def run(success=True, wall_ms=1.0, error=0.1):
    pose_errors = None if error is None else {"mean_point": error}
    return {"success": success, "wall_ms": wall_ms, "errors": pose_errors}


def test_quartiles_of_one_to_five_are_two_three_four():
    summary = quartiles([5, 1, 4, 2, 3])
    assert (summary.low, summary.median, summary.high) == (2, 3, 4)


def test_a_quantile_between_two_values_is_interpolated():
    assert quantile([0.0, 10.0], 0.25) == pytest.approx(2.5)


def test_the_median_is_infinite_where_half_of_the_runs_failed():
    assert quantile([1.0, math.inf], 0.5) == math.inf
    assert quantile([1.0, 2.0, math.inf], 0.5) == 2.0
    assert quantile([math.inf, math.inf], 0.25) == math.inf


def test_a_quantile_of_nothing_is_not_a_number():
    assert math.isnan(quantile([], 0.5))


def test_the_wilson_interval_of_8_of_10_is_that_of_the_literature():
    rate = success_rate([run(k < 8) for k in range(10)])
    assert (rate.successes, rate.total, rate.share) == (8, 10, 0.8)
    assert rate.low == pytest.approx(0.4902, abs=1e-4)
    assert rate.high == pytest.approx(0.9433, abs=1e-4)


def test_runs_of_one_real_pair_count_as_one_trial_in_the_interval():
    records = [run(k % 3 < 2) | {"set": "gore", "pair": str(k // 3)} for k in range(30)]
    rate, alone = success_rate(records), success_rate([run(k < 2) for k in range(3)])
    assert (rate.successes, rate.total) == (20, 30)
    assert (rate.low, rate.high) == pytest.approx(wilson(20 / 3, 10))
    assert rate.low < success_rate([run(k < 20) for k in range(30)]).low
    assert alone.low < rate.low


def test_a_time_out_is_a_failure_with_infinite_time_and_error():
    records = [run(), run(success=False, wall_ms=None, error=None)]
    assert success_rate(records).share == 0.5
    assert times_ms(records) == [1.0, math.inf]
    assert errors(records, "mean_point") == [0.1, math.inf]


def test_mean_and_deviation_leave_out_runs_without_a_pose():
    mean, deviation = mean_and_deviation([1.0, 3.0, math.inf])
    assert (mean, deviation) == (2.0, 1.0)
    assert math.isnan(mean_and_deviation([math.inf])[0])
