#include "gmcr/options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "problems.hpp"

namespace gmcr::registration {
namespace {

struct BadOption {
  const char* field;
  std::function<void(Options&)> spoil;
};

TEST(Options, NamesTheFieldThatIsOutOfRange) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const std::vector<BadOption> cases = {
      {"noise_bound", [](Options& o) { o.noise_bound = 0; }},
      {"noise_bound", [](Options& o) { o.noise_bound = -1; }},
      {"noise_bound", [&](Options& o) { o.noise_bound = nan; }},
      {"noise_bound", [&](Options& o) { o.noise_bound = inf; }},
      {"noise_bound", [](Options& o) { o.noise_bounds = {0.1}; }},
      {"noise_bounds[1]",
       [](Options& o) {
         o.noise_bound = 0;
         o.noise_bounds = {0.1, 0};
       }},
      {"threshold", [](Options& o) { o.threshold = 0; }},
      {"scale", [](Options& o) { o.scale = -2; }},
      {"scale",
       [](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale = 2;
       }},
      {"scale_range",
       [](Options& o) {
         o.scale_range = ScaleRange{1, 2};
       }},
      {"scale_range.min",
       [](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale_range = ScaleRange{0, 2};
       }},
      {"scale_range.min",
       [](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale_range = ScaleRange{3, 2};
       }},
      {"scale_range.max",
       [&](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale_range = ScaleRange{1, inf};
       }},
      {"num_hypotheses", [](Options& o) { o.num_hypotheses = 0; }},
      {"num_hypotheses", [](Options& o) { o.num_hypotheses = -3; }},
      {"num_hypotheses",
       [](Options& o) {
         o.method = Method::Paper;
         o.num_hypotheses = 2;
       }},
      {"certify",
       [](Options& o) {
         o.method = Method::Paper;
         o.certify = true;
       }},
      {"num_threads", [](Options& o) { o.num_threads = -1; }},
      {"budget.time", [](Options& o) { o.budget.time = 0; }},
      {"budget.time", [&](Options& o) { o.budget.time = nan; }},
      {"budget.memory", [](Options& o) { o.budget.memory = 0; }},
  };
  for (const auto& [field, spoil] : cases) {
    Options options;
    options.noise_bound = 0.1;
    EXPECT_NO_THROW(options.validate());
    spoil(options);
    try {
      options.validate();
      FAIL() << field;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(std::string(field) + ":", 0), 0u) << error.what();
    }
  }
}

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
  small.budget.memory = 10;
  EXPECT_EQ(message(problem.source, problem.target, small).rfind("budget.memory:", 0), 0u);
}

}  // namespace
}  // namespace gmcr::registration
