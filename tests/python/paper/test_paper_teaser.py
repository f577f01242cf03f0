"""The program for TEASER++'s CMake package, built here against a stand-in of its interface."""

import shutil

import pytest
from paper import worker
from paper.methods import teaser
from paper.problem import easy_problem, errors_of

HEADER = """
#pragma once
#include <Eigen/Dense>
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


def test_without_module_and_package_the_reason_names_both(monkeypatch, tmp_path):
    monkeypatch.setattr(teaser, "find_spec", lambda name: None)
    monkeypatch.setenv("CMAKE_PREFIX_PATH", str(tmp_path))
    reason = teaser.built_program(tmp_path / "build")
    if not isinstance(reason, str):
        pytest.skip("teaserpp is installed")
    monkeypatch.setattr(teaser, "built_program", lambda: reason)
    text = teaser.Teaser.unavailable_reason()
    assert teaser.MODULE in text and "CMake package teaserpp" in text
