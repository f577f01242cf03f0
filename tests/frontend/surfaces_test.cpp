#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "frontend/alignment/surface_fit.hpp"
#include "frontend/cloud_notes.hpp"
#include "frontend/judgement/free_space.hpp"
#include "frontend/judgement/surface_judge.hpp"
#include "frontend/judgement/verdict.hpp"
#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::some_motion;

/// Points of rectangles of unit density, each by a corner and two edges, with noise of 2 mm.
Points rectangles(const std::vector<std::array<Eigen::Vector3d, 3>>& sides, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> share(0, 1);
  std::normal_distribution<double> noise(0, 0.002);
  constexpr Index kEach = 4000;
  Points points(3, kEach * static_cast<Index>(sides.size()));
  for (std::size_t k = 0; k < sides.size(); ++k) {
    for (Index i = 0; i < kEach; ++i) {
      const double u = share(generator), v = share(generator);
      points.col(static_cast<Index>(k) * kEach + i) =
          sides[k][0] + u * sides[k][1] + v * sides[k][2] +
          Eigen::Vector3d::NullaryExpr([&] { return noise(generator); });
    }
  }
  return points;
}

using Eigen::Vector3d;
const std::array<Vector3d, 3> kFloor{Vector3d(0, 0, 0), Vector3d(3, 0, 0), Vector3d(0, 3, 0)};
const std::array<Vector3d, 3> kWall{Vector3d(0, 0, 0), Vector3d(3, 0, 0), Vector3d(0, 0, 3)};
const std::array<Vector3d, 3> kOtherWall{Vector3d(0, 0, 0), Vector3d(0, 3, 0), Vector3d(0, 0, 3)};

SurfaceFit fit_of(const std::vector<std::array<Vector3d, 3>>& sides, const Similarity& pose) {
  CentredPair pair(voxel_grid(rectangles(sides, 1), 0.1), voxel_grid(rectangles(sides, 2), 0.1),
                   0.1, 0.1, 2);
  return measure_surfaces(pair, pose, 0.1, 2500, 2);
}

TEST(SurfaceFit, OfACornerLeavesNothingOpen) {
  const SurfaceFit fit = fit_of({kFloor, kWall, kOtherWall}, {});
  EXPECT_TRUE(fit.weak_directions.empty());
  EXPECT_GT(fit.source_share, 0.9);
  EXPECT_GT(fit.target_share, 0.9);
  EXPECT_GT(fit.agreement, 0.9);
  EXPECT_LT(fit.noise, 0.02);
}

TEST(SurfaceFit, OfAnEdgeLeavesTheShiftAlongItOpen) {
  const SurfaceFit fit = fit_of({kFloor, kWall}, {});
  ASSERT_EQ(fit.weak_directions.size(), 1u);
  EXPECT_GT(std::abs(fit.weak_directions[0].shift.x()), 0.99);
  EXPECT_TRUE(fit.weak_directions[0].turn.isZero(0));
}

TEST(SurfaceFit, OfAPlaneLeavesTwoShiftsAndATurnOpen) {
  const SurfaceFit fit = fit_of({kFloor}, {});
  ASSERT_EQ(fit.weak_directions.size(), 3u);
  int num_turns = 0;
  for (const WeakDirection& direction : fit.weak_directions) {
    const bool is_turn = !direction.turn.isZero(0);
    num_turns += is_turn;
    EXPECT_GT(is_turn ? std::abs(direction.turn.z()) : direction.shift.head<2>().norm(), 0.99);
  }
  EXPECT_EQ(num_turns, 1);
}

TEST(SurfaceFit, IsLessWhereThePoseIsOff) {
  Similarity off;
  off.translation = {0.3, 0.2, 0.25};
  const std::vector<std::array<Vector3d, 3>> corner{kFloor, kWall, kOtherWall};
  EXPECT_LT(fit_of(corner, off).overlap(), 0.5 * fit_of(corner, {}).overlap());
}

