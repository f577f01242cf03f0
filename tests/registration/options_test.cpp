#include "gmcr/options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "problems.hpp"

namespace gmcr::registration {
namespace {

TEST(RegisterCorrespondences, RefusesInputThatBreaksTheContract) {
  const auto problem = testing::random_problem(1, 10, 0);
  const Options options = problem.options();
  const auto message = [&](const Points& source, const Points& target, const Options& o) {
    try {
      register_correspondences(source, target, o);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message(problem.source, problem.target.leftCols(9), options),
            "target: 9 points, but source has 10");
  Points broken = problem.source;
  broken(1, 4) = std::nan("");
  EXPECT_EQ(message(broken, problem.target, options), "source: point 4 is not finite");
  broken = problem.target;
  broken(0, 2) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(problem.source, broken, options), "target: point 2 is not finite");
  Options per_point = options;
  per_point.noise_bound = 0;
  per_point.noise_bounds = {0.1, 0.2};
  EXPECT_EQ(message(problem.source, problem.target, per_point),
            "noise_bounds: 2 values for 10 correspondences");
  Options small = options;
  small.memory_limit = 10;
  EXPECT_EQ(message(problem.source, problem.target, small).rfind("memory_limit:", 0), 0u);
}

}  // namespace
}  // namespace gmcr::registration
