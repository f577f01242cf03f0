#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "gmcr/localisation.hpp"
#include "gmcr/metrics.hpp"
#include "synthetic/town/lidar.hpp"

namespace gmcr {
namespace {

using synthetic::Random;

/// A town of two by two blocks, a drive through it, and scans of another day.
class LocaliseScan : public ::testing::Test {
 protected:
  struct Taken {
    Points scan;
    Similarity map_from_scan;
  };

  static synthetic::Town town(std::uint64_t seed, std::uint64_t cars_seed) {
    synthetic::TownOptions options;
    options.extent = 100;
    options.block = 50;
    options.seed = seed;
    options.cars_seed = cars_seed;
    return make_town(options);
  }

  static void SetUpTestSuite() {
    points_ = new Points(map_of(town(1, 1), 20, 0.2, 1));
    FrontendOptions frontend;
    frontend.voxel_size = 0.5;
    map_ = new PreparedMap(*points_, frontend);
  }
  static void TearDownTestSuite() {
    delete map_;
    delete points_;
  }

  static Taken take(int num_rings, std::uint64_t seed, std::uint64_t town_seed = 1) {
    const synthetic::Town scanned = town(town_seed, 2);
    Random random(seed);
    const Similarity pose = sensor_at(random_place(scanned, random), 2, random);
    synthetic::Lidar lidar = synthetic::lidar_of(num_rings);
    lidar.num_columns = 900;
    return {scan(synthetic::RayCaster(scanned), pose, lidar, seed), pose};
  }

  static double metres(const CloudResult& result, const Taken& taken) {
    return (result.registration.target_from_source.translation - taken.map_from_scan.translation)
        .norm();
  }
  static double degrees(const CloudResult& result, const Taken& taken) {
    return rotation_error_deg(result.registration.target_from_source.rotation,
                              taken.map_from_scan.rotation);
  }