/// A result of so many inliers whose surfaces meet well.
CloudResult good_result() {
  CloudResult result;
  result.registration.status = Status::Ok;
  result.registration.inliers.resize(100);
  result.matches.source = Points::Zero(3, 200);
  result.voxels.target_voxel_size = 0.1;
  result.distinct_evidence = 20;
  result.fitness = result.target_fitness = 0.8;
  result.surfaces = {0.7, 0.7, 0.9, 0.01, {}};
  return result;
}

TEST(Verdict, IsOnlyAsGoodAsTheWorstOfMatchesAndSurfaces) {
  CloudResult good = good_result();
  judge(good);
  EXPECT_EQ(good.verdict, Verdict::Trusted) << good.verdict_reason;
  const auto verdict_after = [](const std::function<void(CloudResult&)>& spoil) {
    CloudResult result = good_result();
    spoil(result);
    judge(result);
    return std::pair(result.verdict, result.verdict_reason);
  };
  WeakDirection shift;
  shift.shift = Vector3d::UnitX();
  const auto edge = verdict_after([&](auto& r) { r.surfaces.weak_directions = {shift}; });
  EXPECT_EQ(edge.first, Verdict::Doubtful);
  EXPECT_NE(edge.second.find("a shift along (1, 0, 0)"), std::string::npos) << edge.second;
  const auto plane = verdict_after([&](auto& r) {
    r.surfaces.weak_directions = {shift, shift, shift};
  });
  EXPECT_EQ(plane.first, Verdict::Untrusted);
  const auto rival = verdict_after([](auto& r) { r.rivals = {{Similarity{}, 0.95}}; });
  EXPECT_EQ(rival.first, Verdict::Doubtful);
  EXPECT_NE(rival.second.find("ambiguous"), std::string::npos);
  EXPECT_EQ(verdict_after([](auto& r) { r.surfaces.agreement = 0.3; }).first, Verdict::Doubtful);
  EXPECT_EQ(verdict_after([](auto& r) { r.surfaces.noise = 0.05; }).first, Verdict::Doubtful);
  EXPECT_EQ(verdict_after([](auto& r) { r.registration.inliers.resize(5); }).first,
            Verdict::Untrusted);
}

/// Verdict on so many inliers.
Verdict verdict_on(std::size_t num_inliers, int num_radii, bool found_by_turning = false) {
  CloudResult result = good_result();
  result.registration.inliers.resize(num_inliers);
  result.matches.num_radii = num_radii;
  result.found_by_turning = found_by_turning;
  judge(result);
  return result.verdict;
}

TEST(Verdict, AsksForTwiceAsManyOfMatchesAtTwoRadii) {
  EXPECT_EQ(verdict_on(30, 1), Verdict::Trusted);
  EXPECT_EQ(verdict_on(59, 2), Verdict::Doubtful);
  EXPECT_EQ(verdict_on(60, 2), Verdict::Trusted);
  EXPECT_EQ(verdict_on(12, 1), Verdict::Doubtful);
  EXPECT_EQ(verdict_on(23, 2), Verdict::Untrusted);
}

TEST(Verdict, DoubtsWithoutMatchesWhatTurningFound) {
  EXPECT_EQ(verdict_on(3, 1, true), Verdict::Doubtful);
  CloudResult turned = good_result();
  turned.registration.inliers.resize(3);
  turned.found_by_turning = true;
  judge(turned);
  const std::string& reason = turned.verdict_reason;
  EXPECT_NE(reason.find("found by its surface"), std::string::npos) << reason;
  EXPECT_EQ(reason.find("matches agree"), std::string::npos) << reason;
  EXPECT_EQ(verdict_on(3, 1, false), Verdict::Untrusted);
}

