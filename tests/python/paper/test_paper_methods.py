"""Each method solves an easy problem, or says why it cannot run here."""

import os
import signal
import time

import numpy as np
import pytest
from paper import worker
from paper.methods import METHODS
from paper.methods.registry import Method, Outcome, register
from paper.problem import Pose, Problem, easy_problem, errors_of, fit_similarity


@pytest.mark.parametrize("is_scale_known", [True, False], ids=["known", "estimated"])
@pytest.mark.parametrize("name", METHODS)
def test_a_method_solves_an_easy_problem(name, is_scale_known):
    method_type = METHODS[name]
    reason = method_type.unavailable_reason()
    if reason is not None:
        pytest.skip(reason)
    if method_type.needs_known_scale and not is_scale_known:
        pytest.skip("needs a known scale")
    problem = easy_problem(is_scale_known)
    timed = worker.time_solves(method_type(), problem, 5.0)
    assert timed.outcome.status == "ok"
    assert errors_of(timed.outcome.pose, problem)["mean_point"] < 0.01


def test_an_absent_module_is_the_reason_that_a_method_gives():
    class Absent(METHODS["least-squares"]):
        modules = ("no_such_module",)

    assert "no_such_module" in Absent.unavailable_reason()


def test_a_name_is_registered_once():
    with pytest.raises(ValueError, match="gmcr"):
        register(METHODS["gmcr"])


class Slow(Method):
    name = "slow"

    def prepare(self, problem, time_limit):
        pass

    def solve(self):
        time.sleep(0.05)

    def outcome(self, result):
        return Outcome("ok", Pose(1.0, np.eye(3), np.zeros(3)))


def test_a_solve_beyond_the_limit_is_no_answer():
    assert worker.time_solves(Slow(), easy_problem(), 0.049).outcome.status == "time_limit"
    assert worker.time_solves(Slow(), easy_problem(), 1.0).outcome.status == "ok"


def test_a_worker_that_hangs_is_ended_and_starts_anew():
    rival = worker.Worker("least-squares")
    assert rival.unavailable_reason() is None
    try:
        first = rival._process
        os.kill(first.pid, signal.SIGSTOP)
        assert rival.solve(easy_problem(), -10.0).outcome.status == "time_limit"
        assert not first.is_alive()
        assert rival.solve(easy_problem(), 5.0).outcome.status == "ok"
    finally:
        rival.stop()


def test_least_squares_recovers_a_similarity_and_never_mirrors():
    random = np.random.default_rng(1)
    source = random.normal(size=(20, 3))
    truth = Pose(
        2.5, fit_similarity(random.normal(size=(9, 3)), source[:9], True).rotation, source[0]
    )
    fit = fit_similarity(source, truth.apply(source), is_scale_known=False)
    problem = Problem(source, source, truth, 0.1, False, source)
    assert max(errors_of(fit, problem).values()) < 1e-6
    mirrored = fit_similarity(source, source * [1, 1, -1], is_scale_known=True)
    assert np.linalg.det(mirrored.rotation) == pytest.approx(1)
