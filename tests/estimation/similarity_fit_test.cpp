#include "estimation/closed_forms/similarity_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>

#include "gmcr/metrics.hpp"
#include "random_geometry.hpp"

namespace gmcr::estimation {
namespace {

constexpr ScaleRange kAnyScale{1e-6, 1e6};

std::vector<Index> all_indices(const Points& points) {
  std::vector<Index> indices(static_cast<std::size_t>(points.cols()));
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

TEST(FitSimilarity, AgreesWithEigensUmeyamaOnNoisyPoints) {
  testing::RandomGeometry random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Points source = random.in_cube(3 + random.index(20));
    Points target = random.similarity(0.2, 5, 3).apply(source);
    target += random.in_cube(source.cols(), 0.05);
    const Eigen::ArrayXd bounds = Eigen::ArrayXd::Constant(source.cols(), 0.1);
    const auto fit = fit_similarity(source, target, bounds, all_indices(source), kAnyScale);
    ASSERT_TRUE(fit);
    EXPECT_LT((fit->matrix() - Eigen::umeyama(source, target, true)).norm(), 1e-9);
    const auto rigid = fit_similarity(source, target, bounds, all_indices(source), {1, 1});
    EXPECT_LT((rigid->matrix() - Eigen::umeyama(source, target, false)).norm(), 1e-9);
  }
}

TEST(FitSimilarity, UsesOnlyTheGivenColumns) {
  testing::RandomGeometry random(2);
  const Similarity truth = random.similarity(0.5, 2, 1);
  const Points source = random.in_cube(8);
  Points target = truth.apply(source);
  target.col(3).setConstant(100);
  const auto fit =
      fit_similarity(source, target, Eigen::ArrayXd::Ones(8), {0, 1, 2, 4, 5, 6, 7}, kAnyScale);
  EXPECT_LT(mean_point_error(*fit, truth, source), 1e-12);
}

TEST(FitSimilarity, TrustsATightBoundMoreThanALooseOne) {
  testing::RandomGeometry random(3);
  const Points source = random.in_cube(6);
  Points target = source;
  target.col(5) += Eigen::Vector3d(1, 0, 0);
  Eigen::ArrayXd bounds = Eigen::ArrayXd::Ones(6);
  const auto equal = fit_similarity(source, target, bounds, all_indices(source), {1, 1});
  bounds[5] = 1000;
  const auto weighted = fit_similarity(source, target, bounds, all_indices(source), {1, 1});
  EXPECT_LT(mean_point_error(*weighted, {}, source), 1e-4);
  EXPECT_GT(mean_point_error(*equal, {}, source), 1e-2);
}

TEST(FitSimilarity, KeepsTheScaleInItsRange) {
  testing::RandomGeometry random(4);
  const Points source = random.in_cube(10);
  Similarity triple;
  triple.scale = 3;
  const Points target = triple.apply(source);
  const Eigen::ArrayXd bounds = Eigen::ArrayXd::Ones(10);
  EXPECT_EQ(fit_similarity(source, target, bounds, all_indices(source), {1, 2})->scale, 2);
  EXPECT_EQ(fit_similarity(source, target, bounds, all_indices(source), {4, 5})->scale, 4);
}

TEST(FitSimilarity, NeedsThreeColumns) {
  EXPECT_FALSE(fit_similarity(Points::Zero(3, 5), Points::Zero(3, 5), Eigen::ArrayXd::Ones(5),
                              {0, 1}, kAnyScale));
}

TEST(FitSimilarity, OfCollinearPointsMapsTheLineOntoItsImage) {
  testing::RandomGeometry random(5);
  const Similarity truth = random.similarity(2, 2, 1);
  Points source(3, 4);
  source << 0, 1, 2, 5, 0, 1, 2, 5, 0, 0, 0, 0;
  const Points target = truth.apply(source);
  const auto fit =
      fit_similarity(source, target, Eigen::ArrayXd::Ones(4), all_indices(source), kAnyScale);
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->apply(source) - target).norm(), 1e-9);
}

TEST(FitSimilarity, OfCoincidentPointsIsFinite) {
  const Points source = Points::Constant(3, 4, 1.0), target = Points::Constant(3, 4, 2.0);
  const auto fit =
      fit_similarity(source, target, Eigen::ArrayXd::Ones(4), all_indices(source), kAnyScale);
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->apply(source) - target).norm(), 1e-12);
}

}  // namespace
}  // namespace gmcr::estimation
