#include <gtest/gtest.h>

#include "kernels/for_each_isa.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

void expect_same(const Result& a, const Result& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.target_from_source.scale, b.target_from_source.scale);
  EXPECT_EQ(a.target_from_source.rotation, b.target_from_source.rotation);
  EXPECT_EQ(a.target_from_source.translation, b.target_from_source.translation);
  EXPECT_EQ(a.inliers, b.inliers);
  EXPECT_EQ(a.certificate.lower, b.certificate.lower);
  EXPECT_EQ(a.certificate.upper, b.certificate.upper);
  EXPECT_EQ(a.certificate.evidence.lower, b.certificate.evidence.lower);
  EXPECT_EQ(a.certificate.evidence.upper, b.certificate.evidence.upper);
}

void expect_the_same_on_every_isa(const testing::Problem& problem, const Options& options) {
  const Result best = register_correspondences(problem.source, problem.target, options);
  ASSERT_EQ(best.status, Status::Ok);
  testing::for_each_isa([&] {
    expect_same(register_correspondences(problem.source, problem.target, options), best);
  });
}

TEST(InstructionSets, GiveTheSameAnswerAtAKnownScale) {
  // sizes on both sides of where single precision is used
  for (const Index num_outliers : {60, 700}) {
    const auto problem = testing::random_problem(1, 60, num_outliers, 1.5);
    expect_the_same_on_every_isa(problem, problem.options());
  }
}

TEST(InstructionSets, GiveTheSameAnswerAtAnUnknownScale) {
  for (const Index num_outliers : {60, 300}) {
    const auto problem = testing::random_problem(2, 40, num_outliers, 0.7);
    expect_the_same_on_every_isa(problem, problem.options_with_unknown_scale());
  }
}

TEST(InstructionSets, GiveTheSameAnswerByTheMethodOfThePaper) {
  const auto problem = testing::random_problem(3, 30, 30);
  Options options = problem.options();
  options.method = Method::Paper;
  expect_the_same_on_every_isa(problem, options);
  options = problem.options_with_unknown_scale();
  options.method = Method::Paper;
  expect_the_same_on_every_isa(problem, options);
}

}  // namespace
}  // namespace gmcr::registration
