#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "frontend/features/stage_clock.hpp"
#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::random_points;
using testing::some_motion;

/// Two samples of one surface, the second moved; models of a whole object.
struct Pair {
  Points source = bumpy_sphere(6000, 1);
  Similarity motion = some_motion();
  Points target = motion.apply(bumpy_sphere(6000, 2));
};

FrontendOptions outward(double voxel_size = 0) {
  FrontendOptions frontend;
  frontend.orientation = NormalOrientation::Outward;
  frontend.voxel_size = voxel_size;
  return frontend;
}

Index count_inliers(const CloudMatches& matches, const Similarity& motion, double bound) {
  return (motion.apply(matches.source) - matches.target)
      .colwise()
      .norm()
      .array()
      .
      operator<=(bound)
      .count();
}

bool equal(const CloudMatches& a, const CloudMatches& b) {
  return a.source_indices == b.source_indices && a.target_indices == b.target_indices &&
         a.source_voxels == b.source_voxels && a.target_voxels == b.target_voxels &&
         a.source == b.source && a.target == b.target;
}

TEST(MatchClouds, FindsTrueCorrespondencesOfAMovedSurface) {
  const Pair pair;
  const CloudMatches matches = match_clouds(pair.source, pair.target, outward());
  EXPECT_GT(count_inliers(matches, pair.motion, matches.noise_bound), 100);
}

TEST(MatchClouds, GivesThePointsOfTheIndices) {
  const Pair pair;
  const CloudMatches m = match_clouds(pair.source, pair.target, outward());
  ASSERT_GT(m.source.cols(), 0);
  EXPECT_EQ(m.source, m.source_voxels(Eigen::all, m.source_indices));
  EXPECT_EQ(m.target, m.target_voxels(Eigen::all, m.target_indices));
  EXPECT_TRUE(std::is_sorted(m.source_indices.begin(), m.source_indices.end()));
}

TEST(MatchClouds, ChoosesVoxelAndNoiseBoundFromTheSmallerCloud) {
  const Pair pair;
  const CloudMatches m = match_clouds(pair.source, 3 * pair.target, outward());
  EXPECT_EQ(m.source_voxel_size, m.target_voxel_size);
  EXPECT_NEAR(m.target_voxel_size, 0.015 * 2, 0.015);
  EXPECT_DOUBLE_EQ(m.noise_bound, 1.5 * m.target_voxel_size);
}

TEST(MatchClouds, HasOneVoxelSizeACloudWhereTheScaleIsUnknown) {
  const Pair pair;
  Options options;
  options.scale_mode = ScaleMode::Estimated;
  const CloudMatches m = match_clouds(pair.source, 10 * pair.target, outward(), options);
  EXPECT_NEAR(m.target_voxel_size / m.source_voxel_size, 10, 0.5);
  EXPECT_DOUBLE_EQ(m.noise_bound, 1.5 * m.target_voxel_size);
  Similarity truth = pair.motion;
  truth.scale *= 10;
  truth.translation *= 10;
  EXPECT_GT(count_inliers(m, truth, m.noise_bound), 50);
}

TEST(MatchClouds, ScalesTheSourceVoxelWithAKnownScale) {
  const Pair pair;
  Options options;
  options.scale = 0.25;
  const CloudMatches m = match_clouds(4 * pair.source, pair.target, outward(), options);
  EXPECT_DOUBLE_EQ(m.source_voxel_size, 4 * m.target_voxel_size);
  Similarity truth = pair.motion;
  truth.scale = 0.25;
  EXPECT_GT(count_inliers(m, truth, m.noise_bound), 100);
}

TEST(MatchClouds, IsTheSameInMillimetres) {
  const Pair pair;
  const CloudMatches metres = match_clouds(pair.source, pair.target, outward());
  const CloudMatches millimetres = match_clouds(1000 * pair.source, 1000 * pair.target, outward());
  EXPECT_NEAR(millimetres.noise_bound / metres.noise_bound, 1000, 1e-6);
  EXPECT_NEAR(static_cast<double>(millimetres.source.cols()),
              static_cast<double>(metres.source.cols()), 0.1 * metres.source.cols());
}

TEST(MatchClouds, IsTheSameFarFromTheOrigin) {
  const Pair pair;
  const Eigen::Vector3d offset(1e6, -1e6, 1e6);
  const CloudMatches near = match_clouds(pair.source, pair.target, outward());
  const CloudMatches far =
      match_clouds(pair.source.colwise() + offset, pair.target.colwise() - offset, outward());
  Similarity truth;
  truth.translation = -offset;
  truth = truth * pair.motion;
  truth.translation -= pair.motion.rotation * offset;
  EXPECT_GT(count_inliers(far, truth, far.noise_bound),
            0.8 * count_inliers(near, pair.motion, near.noise_bound));
}