  static Points* points_;
  static PreparedMap* map_;
};

Points* LocaliseScan::points_ = nullptr;
PreparedMap* LocaliseScan::map_ = nullptr;

TEST_F(LocaliseScan, FindsScansOfSixteenThirtyTwoAndSixtyFourRingsAndTrustsThem) {
  for (const int rings : {16, 32, 64}) {
    for (const std::uint64_t seed : {1u, 2u}) {
      const Taken taken = take(rings, seed);
      const CloudResult result = localise_scan(taken.scan, *map_);
      ASSERT_EQ(result.registration.status, Status::Ok);
      EXPECT_LT(metres(result, taken), 0.1) << rings << " rings";
      EXPECT_LT(degrees(result, taken), 0.2);
      EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
      EXPECT_TRUE(result.rivals.empty());
      EXPECT_EQ(result.num_source_points, taken.scan.cols());
      EXPECT_GT(result.fitness, 0.6);
      EXPECT_LE(result.registration.inliers.size(), 1000u);
      EXPECT_GT(result.registration.inliers.size(), 900u);
      EXPECT_TRUE(result.registration.covariance);
      EXPECT_TRUE(result.refinement.is_applied);
    }
  }
}

TEST_F(LocaliseScan, DoesNotTrustScansOfAnotherTown) {
  for (const int rings : {16, 32, 64}) {
    const CloudResult result = localise_scan(take(rings, 3, 9).scan, *map_);
    EXPECT_NE(result.verdict, Verdict::Trusted) << result.verdict_reason;
  }
}

TEST_F(LocaliseScan, NamesTheOtherPlaceOfATownThatIsThereTwice) {
  Points twice(3, 2 * points_->cols());
  twice << *points_, points_->colwise() + Eigen::Vector3d(500, 40, 0);
  FrontendOptions frontend;
  frontend.voxel_size = 0.5;
  const PreparedMap map(twice, frontend);
  const Taken taken = take(64, 1);
  const CloudResult result = localise_scan(taken.scan, map);
  EXPECT_EQ(result.verdict, Verdict::Doubtful) << result.verdict_reason;
  ASSERT_FALSE(result.rivals.empty());
  EXPECT_GT(result.rivals.front().overlap, 0.95);
  const Eigen::Vector3d apart = result.rivals.front().target_from_source.translation -
                                result.registration.target_from_source.translation;
  EXPECT_NEAR(apart.norm(), std::hypot(500, 40), 0.5);

  // an initial pose says which one
  Options options;
  options.initial_pose = InitialPose{taken.map_from_scan, std::numbers::pi, 30};
  options.initial_pose->target_from_source.translation += Eigen::Vector3d(510, 50, 0);
  const CloudResult second = localise_scan(taken.scan, map, {}, options);
  EXPECT_EQ(second.verdict, Verdict::Trusted) << second.verdict_reason;
  EXPECT_NEAR(metres(second, taken), std::hypot(500, 40), 0.2);
  EXPECT_TRUE(options.admit(second.registration.target_from_source));
}

TEST_F(LocaliseScan, GivesTheSameBitsForAnyNumberOfThreads) {
  const Taken taken = take(32, 4);
  Options one, four;
  one.num_threads = 1;
  four.num_threads = 4;
  const CloudResult a = localise_scan(taken.scan, *map_, {}, one);
  const CloudResult b = localise_scan(taken.scan, *map_, {}, four);
  EXPECT_EQ(a.registration.target_from_source.matrix(), b.registration.target_from_source.matrix());
  EXPECT_EQ(a.surfaces.source_share, b.surfaces.source_share);
  EXPECT_EQ(a.verdict_reason, b.verdict_reason);
  EXPECT_EQ(b.registration.diagnostics.num_threads, 4);
}

TEST_F(LocaliseScan, TakesGravityWhereTheScannerLiesOnItsSide) {
  Taken taken = take(32, 5);
  Similarity turn;
  turn.rotation = Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
  taken.scan = turn.apply(taken.scan);
  taken.map_from_scan = taken.map_from_scan * turn.inverse();
  EXPECT_NE(localise_scan(taken.scan, *map_).verdict, Verdict::Trusted);
  Options options;
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  options.gravity = GravityPrior{taken.map_from_scan.rotation.transpose() * down, down,
                                 5 * std::numbers::pi / 180};
  const CloudResult result = localise_scan(taken.scan, *map_, {}, options);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  EXPECT_LT(metres(result, taken), 0.1);
  options.gravity->max_tilt = 0.2 * std::numbers::pi / 180;  // less than the ground says
  const CloudResult closely = localise_scan(taken.scan, *map_, {}, options);
  EXPECT_LT(metres(closely, taken), 0.1);
  EXPECT_TRUE(options.admit(closely.registration.target_from_source));
  options.gravity->target = Eigen::Vector3d::UnitX();
  EXPECT_THROW(localise_scan(taken.scan, *map_, {}, options), InvalidOption);
}

TEST_F(LocaliseScan, TakesAScaleAndAViewpoint) {
  Taken taken = take(32, 6);
  const Eigen::Vector3d viewpoint(2000, -3000, 500);  // millimetres
  taken.scan = (1000 * taken.scan).colwise() + viewpoint;
  Options options;
  options.scale = 1e-3;
  FrontendOptions frontend;
  frontend.source_viewpoint = viewpoint;
  const CloudResult result = localise_scan(taken.scan, *map_, frontend, options);
  const Similarity& pose = result.registration.target_from_source;
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  EXPECT_EQ(pose.scale, 1e-3);
  EXPECT_LT((pose * viewpoint - taken.map_from_scan.translation).norm(), 0.1);
}

TEST_F(LocaliseScan, IsTheSamePlaceInAMapFarFromTheOrigin) {
  const Taken taken = take(32, 7);
  const Eigen::Vector3d far(4e5, 5e6, 300);
  FrontendOptions frontend;
  frontend.voxel_size = 0.5;
  const PreparedMap map(points_->colwise() + far, frontend);
  const CloudResult result = localise_scan(taken.scan, map);
  EXPECT_EQ(result.verdict, Verdict::Trusted);
  EXPECT_LT(
      (result.registration.target_from_source.translation - far - taken.map_from_scan.translation)
          .norm(),
      0.1);
}

TEST_F(LocaliseScan, OfTooFewPointsHasNoPose) {
  for (const Index count : {0, 1, 2, 3}) {
    const CloudResult result = localise_scan(Points::Random(3, count), *map_);
    EXPECT_EQ(result.registration.status, Status::TooFewCorrespondences);
    EXPECT_EQ(result.verdict, Verdict::Untrusted);
    EXPECT_FALSE(result.verdict_reason.empty());
  }
}

TEST_F(LocaliseScan, OfGroundAloneIsNotTrusted) {
  Random random(1);
  Points ground(3, 5000);
  for (Index i = 0; i < ground.cols(); ++i) {
    ground.col(i) << random.uniform(-20, 20), random.uniform(-20, 20), -1.8;
  }
  EXPECT_EQ(localise_scan(ground, *map_).verdict, Verdict::Untrusted);
}

TEST_F(LocaliseScan, EndsWhenTheTimeIsUpOrTheCallerStops) {
  const Taken taken = take(64, 1);
  Options options;
  options.time_limit = 1e-3;
  const CloudResult late = localise_scan(taken.scan, *map_, {}, options);
  EXPECT_FALSE(late.registration.diagnostics.limits_hit.empty());
  options.time_limit = 60;
  options.progress = [](const Progress&) { return false; };
  const CloudResult stopped = localise_scan(taken.scan, *map_, {}, options);
  ASSERT_EQ(stopped.registration.diagnostics.limits_hit.size(), 1u);
  EXPECT_EQ(stopped.registration.diagnostics.limits_hit.front().limit, Limit::Stopped);
  EXPECT_EQ(stopped.registration.status, Status::NoConsensus);
}

TEST_F(LocaliseScan, RefusesWhatBreaksItsContract) {
  const Points scan = Points::Random(3, 100);
  Points with_nan = scan;
  with_nan(1, 7) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(localise_scan(with_nan, *map_), std::invalid_argument);
  Options options;
  options.scale_mode = ScaleMode::Estimated;
  EXPECT_THROW(localise_scan(scan, *map_, {}, options), InvalidOption);
  options = {};
  options.noise_bounds = {1, 2};
  EXPECT_THROW(localise_scan(scan, *map_, {}, options), std::invalid_argument);
}

TEST(PreparedMap, RefusesNoPointsNaNNoDirectionAndWhatSpreadsTooWide) {
  const Points points = 100 * Points::Random(3, 1000);
  EXPECT_THROW(PreparedMap(Points(3, 0)), std::invalid_argument);
  Points with_nan = points;
  with_nan(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(PreparedMap{with_nan}, std::invalid_argument);
  EXPECT_THROW(PreparedMap(points, {}, Eigen::Vector3d::Zero()), InvalidOption);
  FrontendOptions fine;
  fine.voxel_size = 1e-3;
  EXPECT_THROW(PreparedMap(points, fine), std::invalid_argument);
}

TEST(PreparedMap, OfOneOrRepeatedPointsFindsNothing) {
  for (const Index count : {1, 2, 3, 50}) {
    const PreparedMap map(Points::Constant(3, count, 7));
    const CloudResult result = localise_scan(10 * Points::Random(3, 500), map);
    EXPECT_EQ(result.verdict, Verdict::Untrusted);
  }
}

TEST_F(LocaliseScan, GivesTheSamePoseWithAMapFromAFile) {
  const Taken taken = take(32, 1);
  const std::string bytes = map_->to_bytes();
  const PreparedMap again = PreparedMap::from_bytes(bytes);
  EXPECT_EQ(again.voxel_size(), map_->voxel_size());
  EXPECT_EQ(again.points(), map_->points());
  const CloudResult of_file = localise_scan(taken.scan, again);
  EXPECT_EQ(of_file.registration.target_from_source.matrix(),
            localise_scan(taken.scan, *map_).registration.target_from_source.matrix());
  EXPECT_EQ(of_file.num_target_points, points_->cols());
  EXPECT_GT(of_file.num_target_points, again.points().cols());
  std::string changed = bytes;
  changed.back() = static_cast<char>(changed.back() ^ 1);
  EXPECT_THROW(PreparedMap::from_bytes(changed), std::invalid_argument);
}

TEST(PreparedMap, ChoosesAVoxelOfAboutSixteenPoints) {
  Random random(1);
  Points plane(3, 40000);
  for (Index i = 0; i < plane.cols(); ++i) {
    plane.col(i) << random.uniform(0, 20), random.uniform(0, 20), 0;
  }
  EXPECT_NEAR(PreparedMap(plane).voxel_size(), 0.4, 0.1);  // 100 points a square metre
}

}  // namespace
}  // namespace gmcr