TEST(Verdict, TrustsWithoutMatchesWhatCoversAViewLikeNoOtherPoseAndNoMirrorImage) {
  CloudResult turned = good_result();
  turned.registration.inliers.resize(3);
  turned.found_by_turning = true;
  judge(turned);
  EXPECT_EQ(turned.verdict, Verdict::Doubtful) << turned.verdict_reason;
  EXPECT_TRUE(awaits_mirrored(turned));
  turned.mirrored_is_worse = true;
  judge(turned);
  EXPECT_EQ(turned.verdict, Verdict::Trusted) << turned.verdict_reason;
  turned.rivals = {{Similarity{}, 0.8}};
  judge(turned);
  EXPECT_EQ(turned.verdict, Verdict::Doubtful) << turned.verdict_reason;
  turned.rivals.clear();
  turned.surfaces.target_share = 0.6;
  judge(turned);
  EXPECT_EQ(turned.verdict, Verdict::Doubtful) << turned.verdict_reason;
  EXPECT_FALSE(awaits_mirrored(turned));
}

TEST(Verdict, AllowsForTheNoiseOfASensorWhereTheMirroredSourceIsWorse) {
  CloudResult result = good_result();
  result.surfaces.noise = 0.022;
  judge(result);
  EXPECT_EQ(result.verdict, Verdict::Doubtful);
  EXPECT_TRUE(awaits_mirrored(result));
  result.mirrored_is_worse = true;
  judge(result);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  result.surfaces.noise = 0.026;
  judge(result);
  EXPECT_EQ(result.verdict, Verdict::Doubtful);
  result = good_result();
  EXPECT_FALSE(awaits_mirrored(result));
  result.surfaces.noise = 0.022;
  result.rivals = {{Similarity{}, 0.95}};
  EXPECT_FALSE(awaits_mirrored(result));
}

TEST(SurfaceJudge, TurnsThePoseByHalfAboutItsAxesAndThoseOfItsNormals) {
  const Points points = voxel_grid(bumpy_sphere(5000, 1), 0.1);
  const auto pair = std::make_shared<CentredPair>(points, some_motion().apply(points), 0.1, 0.1, 2);
  const Options options;
  const SurfaceJudge judge(pair, 0.1, options);
  const auto turned = judge.half_turns(some_motion());
  ASSERT_EQ(turned.size(), 6u);
  for (const Similarity& pose : turned) {
    EXPECT_NEAR(rotation_error_deg(pose.rotation, some_motion().rotation), 180, 1e-6);
    EXPECT_TRUE(judge.are_distinct(pose, some_motion()));
    EXPECT_FALSE(judge.are_distinct(pose, pose));
  }
}

const std::array<Vector3d, 3> kBack{Vector3d(-2, -2, 5), Vector3d(4, 0, 0), Vector3d(0, 4, 0)};
const std::array<Vector3d, 3> kPlate{Vector3d(-0.5, -0.5, 3), Vector3d(1, 0, 0), Vector3d(0, 1, 0)};

/// A wall 5 m before the sensor, and a plate 2 m before it, with what that hides left out.
Points wall_and_plate(unsigned seed) {
  const Points points = rectangles({kBack, kBack, kPlate}, seed);
  std::vector<Index> seen;
  for (Index i = 0; i < points.cols(); ++i) {
    if (points(2, i) < 4 || points.col(i).head<2>().cwiseAbs().maxCoeff() > 0.85) seen.push_back(i);
  }
  return points(Eigen::all, seen);
}

TEST(FreeSpace, IsNotFilledByWhatTheOtherSensorShouldHaveSeen) {
  const Points both = wall_and_plate(1), wall = rectangles({kBack, kBack}, 2);
  const auto contradiction_of = [](const Points& source, const Points& target, bool knows_views) {
    CentredPair pair(voxel_grid(source, 0.1), voxel_grid(target, 0.1), 0.1, 0.1, 2);
    if (knows_views) {
      pair.source_view = view_from(Vector3d::Zero(), source);
      pair.target_view = view_from(Vector3d::Zero(), target);
      EXPECT_TRUE(pair.source_view && pair.target_view);
    }
    return measure_contradiction(pair, {}, 0.1, 2500, 2);
  };
  EXPECT_GT(contradiction_of(both, wall, true), 0.03);
  EXPECT_GT(contradiction_of(wall, both, true), 0.03);
  EXPECT_EQ(contradiction_of(wall, wall, true), 0);
  EXPECT_EQ(contradiction_of(both, wall_and_plate(3), true), 0);
  EXPECT_EQ(contradiction_of(both, wall, false), 0);
}

