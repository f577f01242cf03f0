#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "gmcr/metrics.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr::synthetic {
namespace {

std::vector<SyntheticOptions> every_kind() {
  return {SyntheticOptions{}, paper_random_options(), paper_structured_options()};
}

/// FNV-1a over the bits of all points and of the truth.
std::uint64_t fingerprint(const SyntheticProblem& problem) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&hash](const double* values, Index count) {
    for (Index i = 0; i < count; ++i) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, values + i, sizeof bits);
      hash = (hash ^ bits) * 1099511628211ull;
    }
  };
  add(problem.source.data(), problem.source.size());
  add(problem.target.data(), problem.target.size());
  add(&problem.target_from_source.scale, 1);
  add(problem.target_from_source.rotation.data(), 9);
  add(problem.target_from_source.translation.data(), 3);
  for (const bool inlier : problem.is_inlier) hash = (hash ^ inlier) * 1099511628211ull;
  return hash;
}

double residual(const SyntheticProblem& problem, Index i) {
  const Eigen::Vector3d source = problem.source.col(i);
  return (problem.target.col(i) - problem.target_from_source * source).norm();
}

Index count_inliers(const SyntheticProblem& problem) {
  return std::count(problem.is_inlier.begin(), problem.is_inlier.end(), true);
}

/// Points on a bent tube: a surface without symmetry, in millimetres, far from the origin.
Points tube(Index count) {
  Points points(3, count);
  for (Index i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(count);
    const double v = std::fmod(static_cast<double>(i) * 0.61803398875, 1.0) * 2 * M_PI;
    points.col(i) << 4000 + 300 * u, 100 * u * u + (40 + 20 * u) * std::cos(v),
        (40 + 20 * u) * std::sin(v);
  }
  return points;
}

TEST(Synthetic, SameSeedGivesTheSameBitsAsEverBefore) {
  std::vector<std::uint64_t> hashes;
  for (SyntheticOptions options : every_kind()) {
    options.seed = 42;
    hashes.push_back(fingerprint(make_synthetic(options)));
  }
  SyntheticOptions gaussian;
  gaussian.noise_shape = NoiseShape::Gaussian;
  hashes.push_back(fingerprint(make_synthetic(gaussian)));
  EXPECT_EQ(hashes, (std::vector<std::uint64_t>{17647171299484439357ull, 7656888361956940259ull,
                                                14778715056950104645ull, 10372320725954598288ull}));
}

TEST(Synthetic, AnotherSeedGivesAnotherProblem) {
  for (SyntheticOptions options : every_kind()) {
    const SyntheticProblem first = make_synthetic(options);
    options.seed = 1;
    const SyntheticProblem second = make_synthetic(options);
    EXPECT_NE(first.source, second.source);
    EXPECT_NE(first.target, second.target);
    EXPECT_GT(
        rotation_error_deg(first.target_from_source.rotation, second.target_from_source.rotation),
        0.1);
  }
}

RC_GTEST_PROP(Synthetic, InliersAreCountedExactlyAndLabelsAreTrue, (std::uint64_t seed)) {
  const auto kinds = every_kind();
  SyntheticOptions options = kinds[*rc::gen::inRange<std::size_t>(0, kinds.size())];
  options.seed = seed;
  options.num_correspondences = *rc::gen::inRange<Index>(0, 200);
  const int percent = *rc::gen::inRange(0, 101);
  options.outlier_rate = percent / 100.0;
  const SyntheticProblem problem = make_synthetic(options);
  const Index count = options.num_correspondences;
  RC_ASSERT(problem.source.cols() == count && problem.target.cols() == count);
  RC_ASSERT(std::ssize(problem.is_inlier) == count);
  RC_ASSERT(problem.noise_bound == options.noise_bound);
  RC_ASSERT(count_inliers(problem) ==
            std::floor((100 - percent) * static_cast<double>(count) / 100.0 + 0.5));
  for (Index i = 0; i < count; ++i) {
    RC_ASSERT(problem.is_inlier[static_cast<std::size_t>(i)] ==
              (residual(problem, i) <= problem.noise_bound * (1 + 1e-12)));
  }
}

