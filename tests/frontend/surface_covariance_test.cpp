#include "frontend/alignment/surface_covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kCell = 0.05;
const RefinementScale kScale{kCell, 1.5, 2500, 1e-3};

Points noisy(Points points, double sigma, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0, sigma);
  for (double& value : points.reshaped()) value += normal(generator);
  return points;
}

/// Where two clouds meet best, and how sure that is.
struct Aligned {
  CentredPair pair;
  RefinedPose refined;

  Aligned(const PointsRef& source, const PointsRef& target, const Similarity& start,
          const Options& options = {})
      : pair(voxel_grid(source, kCell), voxel_grid(target, kCell), kCell, kCell, 1),
        refined(refine_pose(pair, start, kScale, options, parallel::Deadline::never())) {}

  std::optional<Covariance> covariance(const std::optional<Covariance>& of_matches = {},
                                       bool estimates_scale = false) {
    return surface_covariance(pair, refined, estimates_scale, of_matches, 2);
  }
};

/// d' C^-1 d of the difference to the truth, over the number of parameters.
double squared_error(const Covariance& covariance, const Similarity& pose,
                     const Similarity& truth) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(truth.rotation * pose.rotation.transpose()));
  Eigen::VectorXd difference(covariance.matrix.rows());
  difference.head<3>() = turn.angle() * turn.axis();
  difference.segment<3>(3) = truth.translation - pose.translation;
  if (difference.size() == 7) difference[6] = std::log(truth.scale / pose.scale);
  return difference.dot(covariance.matrix.ldlt().solve(difference)) /
         static_cast<double>(difference.size());
}

TEST(SurfaceCovariance, IsTrueOfTwoSamplingsOfASurface) {
  for (const bool estimates_scale : {false, true}) {
    const Similarity truth = testing::some_motion(estimates_scale ? 1.3 : 1);
    Options options;
    options.scale_mode = estimates_scale ? ScaleMode::Estimated : ScaleMode::Known;
    std::vector<double> squares;
    for (unsigned seed = 0; seed < 30; ++seed) {
      const Points source = noisy(testing::bumpy_sphere(6000, 2 * seed), 0.01, seed);
      const Points target =
          noisy(truth.apply(testing::bumpy_sphere(6000, 2 * seed + 1)), 0.01, ~seed);
      Aligned aligned(source, target, truth, options);
      const auto covariance = aligned.covariance({}, estimates_scale);
      ASSERT_TRUE(covariance);
      ASSERT_EQ(covariance->matrix.rows(), estimates_scale ? 7 : 6);
      EXPECT_GT(covariance->eigenvalues.minCoeff(), 0);
      squares.push_back(squared_error(*covariance, aligned.refined.target_from_source, truth));
    }
    std::nth_element(squares.begin(), squares.begin() + 15, squares.end());
    EXPECT_GT(squares[15], 0.25) << estimates_scale;
    EXPECT_LT(squares[15], 2) << estimates_scale;
  }
}

/// A floor, and walls that meet it, 3 m long, each point with noise of 2 mm.
Points room(int num_walls, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> along(0, 3);
  constexpr Index kEach = 6000;
  Points points = Points::Zero(3, kEach * (1 + num_walls));
  for (Index i = 0; i < points.cols(); ++i) {
    const Index side = i / kEach;  // the floor, then y = 0, then x = 0
    for (Index axis = 0; axis < 3; ++axis) {
      if (axis != 2 - side) points(axis, i) = along(generator);
    }
  }
  return noisy(points, 0.002, seed);
}

TEST(SurfaceCovariance, IsThatOfTheMatchesAlongWhatTheSurfacesLeaveOpen) {
  Covariance of_matches;
  of_matches.matrix = 1e-2 * Eigen::MatrixXd::Identity(6, 6);
  of_matches.eigenvalues = of_matches.matrix.diagonal();
  Aligned edge(room(1, 1), room(1, 2), {});
  EXPECT_FALSE(edge.covariance());
  const auto covariance = edge.covariance(of_matches);
  ASSERT_TRUE(covariance);
  EXPECT_GT(covariance->matrix(3, 3), 0.9e-2);
  EXPECT_LT(covariance->matrix(4, 4), 1e-5);
  EXPECT_LT(covariance->matrix(5, 5), 1e-5);
  EXPECT_LT(covariance->matrix.topLeftCorner(3, 3).diagonal().maxCoeff(), 1e-5);
  const auto corner = Aligned(room(2, 1), room(2, 2), {}).covariance(of_matches);
  ASSERT_TRUE(corner);
  EXPECT_LT(corner->matrix.diagonal().maxCoeff(), 1e-5);
}

TEST(SurfaceCovariance, OfFewPairsIsThatOfTheMatches) {
  Covariance of_matches;
  of_matches.matrix = Eigen::MatrixXd::Identity(6, 6);
  of_matches.eigenvalues = Eigen::VectorXd::Ones(6);
  const Points few = testing::bumpy_sphere(60, 1);
  Aligned aligned(few, few, {});
  EXPECT_FALSE(aligned.covariance());
  EXPECT_EQ(aligned.covariance(of_matches)->matrix, of_matches.matrix);
}

TEST(SurfaceCovariance, OfCopiesIsThatOfTheirDigits) {
  const Points source = testing::bumpy_sphere(6000, 1);
  const Similarity truth = testing::some_motion();
  Aligned aligned(voxel_grid(source, kCell), truth.apply(voxel_grid(source, kCell)), truth);
  const auto covariance = aligned.covariance();
  ASSERT_TRUE(covariance);
  EXPECT_GT(covariance->eigenvalues.minCoeff(), 0);
  EXPECT_TRUE(covariance->matrix.allFinite());
}

TEST(SurfaceCovariance, IsTheSameAnywhereOnEarth) {
  const Eigen::Vector3d far(4e6, -3e6, 2e6);
  const Similarity truth = testing::some_motion();
  const Points source = testing::bumpy_sphere(6000, 1);
  const Points target = truth.apply(testing::bumpy_sphere(6000, 2));
  Similarity far_truth = truth;  // of clouds that both lie there
  far_truth.translation += far - truth.rotation * far;
  Aligned here(source, target, truth);
  Aligned there(source.colwise() + far, target.colwise() + far, far_truth);
  const auto near_one = here.covariance(), far_one = there.covariance();
  ASSERT_TRUE(near_one && far_one);
  // voxels begin at other places
  for (Index k = 0; k < 6; ++k) {
    const double ratio = far_one->eigenvalues[k] / near_one->eigenvalues[k];
    EXPECT_GT(ratio, 0.4);
    EXPECT_LT(ratio, 2.5);
  }
}

TEST(SurfaceCovariance, OfRegisteredCloudsIsWhatTheResultHolds) {
  const Similarity truth = testing::some_motion();
  const Points source = testing::bumpy_sphere(8000, 5);
  const Points target = truth.apply(testing::bumpy_sphere(8000, 6));
  const CloudResult refined = register_clouds(source, target);
  FrontendOptions frontend;
  frontend.refine = Refine::None;
  const CloudResult by_matches = register_clouds(source, target, frontend);
  ASSERT_TRUE(refined.registration.covariance && by_matches.registration.covariance);
  // surfaces are far surer than matches
  EXPECT_LT(10 * refined.registration.covariance->eigenvalues.maxCoeff(),
            by_matches.registration.covariance->eigenvalues.maxCoeff());
}

}  // namespace
}  // namespace gmcr::frontend