TEST(Verdict, DoubtsWhatTheSensorsSawThroughUnlessMatchesAreBeyondDoubt) {
  CloudResult result = good_result();
  result.surfaces.contradicted = 0.05;
  result.voxels.source_viewpoint = Vector3d::Zero();
  judge(result);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  result.voxels.target_viewpoint = Vector3d::Zero();
  judge(result);
  EXPECT_EQ(result.verdict, Verdict::Doubtful);
  EXPECT_NE(result.verdict_reason.find("5 % of a cloud lie where"), std::string::npos)
      << result.verdict_reason;
  result.distinct_evidence = 60;
  judge(result);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
  result.mirrored_is_better = true;
  judge(result);
  EXPECT_EQ(result.verdict, Verdict::Doubtful) << result.verdict_reason;
}

/// A room whose furniture stands along one wall, seen from `place`, in the frame of the sensor.
Points room_from(const Vector3d& place, unsigned seed) {
  const Vector3d x(6, 0, 0), y(0, 4, 0), z(0, 0, 2.5);
  const Vector3d size(1.5, 0.8, 1.2), corner(0.5, 0, 0);
  Points points =
      rectangles({{Vector3d::Zero(), x, y},
                  {Vector3d::Zero(), x, z},
                  {Vector3d::Zero(), y, z},
                  {y, x, z},
                  {x, y, z},
                  {corner + Vector3d(0, 0.8, 0), Vector3d(1.5, 0, 0), Vector3d(0, 0, 1.2)},
                  {corner + Vector3d(0, 0, 1.2), Vector3d(1.5, 0, 0), Vector3d(0, 0.8, 0)},
                  {corner + Vector3d(1.5, 0, 0), Vector3d(0, 0.8, 0), Vector3d(0, 0, 1.2)}},
                 seed);
  // what the cupboard hides: rays that enter its box before they end
  std::vector<Index> seen;
  for (Index i = 0; i < points.cols(); ++i) {
    const Vector3d ray = points.col(i) - place;
    const Eigen::Array3d a = (corner - place).array() / ray.array();
    const Eigen::Array3d b = (corner + size - place).array() / ray.array();
    const double enter = a.min(b).maxCoeff(), leave = a.max(b).minCoeff();
    if (!(enter < leave && enter > 0 && enter < 0.98)) seen.push_back(i);
  }
  return points(Eigen::all, seen).colwise() - place;
}

TEST(RegisterClouds, DoesNotTrustARoomThatIsTurnedByHalf) {
  const Vector3d from(2.5, 2.2, 1.3), to(3.4, 1.9, 1.2);
  const Points source = room_from(from, 1), target = room_from(to, 2);
  const CloudResult right = register_clouds(source, target);
  EXPECT_LT(mean_point_error(right.registration.target_from_source,
                             Similarity{1, Eigen::Matrix3d::Identity(), from - to}, source),
            0.1);
  EXPECT_LT(right.surfaces.contradicted, 0.01);
  // about the upright axis through the middle of the room
  Similarity half;
  half.rotation = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  half.translation = Vector3d(6, 4, 0) - to - half.rotation * -from;
  const CloudResult turned = refine_clouds(with_pose(right, half, {}), source, target);
  EXPECT_NE(turned.verdict, Verdict::Trusted) << turned.verdict_reason;
  EXPECT_GT(turned.surfaces.contradicted, 0.02);
}

/// A box without a top whose long sides have the same door every metre.
Points corridor(double begin, unsigned seed) {
  Points points = rectangles({{Vector3d(0, -1, 0), Vector3d(8, 0, 0), Vector3d(0, 2, 0)},
                              {Vector3d(0, -1, 0), Vector3d(8, 0, 0), Vector3d(0, 0, 2)},
                              {Vector3d(0, 1, 0), Vector3d(8, 0, 0), Vector3d(0, 0, 2)}},
                             seed);
  for (Index i = 0; i < points.cols(); ++i) {
    const bool is_door =
        points(2, i) > 0.1 && points(2, i) < 1.6 && std::fmod(points(0, i) + begin + 8, 2) < 0.8;
    if (is_door && points(1, i) > 0.9) points(1, i) += 0.3;
    if (is_door && points(1, i) < -0.9) points(1, i) -= 0.3;
  }
  return points;
}

