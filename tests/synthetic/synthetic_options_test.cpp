#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "gmcr/synthetic.hpp"

namespace gmcr::synthetic {
namespace {

SyntheticOptions with(SyntheticOptions options, void (*change)(SyntheticOptions&)) {
  change(options);
  return options;
}

/// The message of what make_synthetic throws; empty where it does not.
std::string complaint(const SyntheticOptions& options) {
  try {
    make_synthetic(options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

struct BadOption {
  const char* field;
  void (*change)(SyntheticOptions&);
};

/// GoogleTest would print addresses.
void PrintTo(const BadOption& bad, std::ostream* out) { *out << bad.field; }

class SyntheticOptionsTest : public testing::TestWithParam<BadOption> {};

TEST_P(SyntheticOptionsTest, OutOfRangeIsRejectedByName) {
  const BadOption& bad = GetParam();
  EXPECT_EQ(complaint(with(paper_structured_options(), bad.change)).rfind(bad.field, 0), 0u)
      << bad.field << ": " << complaint(with(paper_structured_options(), bad.change));
}

INSTANTIATE_TEST_SUITE_P(
    EachField, SyntheticOptionsTest,
    testing::Values(
        BadOption{"num_correspondences", [](auto& o) { o.num_correspondences = -1; }},
        BadOption{"outlier_rate", [](auto& o) { o.outlier_rate = -0.1; }},
        BadOption{"outlier_rate", [](auto& o) { o.outlier_rate = 1.1; }},
        BadOption{"outlier_rate", [](auto& o) { o.outlier_rate = std::nan(""); }},
        BadOption{"noise_extent", [](auto& o) { o.noise_extent = -1; }},
        BadOption{"noise_bound", [](auto& o) { o.noise_bound = 0; }},
        BadOption{"noise_bound", [](auto& o) { o.noise_bound = 0.017; }},
        BadOption{"noise_bound",
                  [](auto& o) { o.noise_bound = std::numeric_limits<double>::infinity(); }},
        BadOption{"scale_range.min",
                  [](auto& o) {
                    o.scale_range = {0, 1};
                  }},
        BadOption{"scale_range.max",
                  [](auto& o) {
                    o.scale_range = {2, 1};
                  }},
        BadOption{"max_translation", [](auto& o) { o.max_translation = -1; }},
        BadOption{"num_cloud_points", [](auto& o) { o.num_cloud_points = 89; }},
        BadOption{"num_sphere_points", [](auto& o) { o.num_sphere_points = -1; }},
        BadOption{"num_bases", [](auto& o) { o.num_bases = -1; }},
        BadOption{"num_bases", [](auto& o) { o.num_bases = 4; }},
        BadOption{"source_neighbours", [](auto& o) { o.source_neighbours = -1; }},
        BadOption{"target_neighbours", [](auto& o) { o.target_neighbours = 8; }},
        BadOption{"target_neighbours", [](auto& o) { o.target_neighbours = 1500; }},
        BadOption{"association_neighbours", [](auto& o) { o.association_neighbours = -1; }},
        BadOption{"noise_bound", [](auto& o) { o.noise_bound = 100; }}));

TEST(SyntheticOptions, OfThePaperAreValid) {
  EXPECT_NO_THROW(SyntheticOptions{}.validate());
  EXPECT_NO_THROW(paper_random_options().validate());
  EXPECT_NO_THROW(paper_structured_options().validate());
}

TEST(SyntheticOptions, OfTheBallIgnoreTheCloudOfThePaper) {
  SyntheticOptions options;
  options.num_correspondences = 3000;
  options.num_cloud_points = 10;
  EXPECT_EQ(make_synthetic(options).source.cols(), 3000);
}

TEST(SyntheticModel, WithTooFewPointsIsRejected) {
  EXPECT_THROW(make_synthetic(SyntheticOptions{}, Points::Random(3, 999)), std::invalid_argument);
  EXPECT_THROW(make_synthetic(paper_random_options(), Points::Random(3, 1499)),
               std::invalid_argument);
}

TEST(SyntheticModel, WithoutExtentOrFinitePointsIsRejected) {
  Points model = Points::Random(3, 1000);
  model(1, 7) = std::nan("");
  EXPECT_THROW(make_synthetic(SyntheticOptions{}, model), std::invalid_argument);
  EXPECT_THROW(make_synthetic(SyntheticOptions{}, Points::Constant(3, 1000, 5)),
               std::invalid_argument);
}

}  // namespace
}  // namespace gmcr::synthetic
