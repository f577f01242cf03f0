#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "c/objects.hpp"
#include "c/pointers.hpp"
#include "frontend/shapes.hpp"
#include "gmcr/registration.hpp"
#include "problems.hpp"

namespace gmcr::c {
namespace {

gmcr_points points_of(const Points& points) {
  return {points.data(), static_cast<std::size_t>(points.cols()), 0, GMCR_FLOAT64};
}

OptionsPointer with_noise_bound(double noise_bound) {
  OptionsPointer options(gmcr_options_new());
  gmcr_options_set_number(options.get(), "noise_bound", noise_bound);
  return options;
}

ResultPointer solve(const testing::Problem& problem, const OptionsPointer& options) {
  return ResultPointer(gmcr_register_correspondences(points_of(problem.source),
                                                     points_of(problem.target), options.get()));
}

TEST(ResultInC, IsThatOfTheLibrary) {
  const testing::Problem problem = testing::random_problem(1, 40, 160);
  const Result expected =
      register_correspondences(problem.source, problem.target, problem.options());
  const ResultPointer result = solve(problem, with_noise_bound(problem.noise_bound));
  ASSERT_EQ(gmcr_result_error(result.get()), GMCR_SUCCESS) << gmcr_result_message(result.get());
  EXPECT_EQ(gmcr_result_status(result.get()), GMCR_OK);
  EXPECT_EQ(gmcr_result_verdict(result.get()), GMCR_TRUSTED);
  EXPECT_EQ(gmcr_result_verdict_reason(result.get()), expected.verdict_reason);
  EXPECT_EQ(gmcr_result_scale(result.get()), 1);

  double pose[16];
  gmcr_result_pose(result.get(), pose);
  const Eigen::Matrix4d matrix = expected.target_from_source.matrix();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      EXPECT_EQ(pose[4 * row + column], matrix(row, column));
  }
  std::size_t count = 0;
  const std::ptrdiff_t* inliers = gmcr_result_inliers(result.get(), &count);
  EXPECT_EQ(std::vector<Index>(inliers, inliers + count), expected.inliers);
  std::ptrdiff_t lower = 0, upper = 0;
  gmcr_result_certificate(result.get(), &lower, &upper);
  EXPECT_EQ(lower, expected.certificate.lower);
  EXPECT_EQ(upper, expected.certificate.upper);
  EXPECT_EQ(gmcr_result_fitness(result.get()), 0);
}

TEST(ResultInC, HasTheCovarianceOfBothConventions) {
  const testing::Problem problem = testing::random_problem(1, 40, 160);
  const Result expected =
      register_correspondences(problem.source, problem.target, problem.options());
  const ResultPointer result = solve(problem, with_noise_bound(problem.noise_bound));
  double gtsam[36], ros[36];
  ASSERT_EQ(gmcr_result_covariance(result.get(), GMCR_GTSAM, gtsam), 1);
  ASSERT_EQ(gmcr_result_covariance(result.get(), GMCR_ROS, ros), 1);
  const auto in_ros = pose_graph_covariance(expected.covariance.value(),
                                            expected.target_from_source, PoseGraph::Ros);
  EXPECT_EQ(ros[1], in_ros(0, 1));
  EXPECT_EQ(ros[35], in_ros(5, 5));
  EXPECT_NE(gtsam[0], ros[0]);
}

TEST(ResultInC, IsJsonWithTheOptions) {
  const testing::Problem problem = testing::random_problem(1, 40, 160);
  const ResultPointer result = solve(problem, with_noise_bound(problem.noise_bound));
  const std::unique_ptr<char, Free> json(gmcr_result_to_json(result.get()));
  ASSERT_NE(json, nullptr);
  EXPECT_NE(std::strstr(json.get(), "\"status\":\"ok\""), nullptr) << json.get();
  EXPECT_NE(std::strstr(json.get(), "\"noise_bound\":0.01"), nullptr);
}

TEST(ResultInC, OfFloatsWithAStrideIsThatOfTheSameNumbers) {
  struct Point {
    std::uint8_t before;  // so that the numbers are not aligned
    float xyz[3];
    char after[7];
  } __attribute__((packed));
  const Points source = testing::bumpy_sphere(3000, 1);
  const Points target = testing::some_motion().apply(source);
  std::vector<Point> packed[2];
  Points rounded[2];
  for (int cloud = 0; cloud < 2; ++cloud) {
    const Points& points = cloud == 0 ? source : target;
    rounded[cloud] = points.cast<float>().cast<double>();
    for (Index i = 0; i < points.cols(); ++i) {
      Point point{};
      for (int axis = 0; axis < 3; ++axis) point.xyz[axis] = static_cast<float>(points(axis, i));
      packed[cloud].push_back(point);
    }
  }
  const auto given = [&](int cloud) {
    return gmcr_points{reinterpret_cast<const char*>(packed[cloud].data()) + 1,
                       packed[cloud].size(), sizeof(Point), GMCR_FLOAT32};
  };
  OptionsPointer options(gmcr_options_new());
  gmcr_options_set_number(options.get(), "max_attempts", 1);
  FrontendOptions once;
  once.max_attempts = 1;
  const ResultPointer result(gmcr_register_clouds(given(0), given(1), options.get()));
  ASSERT_EQ(gmcr_result_error(result.get()), GMCR_SUCCESS) << gmcr_result_message(result.get());
  const CloudResult expected = register_clouds(rounded[0], rounded[1], once);
  double pose[16];
  gmcr_result_pose(result.get(), pose);
  EXPECT_EQ(pose[3], expected.registration.target_from_source.matrix()(0, 3));
  EXPECT_EQ(gmcr_result_fitness(result.get()), expected.fitness);
  EXPECT_EQ(gmcr_result_verdict(result.get()), GMCR_TRUSTED);
  const std::unique_ptr<char, Free> json(gmcr_result_to_json(result.get()));
  EXPECT_NE(std::strstr(json.get(), "\"fitness\""), nullptr);
}

TEST(ResultInC, SaysWhatWasWrong) {
  const testing::Problem problem = testing::random_problem(1, 10, 10);
  const auto message = [](const ResultPointer& result) {
    EXPECT_EQ(gmcr_result_error(result.get()), GMCR_INVALID_ARGUMENT);
    EXPECT_EQ(gmcr_result_verdict(result.get()), GMCR_UNTRUSTED);
    EXPECT_EQ(gmcr_result_to_json(result.get()), nullptr);
    return std::string(gmcr_result_message(result.get()));
  };
  EXPECT_NE(message(solve(problem, OptionsPointer())).find("noise_bound"), std::string::npos);
  EXPECT_NE(message(solve(problem, with_noise_bound(-1))).find("noise_bound"), std::string::npos);

  const OptionsPointer options = with_noise_bound(0.01);
  const auto of = [&](const gmcr_points& source, const gmcr_points& target) {
    return message(ResultPointer(gmcr_register_correspondences(source, target, options.get())));
  };
  const gmcr_points good = points_of(problem.source);
  gmcr_points bad = good;
  bad.data = nullptr;
  EXPECT_EQ(of(good, bad), "target.data: is null");
  bad = good;
  bad.stride = 20;
  EXPECT_EQ(of(bad, good), "source.stride: 20 is less than 24 bytes");
  bad = good;
  bad.type = static_cast<gmcr_number>(7);
  EXPECT_NE(of(bad, good).find("source.type"), std::string::npos);
  bad = good;
  bad.count = SIZE_MAX;
  EXPECT_NE(of(bad, good).find("source.count"), std::string::npos);
  bad = good;
  bad.count -= 1;
  EXPECT_FALSE(of(bad, good).empty());
}

TEST(ResultInC, OfNothingIsWithoutMemory) {
  double pose[16];
  gmcr_result_pose(nullptr, pose);
  EXPECT_EQ(pose[0], 1);
  EXPECT_EQ(gmcr_result_error(nullptr), GMCR_OUT_OF_MEMORY);
  std::size_t count = 1;
  EXPECT_EQ(gmcr_result_inliers(nullptr, &count), nullptr);
  EXPECT_EQ(count, 0u);
  gmcr_result_free(nullptr);
  gmcr_options_free(nullptr);
}

TEST(ProgressInC, IsCalledWithWhatTheUserGaveAndStops) {
  const testing::Problem problem = testing::random_problem(1, 40, 160);
  const OptionsPointer options = with_noise_bound(problem.noise_bound);
  int calls = 0;
  const gmcr_progress stop = [](const char*, double, void* user) {
    ++*static_cast<int*>(user);
    return 0;
  };
  ASSERT_EQ(gmcr_options_set_progress(options.get(), stop, &calls), GMCR_SUCCESS);
  const ResultPointer result = solve(problem, options);
  EXPECT_GT(calls, 0);
  const std::unique_ptr<char, Free> json(gmcr_result_to_json(result.get()));
  EXPECT_NE(std::strstr(json.get(), "\"stopped\""), nullptr);
}

}  // namespace
}  // namespace gmcr::c