TEST(RegisterClouds, OfACorridorThatRepeatsItselfIsNotTrusted) {
  const CloudResult result = register_clouds(corridor(0, 1), some_motion().apply(corridor(0.7, 2)));
  EXPECT_NE(result.verdict, Verdict::Trusted) << result.verdict_reason;
}

TEST(RegisterClouds, OfBareGroundIsUntrusted) {
  const std::vector<std::array<Vector3d, 3>> ground{kFloor};
  const CloudResult result =
      register_clouds(rectangles(ground, 1), some_motion().apply(rectangles(ground, 2)));
  EXPECT_EQ(result.verdict, Verdict::Untrusted) << result.verdict_reason;
}

TEST(RegisterClouds, FarFromTheOriginIsAsRightAsNearIt) {
  const Points source = bumpy_sphere(6000, 1);
  const Similarity motion = some_motion();
  const Points target = motion.apply(bumpy_sphere(6000, 2));
  for (const double offset : {1e3, 1e5, 1e7}) {
    const Vector3d from(offset, -offset, offset / 10), to(2 * offset, offset, 0);
    const CloudResult result = register_clouds(source.colwise() + from, target.colwise() + to);
    EXPECT_EQ(result.verdict, Verdict::Trusted) << offset << ": " << result.verdict_reason;
    const Points images =
        result.registration.target_from_source.apply(source.colwise() + from).colwise() - to;
    EXPECT_LT((images - motion.apply(source)).colwise().norm().mean(), 0.01) << offset;
    ASSERT_EQ(result.notes.size(), 2u);
    EXPECT_NE(result.notes[0].find("viewpoint"), std::string::npos);
  }
}

TEST(RegisterClouds, CountsARepeatedPointOnceAndSaysSo) {
  const Points source = bumpy_sphere(5000, 1);
  const Points target = some_motion().apply(bumpy_sphere(5000, 2));
  Points padded(3, 50000);
  padded << Points::Zero(3, 45000), source;
  Points once(3, 5001);
  once << Points::Zero(3, 1), source;
  const CloudResult result = register_clouds(padded, target);
  const CloudResult expected = register_clouds(once, target);
  EXPECT_EQ(result.registration.target_from_source.matrix(),
            expected.registration.target_from_source.matrix());
  EXPECT_EQ(result.num_source_points, 50000);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("45000 of the 50000 points of the source"), std::string::npos)
      << result.notes[0];
}

TEST(RegisterClouds, SaysThatACloudIsLeftHanded) {
  const Points source = bumpy_sphere(6000, 1);
  Points mirrored = some_motion().apply(bumpy_sphere(6000, 2));
  mirrored.row(1) *= -1;
  FrontendOptions frontend;
  frontend.orientation = NormalOrientation::Outward;
  const CloudResult result = register_clouds(source, mirrored, frontend);
  EXPECT_NE(result.verdict, Verdict::Trusted);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("left-handed"), std::string::npos);
}

TEST(RegisterClouds, TakesTheRefinedPriorForAHypothesis) {
  const Points source = corridor(0, 1);
  const Points target = some_motion().apply(corridor(0.7, 2));
  Options options;
  InitialPose prior;
  prior.target_from_source = some_motion();
  prior.target_from_source.translation += some_motion().rotation * Vector3d(-0.7, 0.1, 0);
  prior.max_rotation = 0.2;
  prior.max_translation = 0.5;
  options.initial_pose = prior;
  const CloudResult result = register_clouds(source, target, {}, options);
  EXPECT_TRUE(options.admit(result.registration.target_from_source));
  EXPECT_GT(result.surfaces.overlap(), 1.5);
}

