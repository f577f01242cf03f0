#include "frontend/unknown_scale.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "frontend/cloud_pair.hpp"
#include "frontend/shapes.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::some_motion;

Options with_unknown_scale() {
  Options options;
  options.scale_mode = ScaleMode::Estimated;
  return options;
}

/// A shape, and a third of it at three times the size: by their extents the scale is another.
struct PartOfAShape {
  PartOfAShape() {
    motion = some_motion(3);
    const Points whole = bumpy_sphere(8000, 2);
    std::vector<Index> part;
    for (Index i = 0; i < whole.cols(); ++i) {
      if (whole(0, i) > 0.3) part.push_back(i);
    }
    target = motion.apply(whole(Eigen::all, part));
  }
  Points source = bumpy_sphere(8000, 1);
  Points target;
  Similarity motion;
};

TEST(UnknownScale, GivesMatchesAtVoxelsOfOneSize) {
  const PartOfAShape pair;
  FrontendOptions frontend;
  frontend.orientation = NormalOrientation::Outward;
  const CloudResult result =
      register_clouds(pair.source, pair.target, frontend, with_unknown_scale());
  ASSERT_EQ(result.registration.status, Status::Ok);
  const double scale = result.registration.target_from_source.scale;
  EXPECT_LT(scale_error(scale, 3), 0.01);
  EXPECT_NEAR(result.matches.target_voxel_size / result.matches.source_voxel_size, 3, 0.15);
  // by their own extents they are of another size
  const CloudMatches apart = match_clouds(pair.source, pair.target, frontend, with_unknown_scale());
  EXPECT_LT(apart.target_voxel_size / apart.source_voxel_size, 2.85);
  EXPECT_EQ(result.verdict, Verdict::Trusted) << result.verdict_reason;
}

TEST(UnknownScale, IsSearchedNearAGuessAndSaysSo) {
  const PartOfAShape pair;
  FrontendOptions frontend;
  frontend.orientation = NormalOrientation::Outward;
  Options options = with_unknown_scale();
  const ScaleRange narrow = register_clouds(pair.source, pair.target, frontend, options)
                                .registration.diagnostics.scale_range;
  EXPECT_LT(narrow.max / narrow.min, 1.22);
  options.num_hypotheses = 2;
  const CloudResult several = register_clouds(pair.source, pair.target, frontend, options);
  const ScaleRange wide = several.registration.diagnostics.scale_range;
  EXPECT_GT(wide.max / wide.min, 2);
}

TEST(UnknownScale, IsSoughtInTheRangeOfTheCaller) {
  const PartOfAShape pair;
  FrontendOptions frontend;
  frontend.orientation = NormalOrientation::Outward;
  Options options = with_unknown_scale();
  options.scale_range = ScaleRange{2.5, 3.05};
  const CloudResult result = register_clouds(pair.source, pair.target, frontend, options);
  ASSERT_EQ(result.registration.status, Status::Ok);
  EXPECT_LE(result.registration.diagnostics.scale_range.max, 3.05);
  EXPECT_LE(result.registration.target_from_source.scale, 3.05);
}

TEST(UnknownScale, GivesTheSameBitsForAnyNumberOfThreads) {
  const PartOfAShape pair;
  Options options = with_unknown_scale();
  std::vector<CloudResult> results;
  for (const int threads : {1, 3}) {
    options.num_threads = threads;
    results.push_back(register_clouds(pair.source, pair.target, {}, options));
  }
  EXPECT_EQ(results[0].registration.target_from_source.matrix(),
            results[1].registration.target_from_source.matrix());
  EXPECT_EQ(results[0].registration.inliers, results[1].registration.inliers);
}

TEST(NarrowsScale, WhereNoProofAndNoOtherPosesAreAskedFor) {
  EXPECT_TRUE(narrows_scale(with_unknown_scale()));
  EXPECT_FALSE(narrows_scale({}));
  Options options = with_unknown_scale();
  options.certify = true;
  EXPECT_FALSE(narrows_scale(options));
  options = with_unknown_scale();
  options.num_hypotheses = 2;
  EXPECT_FALSE(narrows_scale(options));
  options = with_unknown_scale();
  options.method = Method::Paper;
  EXPECT_FALSE(narrows_scale(options));
}

TEST(ScalesAbout, StayWithinThoseOfTheCaller) {
  Options options = with_unknown_scale();
  EXPECT_DOUBLE_EQ(scales_about(2, options).max, 2.2);
  options.scale_range = ScaleRange{1.9, 2.05};
  EXPECT_EQ(scales_about(2, options).min, 1.9);
  EXPECT_EQ(scales_about(2, options).max, 2.05);
}

TEST(AtScale, LeavesGivenVoxelsAsTheyAre) {
  const Points points = bumpy_sphere(500, 1);
  const PointsRef view = points;
  CloudScales source(view), target(view);
  const double own = source.voxel_size();
  EXPECT_DOUBLE_EQ(at_scale({}, 0.5, source, target).voxel_size, 0.5 * own);
  EXPECT_DOUBLE_EQ(at_scale({}, 2, source, target).source_voxel_size, own / 2);
  FrontendOptions given;
  given.source_voxel_size = 0.1;
  EXPECT_DOUBLE_EQ(at_scale(given, 2, source, target).voxel_size, 0.2);
  given.voxel_size = 0.3;
  EXPECT_EQ(at_scale(given, 2, source, target).voxel_size, 0.3);
  EXPECT_EQ(at_scale(given, 2, source, target).source_voxel_size, 0.1);
}

TEST(ListSettings, TakesNormalsOfFurtherAttemptsFromWiderNeighbourhoods) {
  const Points points = bumpy_sphere(500, 1);
  const PointsRef view = points;
  const std::vector<FrontendSetting> settings = list_settings({}, {view, view});
  ASSERT_GT(settings.size(), 1u);
  EXPECT_EQ(settings.front().normal_factor, 1);
  for (std::size_t k = 1; k < settings.size(); ++k) EXPECT_GT(settings[k].normal_factor, 1);
}

TEST(MatchWith, KeepsTheNormalRadiusWithinTheFeatureRadius) {
  const Points points = bumpy_sphere(3000, 1), others = some_motion().apply(bumpy_sphere(3000, 2));
  const PointsRef from = points, to = others;
  CloudScales source(from), target(to);
  FrontendOptions frontend;
  FrontendSetting setting;
  const auto matches = [&](double factor) {
    setting.normal_factor = factor;
    return match_with(source, target, frontend, {}, setting).source_indices;
  };
  EXPECT_NE(matches(1), matches(1.5));
  frontend.normal_radius = frontend.feature_radius;
  EXPECT_EQ(matches(1), matches(1.5));
}

}  // namespace
}  // namespace gmcr::frontend