TEST(MatchClouds, DoesNotDependOnTheNumberOfThreads) {
  const Pair pair;
  Options options;
  options.num_threads = 1;
  const CloudMatches one = match_clouds(pair.source, pair.target, outward(), options);
  for (const int threads : {2, 3, 0}) {
    options.num_threads = threads;
    EXPECT_TRUE(equal(match_clouds(pair.source, pair.target, outward(), options), one));
  }
}

TEST(MatchClouds, ReportsItsStages) {
  const Pair pair;
  const CloudMatches m = match_clouds(pair.source, pair.target, outward());
  ASSERT_EQ(m.stages.size(), 4u);
  EXPECT_EQ(m.stages[0].name, "voxel");
  EXPECT_EQ(m.stages[1].name, "normals");
  EXPECT_EQ(m.stages[2].name, "features");
  EXPECT_EQ(m.stages[3].name, "matching");
}

TEST(MatchClouds, EachOptionChangesTheMatches) {
  const Pair pair;
  const auto match = [&](const FrontendOptions& f) {
    return match_clouds(pair.source, pair.target, f);
  };
  const FrontendOptions base = outward(0.06);
  const CloudMatches reference = match(base);
  const auto changed = [&](auto change) {
    FrontendOptions f = base;
    change(f);
    return !equal(match(f), reference);
  };
  EXPECT_TRUE(changed([](auto& f) { f.voxel_size = 0.08; }));
  EXPECT_TRUE(changed([](auto& f) { f.source_voxel_size = 0.05; }));
  EXPECT_TRUE(changed([](auto& f) { f.normal_radius = 3; }));
  EXPECT_TRUE(changed([](auto& f) { f.feature_radius = 4; }));
  EXPECT_TRUE(changed([](auto& f) { f.orientation = NormalOrientation::TowardViewpoint; }));
  EXPECT_TRUE(changed([](auto& f) { f.mutual = false; }));
  EXPECT_TRUE(changed([](auto& f) { f.max_ratio = 0.9; }));
  FrontendOptions one_way = base;
  one_way.mutual = false;
  Options one_to_one;
  one_to_one.one_to_one = true;
  EXPECT_FALSE(equal(match_clouds(pair.source, pair.target, one_way, one_to_one), match(one_way)));
  FrontendOptions seen = base;
  seen.orientation = NormalOrientation::TowardViewpoint;
  FrontendOptions from_elsewhere = seen;
  from_elsewhere.source_viewpoint = {5, 5, 5};
  EXPECT_FALSE(equal(match(from_elsewhere), match(seen)));
  from_elsewhere = seen;
  from_elsewhere.target_viewpoint = {5, 5, 5};
  EXPECT_FALSE(equal(match(from_elsewhere), match(seen)));
  FrontendOptions loose = base;
  loose.noise_bound_voxels = 2;
  EXPECT_DOUBLE_EQ(match(loose).noise_bound, 0.12);
  Options given;
  given.noise_bound = 0.5;
  EXPECT_DOUBLE_EQ(match_clouds(pair.source, pair.target, base, given).noise_bound, 0.5);
}

TEST(MatchClouds, OfCloudsWithoutASurfaceAreNone) {
  const Points whole = bumpy_sphere(500, 1);
  Points line = Points::Zero(3, 100);
  line.row(0).setLinSpaced(0, 1);
  for (const Points& cloud :
       {Points(3, 0), Points(random_points(1, 1)), Points(random_points(2, 1)),
        Points(Points::Constant(3, 100, 4.0)), line}) {
    EXPECT_EQ(match_clouds(cloud, whole).source.cols(), 0);
    EXPECT_EQ(match_clouds(whole, cloud).source.cols(), 0);
    EXPECT_EQ(match_clouds(cloud, cloud).source.cols(), 0);
  }
  EXPECT_EQ(match_clouds(whole, whole, outward(100)).source.cols(), 0);
}

TEST(MatchClouds, OfAVoxelTooSmallToNumberThrows) {
  const Points whole = bumpy_sphere(500, 1);
  EXPECT_THROW(match_clouds(whole, whole, outward(1e-19)), std::invalid_argument);
}

TEST(StageClock, SharesALapAmongStagesThatRanSideBySide) {
  std::vector<StageTime> stages;
  const std::vector<StageTime> one{{"a", 3}, {"b", 1}}, other{{"a", 4}}, none;
  StageClock clock(stages);
  clock.lap({none, none});
  EXPECT_TRUE(stages.empty());
  clock.lap({one, other});
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_GT(stages[1].seconds, 0);
  EXPECT_NEAR(stages[0].seconds, 7 * stages[1].seconds, 1e-9);
}

}  // namespace
}  // namespace gmcr::frontend
