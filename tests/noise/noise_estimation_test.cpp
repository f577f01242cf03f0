#include "noise/noise_estimation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "data_folder.hpp"
#include "gmcr/metrics.hpp"
#include "gmcr/synthetic.hpp"
#include "noise/unknown_noise.hpp"
#include "problems.hpp"

namespace gmcr::noise {
namespace {

constexpr double kNoise = 0.01;

using testing::unknown_noise;
using testing::unknown_noise_and_scale;

SyntheticProblem ball_problem(double outlier_rate, NoiseShape shape, bool scaled) {
  SyntheticOptions options;
  options.num_correspondences = 300;
  options.outlier_rate = outlier_rate;
  options.seed = 11;
  options.noise_shape = shape;
  options.noise_extent = options.noise_bound = kNoise;
  if (scaled) options.scale_range = {0.5, 3};
  return make_synthetic(options);
}

void expect_found(const SyntheticProblem& problem, const Options& options,
                  double lowest = kNoise / 2) {
  const Result result = register_correspondences(problem.source, problem.target, options);
  ASSERT_EQ(result.status, Status::Ok) << result.status_reason;
  ASSERT_TRUE(result.noise_estimate);
  const NoiseEstimate& noise = *result.noise_estimate;
  EXPECT_GT(noise.noise_bound, lowest);
  EXPECT_LT(noise.noise_bound, kNoise * 2);
  EXPECT_LT(noise.log10_false_alarms, -10);
  EXPECT_LE(noise.stable_min, noise.noise_bound);
  EXPECT_GE(noise.stable_max, noise.noise_bound);
  EXPECT_LT(mean_point_error(result.target_from_source, problem.target_from_source, problem.source),
            kNoise);
}

TEST(NoiseEstimation, FindsTheRadiusOfNoiseInABall) {
  for (const double outlier_rate : {0.5, 0.8, 0.9}) {
    expect_found(ball_problem(outlier_rate, NoiseShape::Ball, false), unknown_noise());
  }
}

TEST(NoiseEstimation, FindsGaussianNoise) {
  // its root mean square is 0.58 of its extent, known to a fifth from 30 inliers
  const double lowest = 0.45 * kNoise;
  for (const double outlier_rate : {0.5, 0.8, 0.9}) {
    expect_found(ball_problem(outlier_rate, NoiseShape::Gaussian, false), unknown_noise(), lowest);
  }
}

TEST(NoiseEstimation, WorksWithUnknownScale) {
  for (const double outlier_rate : {0.5, 0.8, 0.9}) {
    expect_found(ball_problem(outlier_rate, NoiseShape::Ball, true), unknown_noise_and_scale());
  }
}

TEST(NoiseEstimation, UsesTheBoundForTheSolve) {
  const auto problem = ball_problem(0.8, NoiseShape::Ball, false);
  const Result estimated =
      register_correspondences(problem.source, problem.target, unknown_noise());
  Options given;
  given.noise_bound = estimated.noise_estimate->noise_bound;
  const Result same = register_correspondences(problem.source, problem.target, given);
  EXPECT_EQ(estimated.inliers, same.inliers);
  EXPECT_EQ(estimated.target_from_source.matrix(), same.target_from_source.matrix());
  ASSERT_FALSE(estimated.diagnostics.stages.empty());
  EXPECT_EQ(estimated.diagnostics.stages.front().name, "noise_bound");
  EXPECT_GE(estimated.diagnostics.total_seconds, estimated.diagnostics.stages.front().seconds);
  EXPECT_FALSE(same.noise_estimate);
}

TEST(NoiseEstimation, FollowsTheUnitOfLength) {
  const auto problem = ball_problem(0.8, NoiseShape::Ball, false);
  const Result metres = register_correspondences(problem.source, problem.target, unknown_noise());
  for (const double unit : {1024.0, 1000.0, 1e-3}) {
    const Result other =
        register_correspondences(unit * problem.source, unit * problem.target, unknown_noise());
    EXPECT_EQ(other.inliers, metres.inliers);
    EXPECT_NEAR(other.noise_estimate->noise_bound / unit / metres.noise_estimate->noise_bound, 1,
                1e-9);
    EXPECT_NEAR(other.noise_estimate->stable_max / unit / metres.noise_estimate->stable_max, 1,
                1e-9);
  }
}

TEST(NoiseEstimation, DoesNotSeeTheOrigin) {
  auto problem = ball_problem(0.8, NoiseShape::Ball, false);
  const Result near = register_correspondences(problem.source, problem.target, unknown_noise());
  problem.source.colwise() += Eigen::Vector3d(1e6, 2e6, -1e6);
  problem.target.colwise() -= Eigen::Vector3d(1e6, 2e6, -1e6);
  const Result far = register_correspondences(problem.source, problem.target, unknown_noise());
  EXPECT_EQ(far.inliers, near.inliers);
  EXPECT_NEAR(far.noise_estimate->noise_bound, near.noise_estimate->noise_bound, 1e-6);
}

TEST(NoiseEstimation, IsTheSameForAnyNumberOfThreads) {
  const auto problem = ball_problem(0.8, NoiseShape::Ball, false);
  Options options = unknown_noise();
  options.num_threads = 1;
  const Result one = register_correspondences(problem.source, problem.target, options);
  options.num_threads = 3;
  const Result three = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(one.noise_estimate->noise_bound, three.noise_estimate->noise_bound);
  EXPECT_EQ(one.target_from_source.matrix(), three.target_from_source.matrix());
}

TEST(NoiseEstimation, KeepsToTheTimeAndSaysSo) {
  const auto problem = testing::random_problem(9, 50, 50);
  Options options = unknown_noise();
  options.time_limit = 1e-9;
  const Result result = register_correspondences(problem.source, problem.target, options);
  ASSERT_FALSE(result.diagnostics.limits_hit.empty());
  EXPECT_EQ(result.diagnostics.limits_hit.back().sentence,
            "the time budget ended the search for a noise bound");
}

TEST(NoiseEstimation, ReportsItsProgressAndStopsOnRequest) {
  const auto problem = testing::random_problem(10, 50, 50);
  Options options = unknown_noise();
  double last = -1;
  int num_calls = 0;
  options.progress = [&](const Progress& progress) {
    if (std::string(progress.stage) != "noise_bound") return true;
    EXPECT_GE(progress.fraction, last);
    last = progress.fraction;
    ++num_calls;
    return true;
  };
  register_correspondences(problem.source, problem.target, options);
  EXPECT_GT(num_calls, 5);
  EXPECT_LE(last, 1);
  int num_more = 0;
  options.progress = [&](const Progress&) { return ++num_more < 3; };
  register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(num_more, 3);
}

TEST(NoiseEstimation, RefusesABoundAsWell) {
  const auto problem = testing::random_problem(11, 10, 0);
  const auto message = [&](const Options& options) {
    try {
      register_correspondences(problem.source, problem.target, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  Options options = unknown_noise();
  options.noise_bound = 0.1;
  EXPECT_EQ(message(options).rfind("noise_bound:", 0), 0u);
  options.noise_bound = 0;
  options.noise_bounds.assign(10, 0.1);
  EXPECT_EQ(message(options).rfind("noise_bounds:", 0), 0u);
  options.noise_bounds.clear();
  options.memory_limit = 10;
  EXPECT_EQ(message(options).rfind("memory_limit:", 0), 0u);
  EXPECT_THROW(evaluate_consensus(problem.truth, problem.source, problem.target, unknown_noise()),
               std::invalid_argument);
  EXPECT_THROW(evaluate_uncertainty(problem.truth, problem.source, problem.target, {0, 1, 2},
                                    unknown_noise()),
               std::invalid_argument);
}

/// The numbers of a text file, any separator; lines with letters are left out.
std::vector<std::vector<double>> read_rows(const std::filesystem::path& path) {
  std::vector<std::vector<double>> rows;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.find("x") != std::string::npos) continue;
    for (char& c : line) c = c == ',' ? ' ' : c;
    std::istringstream numbers(line);
    rows.emplace_back();
    for (double value; numbers >> value;) rows.back().push_back(value);
  }
  return rows;
}

TEST(NoiseEstimation, FindsThePoseOfRealMatches) {
  const auto folder = testing::data_folder() / "gore" / "bunny";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << "no real data at " << folder.string();
  }
  const auto rows = read_rows(folder / "correspondences.csv");
  const auto count = static_cast<Index>(rows.size());
  Points source(3, count), target(3, count);
  for (Index i = 0; i < count; ++i) {
    const auto& row = rows[static_cast<std::size_t>(i)];  // i, j, the two points and two figures
    source.col(i) = Eigen::Vector3d(row[2], row[3], row[4]);
    target.col(i) = Eigen::Vector3d(row[5], row[6], row[7]);
  }
  const auto truth_rows = read_rows(folder / "T_target_source.txt");
  Eigen::Matrix4d truth;
  for (Index r = 0; r < 4; ++r) {
    for (Index c = 0; c < 4; ++c) {
      truth(r, c) = truth_rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    }
  }
  const Result result = register_correspondences(source, target, unknown_noise());
  ASSERT_EQ(result.status, Status::Ok);
  // the resolution of the cloud is 0.64; right matches are within twice that
  EXPECT_GT(result.noise_estimate->noise_bound, 0.2);
  EXPECT_LT(result.noise_estimate->noise_bound, 2);
  EXPECT_LT(
      rotation_error_deg(result.target_from_source.rotation, truth.topLeftCorner<3, 3>().eval()),
      3);
}

}  // namespace
}  // namespace gmcr::noise
