// Solves one problem by TEASER++ as often as it is asked to.
//
// Reads from stdin: number of matches, noise bound, whether the scale is unknown (0 or 1), then six
// numbers a match. After that each further line asks for a solve and is answered by a line: valid
// (0 or 1), scale, rotation by rows, translation. With an argument it says the library's version.
#include <sys/prctl.h>
#include <teaser/registration.h>
#include <unistd.h>

#include <Eigen/Core>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

int main(int argc, char**) {
  if (argc > 1) return std::puts(TEASER_VERSION) < 0;
  // who asks may be ended for the time that a solve takes: that ends the solve too
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // the library prints to stdout: what it says goes where errors go, and stdout is for the answers
  std::FILE* answers = fdopen(dup(STDOUT_FILENO), "w");
  if (!answers || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  using Solver = teaser::RobustRegistrationSolver;
  Eigen::Index num_matches = 0;
  Solver::Params parameters;
  if (!(std::cin >> num_matches >> parameters.noise_bound >> parameters.estimate_scaling)) return 1;
  parameters.cbar2 = 1;
  parameters.rotation_estimation_algorithm = Solver::ROTATION_ESTIMATION_ALGORITHM::GNC_TLS;
  parameters.rotation_gnc_factor = 1.4;
  parameters.rotation_max_iterations = 100;
  parameters.rotation_cost_threshold = 1e-12;
  Eigen::Matrix<double, 3, Eigen::Dynamic> source(3, num_matches), target(3, num_matches);
  for (Eigen::Index i = 0; i < num_matches; ++i) {
    for (auto* points : {&source, &target}) {
      for (int axis = 0; axis < 3; ++axis) std::cin >> (*points)(axis, i);
    }
  }
  if (!std::cin) return 1;
  std::cin.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  const Eigen::IOFormat row(Eigen::FullPrecision, Eigen::DontAlignCols, " ", " ");
  for (std::string line; std::getline(std::cin, line);) {
    // a second solve of one solver would scale its noise bound again
    Solver solver(parameters);
    solver.solve(source, target);
    const auto solution = solver.getSolution();
    const Eigen::Matrix3d rotation = solution.rotation;
    const Eigen::Vector3d translation = solution.translation;
    std::ostringstream answer;
    answer.precision(17);
    answer << solution.valid << ' ' << solution.scale << ' ' << rotation.format(row) << ' '
           << translation.transpose().format(row) << '\n';
    std::fputs(answer.str().c_str(), answers);
    std::fflush(answers);
  }
}
