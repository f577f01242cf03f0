#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <ostream>
#include <string>

#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The message of the exception that `call` throws; empty where it throws none.
std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

struct BadOption {
  const char* field;
  std::function<void(FrontendOptions&)> spoil;
};

/// Names the test case.
void PrintTo(const BadOption& option, std::ostream* out) { *out << option.field; }

class BadFrontendOption : public ::testing::TestWithParam<BadOption> {};

TEST_P(BadFrontendOption, ThrowsAndNamesTheField) {
  FrontendOptions frontend;
  GetParam().spoil(frontend);
  const std::string field = GetParam().field;
  EXPECT_EQ(message_of([&] { frontend.validate(); }).rfind(field + ":", 0), 0u)
      << message_of([&] { frontend.validate(); });
  const Points points = testing::random_points(10, 1);
  EXPECT_NE(message_of([&] { match_clouds(points, points, frontend); }), "");
  EXPECT_NE(message_of([&] { register_clouds(points, points, frontend); }), "");
}

INSTANTIATE_TEST_SUITE_P(
    Frontend, BadFrontendOption,
    ::testing::Values(BadOption{"voxel_size", [](auto& f) { f.voxel_size = -1; }},
                      BadOption{"voxel_size", [](auto& f) { f.voxel_size = kNan; }},
                      BadOption{"voxel_size", [](auto& f) { f.voxel_size = kInfinity; }},
                      BadOption{"source_voxel_size", [](auto& f) { f.source_voxel_size = -1; }},
                      BadOption{"normal_radius", [](auto& f) { f.normal_radius = 0; }},
                      BadOption{"feature_radius", [](auto& f) { f.feature_radius = kNan; }},
                      BadOption{"feature_radius", [](auto& f) { f.feature_radius = 1; }},
                      BadOption{"noise_bound_voxels", [](auto& f) { f.noise_bound_voxels = 0; }},
                      BadOption{"source_viewpoint", [](auto& f) { f.source_viewpoint.x() = kNan; }},
                      BadOption{"target_viewpoint",
                                [](auto& f) { f.target_viewpoint.z() = kInfinity; }},
                      BadOption{"max_ratio", [](auto& f) { f.max_ratio = 0; }},
                      BadOption{"max_ratio", [](auto& f) { f.max_ratio = 1.1; }},
                      BadOption{"max_attempts", [](auto& f) { f.max_attempts = 0; }}));

TEST(FrontendOptions, ByDefaultAreValid) { EXPECT_NO_THROW(FrontendOptions{}.validate()); }

TEST(FrontendInput, ThatIsNotFiniteThrowsAndNamesCloudAndPoint) {
  const Points good = testing::random_points(10, 1);
  Points bad = good;
  bad(1, 4) = kNan;
  EXPECT_EQ(message_of([&] { match_clouds(bad, good); }), "source: point 4 is not finite");
  EXPECT_EQ(message_of([&] { register_clouds(good, bad); }), "target: point 4 is not finite");
  bad(1, 4) = kInfinity;
  EXPECT_EQ(message_of([&] { match_clouds(bad, good); }), "source: point 4 is not finite");
}

TEST(FrontendInput, WithBoundsPerCorrespondenceThrows) {
  const Points points = testing::random_points(10, 1);
  Options options;
  options.noise_bounds = {1, 2, 3};
  EXPECT_NE(message_of([&] { register_clouds(points, points, {}, options); }).find("noise_bounds"),
            std::string::npos);
}

TEST(FrontendInput, WithABadSolverOptionThrowsBeforeAnyWork) {
  const Points points = testing::random_points(10, 1);
  Options options;
  options.noise_bound = -1;
  EXPECT_NE(message_of([&] { match_clouds(points, points, {}, options); }).find("noise_bound"),
            std::string::npos);
}

}  // namespace
}  // namespace gmcr::frontend