TEST(Synthetic, TransformStaysInTheRangesAndReachesTheirEnds) {
  SyntheticOptions options = paper_random_options();
  options.num_correspondences = 1;
  options.outlier_rate = 0;
  options.num_cloud_points = 1;
  double low = 10;
  double high = 0;
  double farthest = 0;
  for (options.seed = 0; options.seed < 200; ++options.seed) {
    const Similarity truth = make_synthetic(options).target_from_source;
    low = std::min(low, truth.scale);
    high = std::max(high, truth.scale);
    farthest = std::max(farthest, truth.translation.cwiseAbs().maxCoeff());
    EXPECT_NEAR(truth.rotation.determinant(), 1, 1e-12);
  }
  EXPECT_GE(low, 1);
  EXPECT_LT(low, 1.1);
  EXPECT_LE(high, 5);
  EXPECT_GT(high, 4.9);
  EXPECT_LE(farthest, 1.5);
  EXPECT_GT(farthest, 1.45);
}

TEST(Synthetic, NoiseHasItsShape) {
  SyntheticOptions options;
  options.outlier_rate = 0;
  options.noise_extent = 0.01;
  options.noise_bound = 0.02;
  const auto norms = [&options](NoiseShape shape) {
    options.noise_shape = shape;
    const SyntheticProblem problem = make_synthetic(options);
    std::vector<double> result;
    for (Index i = 0; i < 1000; ++i) result.push_back(residual(problem, i));
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto ball = norms(NoiseShape::Ball);
  EXPECT_NEAR(ball[500], 0.01 * std::cbrt(0.5), 5e-4);
  EXPECT_LE(ball.back(), 0.01 + 1e-12);
  const auto gaussian = norms(NoiseShape::Gaussian);
  EXPECT_NEAR(gaussian[500], 0.01 / 3 * 1.52, 4e-4);
  EXPECT_LE(gaussian.back(), 0.01 + 1e-12);
  const auto cube = norms(NoiseShape::Cube);
  EXPECT_GT(cube.back(), 0.014);
  EXPECT_LE(cube.back(), 0.01 * std::sqrt(3.0) + 1e-12);
  options.noise_extent = 0;
  EXPECT_LT(norms(NoiseShape::Ball).back(), 1e-14);
}

TEST(Synthetic, SourceOfAModelFitsTheUnitCubeAndKeepsItsProportions) {
  SyntheticOptions options;
  options.num_correspondences = 2000;
  const SyntheticProblem problem = make_synthetic(options, tube(2000));
  const Eigen::Vector3d side =
      problem.source.rowwise().maxCoeff() - problem.source.rowwise().minCoeff();
  const Points model = tube(2000);
  const Eigen::Vector3d model_side = model.rowwise().maxCoeff() - model.rowwise().minCoeff();
  EXPECT_NEAR(side(0), 1, 1e-12);
  EXPECT_TRUE(side.isApprox(model_side / model_side(0), 1e-12));
  EXPECT_LT(problem.source.rowwise().maxCoeff()(0) - 0.5, 1e-12);
}

TEST(SyntheticBall, OutliersFillTheBallAroundTheImageOfTheCloud) {
  SyntheticOptions options;
  options.num_correspondences = 4000;
  options.outlier_rate = 1;
  options.scale_range = {2.5, 2.5};
  const SyntheticProblem problem = make_synthetic(options);
  const double radius = 2.5 * problem.source.colwise().norm().maxCoeff();
  const auto distances =
      (problem.target.colwise() - problem.target_from_source.translation).colwise().norm();
  EXPECT_LE(distances.maxCoeff(), radius);
  EXPECT_NEAR((distances.array() < radius / 2).count() / 4000.0, 1.0 / 8, 0.03);
}

TEST(SyntheticRandom, SourcesDoNotRepeat) {
  SyntheticOptions options = paper_random_options();
  options.num_correspondences = options.num_cloud_points;
  const SyntheticProblem problem = make_synthetic(options);
  std::vector<double> x(problem.source.row(0).begin(), problem.source.row(0).end());
  std::sort(x.begin(), x.end());
  EXPECT_EQ(std::adjacent_find(x.begin(), x.end()), x.end());
}

TEST(SyntheticRandom, OutliersGoToTheSphereAsOftenAsItHasPoints) {
  SyntheticOptions options = paper_random_options();
  options.num_correspondences = 1500;
  options.outlier_rate = 1;
  const Points model = tube(1500);
  const auto num_on_sphere = [&] {
    // All points of the model lie near its thin tube, the sphere's do not.
    const SyntheticProblem problem = make_synthetic(options, model);
    const Points back = problem.target_from_source.inverse().apply(problem.target);
    Index count = 0;
    for (Index i = 0; i < back.cols(); ++i) {
      count += (problem.source.colwise() - back.col(i)).colwise().norm().minCoeff() > 0.05;
    }
    return count;
  };
  EXPECT_NEAR(static_cast<double>(num_on_sphere()), 1500 * 200.0 / 1700, 40);
  options.num_sphere_points = 0;
  EXPECT_EQ(num_on_sphere(), 0);
}

/// How many sources lie within 0.15 of source i with targets within 0.3 * scale, averaged over the
/// outliers.
double mean_companions(const SyntheticProblem& problem) {
  const double scale = problem.target_from_source.scale;
  double pairs = 0;
  double outliers = 0;
  for (Index i = 0; i < problem.source.cols(); ++i) {
    if (problem.is_inlier[static_cast<std::size_t>(i)]) continue;
    ++outliers;
    for (Index j = 0; j < problem.source.cols(); ++j) {
      pairs += i != j && !problem.is_inlier[static_cast<std::size_t>(j)] &&
               (problem.source.col(i) - problem.source.col(j)).norm() < 0.15 &&
               (problem.target.col(i) - problem.target.col(j)).norm() < 0.3 * scale;
    }
  }
  return pairs / outliers;
}

TEST(SyntheticStructured, OutliersClusterInBothClouds) {
  SyntheticOptions options = paper_structured_options();
  options.outlier_rate = 0.8;
  options.num_bases = 8;
  const double structured = mean_companions(make_synthetic(options, tube(1500)));
  EXPECT_GT(structured, 6);  // 72 outliers in 8 clusters of 9 on average
  options.kind = SyntheticKind::Random;
  EXPECT_LT(mean_companions(make_synthetic(options, tube(1500))), 0.5 * structured);
}

TEST(SyntheticStructured, MoreBasesMakeSmallerClusters) {
  SyntheticOptions options = paper_structured_options();
  options.outlier_rate = 0.8;
  options.num_bases = 8;
  const double few = mean_companions(make_synthetic(options, tube(1500)));
  options.num_bases = 72;
  EXPECT_LT(mean_companions(make_synthetic(options, tube(1500))), 0.6 * few);
}

TEST(SyntheticStructured, NarrowNeighborhoodsMakeTightClusters) {
  SyntheticOptions options = paper_structured_options();
  options.num_correspondences = 10;
  options.outlier_rate = 1;
  options.num_bases = 1;
  const auto widths = [&options] {
    const SyntheticProblem problem = make_synthetic(options, tube(1500));
    const auto width = [](const Points& points) {
      return (points.colwise() - points.col(0)).colwise().norm().maxCoeff();
    };
    return std::pair(width(problem.source),
                     width(problem.target) / problem.target_from_source.scale);
  };
  const auto narrow = widths();
  EXPECT_LT(narrow.first, 0.2);
  EXPECT_LT(narrow.second, 0.3);
  options.target_neighbors = 200;
  EXPECT_EQ(widths().first, narrow.first);
  EXPECT_GT(widths().second, 2 * narrow.second);
  options.source_neighbors = 200;
  EXPECT_GT(widths().first, 2 * narrow.first);
}

TEST(SyntheticStructured, AssociationErrorsAreThereUnlessTurnedOff) {
  SyntheticOptions options = paper_structured_options();
  options.outlier_rate = 0;
  options.scale_range = {2, 2};
  const auto mean_residual = [&options] {
    const SyntheticProblem problem = make_synthetic(options, tube(1500));
    double sum = 0;
    for (Index i = 0; i < 90; ++i) sum += residual(problem, i);
    return sum / 90;
  };
  const double wrong_neighbor = mean_residual();
  options.association_neighbors = 0;
  EXPECT_LT(mean_residual(), 0.011);  // the mean of the noise alone is 0.0096
  EXPECT_GT(wrong_neighbor, 0.02);
}

}  // namespace
}  // namespace gmcr::synthetic