TEST(RegisterClouds, TakesTheOneOfManyAliasesThatThePriorSays) {
  const Points source = corridor(0, 1);
  const Points target = some_motion().apply(corridor(0.7, 2));
  for (const double off : {-2.7, -0.7, 1.3}) {  // doors come again every 2 m
    Similarity truth = some_motion();
    truth.translation += some_motion().rotation * Vector3d(off, 0, 0);
    Options options;
    InitialPose prior;
    prior.target_from_source = truth;
    prior.target_from_source.translation += some_motion().rotation * Vector3d(0.5, 0.2, 0.1);
    prior.target_from_source.rotation =
        Eigen::AngleAxisd(0.1, Vector3d::UnitZ()).toRotationMatrix() * truth.rotation;
    prior.max_rotation = 0.2;
    prior.max_translation = 0.8;
    options.initial_pose = prior;
    const CloudResult result = register_clouds(source, target, {}, options);
    const Points error = result.registration.target_from_source.apply(source) - truth.apply(source);
    EXPECT_LT(error.colwise().norm().mean(), 0.05) << off;
  }
}

TEST(RefineClouds, LooksAtTheHalfTurnsOfThePose) {
  const Vector3d along(3, 0, 0), across(0, 2, 0), up(0, 0, 1), corner(0, 0, 0);
  const std::vector<std::array<Vector3d, 3>> open_box{{corner, along, across},
                                                      {corner, along, up},
                                                      {across, along, up},
                                                      {corner, across, up},
                                                      {along, across, up}};
  const Points source = rectangles(open_box, 1);
  const Points target = some_motion().apply(rectangles(open_box, 2));
  FrontendOptions once;
  once.max_attempts = 1;
  CloudResult result = with_pose(register_clouds(source, target, once), some_motion(), {});
  result.rivals.clear();
  result = refine_clouds(result, source, target);
  EXPECT_FALSE(result.rivals.empty());
  EXPECT_NE(result.verdict_reason.find("ambiguous"), std::string::npos) << result.verdict_reason;
}

TEST(RegisterClouds, EndsWithTheTimeLimitWhereTheMatchingTakesLong) {
  Options options;
  options.time_limit = 0.05;
  options.num_threads = 2;
  FrontendOptions frontend;
  frontend.voxel_size = 0.005;
  const CloudResult result = register_clouds(
      bumpy_sphere(40000, 1), some_motion().apply(bumpy_sphere(40000, 2)), frontend, options);
  EXPECT_LT(result.matches.share_compared, 1);
  EXPECT_LT(result.registration.diagnostics.total_seconds, 30);
  const auto& hit = result.registration.diagnostics.limits_hit;
  EXPECT_TRUE(std::any_of(hit.begin(), hit.end(), [](const LimitHit& limit) {
    return limit.sentence.find("ended the matching") != std::string::npos;
  }));
}

TEST(CloudNotes, NameUnitsAndSteps) {
  const Points source = bumpy_sphere(5000, 1);
  const auto noted = [&](const PointsRef& a, const PointsRef& b) {
    CloudScales from(a), to(b);
    CloudResult result;
    result.verdict = Verdict::Trusted;
    result.voxels.source_voxel_size = result.voxels.target_voxel_size = 0.03;
    add_notes(result, from, to, {}, {}, {}, {});
    return result;
  };
  EXPECT_TRUE(noted(source, source).notes.empty());
  EXPECT_EQ(noted(source, source).verdict, Verdict::Trusted);
  const auto units = noted(1000 * source, source).notes;
  ASSERT_EQ(units.size(), 1u);
  EXPECT_NE(units[0].find("millimetres"), std::string::npos);
  const CloudResult coarse = noted(source, (source / 0.05).array().round().matrix() * 0.05);
  EXPECT_EQ(coarse.verdict, Verdict::Doubtful);
  const auto& steps = coarse.notes;
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_NE(steps[0].find("target come in steps of 0.05"), std::string::npos) << steps[0];
}

}  // namespace
}  // namespace gmcr::frontend
