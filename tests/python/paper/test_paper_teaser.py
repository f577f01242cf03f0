"""The program for TEASER++'s CMake package, built here against a stand-in of its interface."""

import contextlib
import multiprocessing
import os
import shutil
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from paper import worker
from paper.methods import teaser
from paper.problem import easy_problem, errors_of

HEADER = """
#pragma once
#include <Eigen/Dense>
#include <chrono>
#include <iostream>
#include <thread>
namespace teaser {
struct RegistrationSolution {
  bool valid = true;
  double scale = 1;
  Eigen::Vector3d translation;
  Eigen::Matrix3d rotation;
};
class RobustRegistrationSolver {
 public:
  enum class ROTATION_ESTIMATION_ALGORITHM { GNC_TLS = 0 };
  struct Params {
    double noise_bound = 0.01, cbar2 = 1, rotation_gnc_factor = 1.4, rotation_cost_threshold = 1e-6;
    bool estimate_scaling = true;
    ROTATION_ESTIMATION_ALGORITHM rotation_estimation_algorithm{};
    size_t rotation_max_iterations = 100;
  };
  explicit RobustRegistrationSolver(const Params& params) : params_(params) {}
  void solve(const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xd& target) {
    std::cout << "Max core number: 10" << std::endl;  // as its clique solver prints
    if (source.cols() == 7) std::this_thread::sleep_for(std::chrono::seconds(60));
    const Eigen::Matrix4d pose = Eigen::umeyama(source, target, params_.estimate_scaling);
    solution_.scale = std::cbrt(pose.topLeftCorner<3, 3>().determinant());
    solution_.rotation = pose.topLeftCorner<3, 3>() / solution_.scale;
    solution_.translation = pose.topRightCorner<3, 1>();
  }
  RegistrationSolution getSolution() { return solution_; }
 private:
  Params params_;
  RegistrationSolution solution_;
};
}
"""
CONFIG = """
set(teaserpp_VERSION 1.2.3)
add_library(teaserpp::teaser_registration INTERFACE IMPORTED)
target_include_directories(teaserpp::teaser_registration INTERFACE ${CMAKE_CURRENT_LIST_DIR})
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    if shutil.which("cmake") is None:
        pytest.skip("needs cmake")
    folder = tmp_path_factory.mktemp("teaser")
    (folder / "stub" / "teaser").mkdir(parents=True)
    (folder / "stub" / "teaser" / "registration.h").write_text(HEADER)
    (folder / "stub" / "teaserppConfig.cmake").write_text(CONFIG)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("teaserpp_DIR", str(folder / "stub"))
        built = teaser.built_program(folder / "build")
    assert not isinstance(built, str), built
    return built


@pytest.mark.parametrize("is_scale_known", [True, False], ids=["known", "estimated"])
def test_the_program_gets_the_problem_and_answers_each_solve(program, is_scale_known, monkeypatch):
    monkeypatch.setattr(teaser, "built_program", lambda: program)
    monkeypatch.setattr(teaser, "find_spec", lambda name: None)
    problem = easy_problem(is_scale_known)
    inliers = problem.is_inlier
    exact = type(problem)(
        problem.truth.inverse().apply(problem.target[inliers]),
        problem.target[inliers],
        *(problem.truth, problem.noise_bound, is_scale_known, problem.model),
    )
    timed = worker.time_solves(teaser.Teaser(), exact, 5.0)
    assert timed.outcome.status == "ok"
    assert errors_of(timed.outcome.pose, exact)["mean_point"] < 1e-9


def processes_of(program):
    running = set()
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):  # has just ended
            if path.read_bytes().split(b"\0")[0] == os.fsencode(program):
                running.add(path)
    return running


def in_worker(program, connection, problem):
    teaser.built_program = lambda: program
    teaser.find_spec = lambda name: None
    connection.send("ready")
    worker.time_solves(teaser.Teaser(), problem, 60.0)


def test_the_program_ends_with_the_process_that_asked_it(program):
    easy = easy_problem(True)
    problem = replace(easy, source=easy.source[:7], target=easy.target[:7])  # on which it sleeps
    idle = processes_of(program)  # of tests before
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe()
    process = context.Process(target=in_worker, args=(program, theirs, problem))
    process.start()
    assert ours.recv() == "ready"
    waited = time.monotonic() + 10
    while processes_of(program) == idle and time.monotonic() < waited:
        time.sleep(0.02)
    assert len(processes_of(program) - idle) == 1
    process.kill()
    process.join()
    waited = time.monotonic() + 10
    while processes_of(program) - idle and time.monotonic() < waited:
        time.sleep(0.02)
    assert not processes_of(program) - idle


def test_the_version_is_that_of_the_package(program, monkeypatch):
    monkeypatch.setattr(teaser, "built_program", lambda: program)
    monkeypatch.setattr(teaser, "find_spec", lambda name: None)
    assert teaser.Teaser.version() == "1.2.3"


def test_of_coincident_sources_the_first_is_kept():
    easy = easy_problem(True)
    source = easy.source.copy()
    source[5] = source[2]
    kept, left_out = teaser.without_coincident_sources(replace(easy, source=source))
    assert left_out == 1
    assert np.array_equal(kept.source, np.delete(source, 5, axis=0))
    assert np.array_equal(kept.target, np.delete(easy.target, 5, axis=0))
    assert teaser.without_coincident_sources(easy) == (easy, 0)


def test_without_module_and_package_the_reason_names_both(monkeypatch, tmp_path):
    monkeypatch.setattr(teaser, "find_spec", lambda name: None)
    monkeypatch.setenv("CMAKE_PREFIX_PATH", str(tmp_path))
    reason = teaser.built_program(tmp_path / "build")
    if not isinstance(reason, str):
        pytest.skip("teaserpp is installed")
    monkeypatch.setattr(teaser, "built_program", lambda: reason)
    text = teaser.Teaser.unavailable_reason()
    assert teaser.MODULE in text and "CMake package teaserpp" in text
