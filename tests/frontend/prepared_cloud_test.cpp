#include "gmcr/prepared_cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "frontend/shapes.hpp"

namespace gmcr::frontend {
namespace {

using testing::bumpy_sphere;
using testing::some_motion;

/// Two samplings of one shape.
struct Pair {
  Points source = bumpy_sphere(6000, 1);
  Points target = some_motion().apply(bumpy_sphere(6000, 2));
  FrontendOptions frontend;

  Pair() { frontend.voxel_size = 0.06; }
};

void expect_equal(const CloudMatches& a, const CloudMatches& b) {
  EXPECT_GT(a.source.cols(), 10);
  EXPECT_EQ(a.source, b.source);
  EXPECT_EQ(a.target, b.target);
  EXPECT_EQ(a.source_indices, b.source_indices);
  EXPECT_EQ(a.target_indices, b.target_indices);
  EXPECT_EQ(a.source_voxels, b.source_voxels);
  EXPECT_EQ(a.target_voxel_size, b.target_voxel_size);
}

bool has_stage(const CloudMatches& matches, const std::string& name) {
  return std::any_of(matches.stages.begin(), matches.stages.end(),
                     [&](const StageTime& stage) { return stage.name == name; });
}

TEST(PreparedCloud, GivesTheMatchesOfItsPoints) {
  const Pair pair;
  const PreparedCloud source(pair.source, pair.frontend), target(pair.target, pair.frontend);
  expect_equal(match_clouds(source, target, pair.frontend),
               match_clouds(pair.source, pair.target, pair.frontend));
}

TEST(PreparedCloud, GivesTheMatchesOfItsPointsAtTheSizeOfBoth) {
  const Pair pair;
  const PreparedCloud source(pair.source), target(2 * pair.target);
  EXPECT_LT(source.voxel_size(), target.voxel_size());
  expect_equal(match_clouds(source, target), match_clouds(pair.source, 2 * pair.target));
}

TEST(PreparedCloud, GivesThePoseOfItsPoints) {
  const Pair pair;
  const PreparedCloud source(pair.source, pair.frontend), target(pair.target, pair.frontend);
  const CloudResult result = register_clouds(source, target, pair.frontend);
  const CloudResult expected = register_clouds(pair.source, pair.target, pair.frontend);
  EXPECT_EQ(result.registration.target_from_source.matrix(),
            expected.registration.target_from_source.matrix());
  EXPECT_EQ(result.verdict, expected.verdict);
  EXPECT_EQ(result.notes, expected.notes);
  EXPECT_EQ(result.num_source_points, 6000);
}

TEST(PreparedCloud, IsMadeOnce) {
  const Pair pair;
  const PreparedCloud source(pair.source, pair.frontend), target(pair.target, pair.frontend);
  const CloudMatches prepared = match_clouds(source, target, pair.frontend);
  EXPECT_FALSE(has_stage(prepared, "normals"));
  EXPECT_FALSE(has_stage(prepared, "features"));
  // another setting is made when it is first asked for, and then known
  FrontendOptions coarse = pair.frontend;
  coarse.voxel_size = 0.09;
  EXPECT_TRUE(has_stage(match_clouds(source, target, coarse), "features"));
  EXPECT_FALSE(has_stage(match_clouds(source, target, coarse), "features"));
}

TEST(PreparedCloud, OutlivesAFile) {
  const Pair pair;
  const PreparedCloud source(pair.source, pair.frontend), target(pair.target, pair.frontend);
  const std::string bytes = source.to_bytes();
  EXPECT_TRUE(PreparedCloud::is_prepared(bytes));
  const PreparedCloud again = PreparedCloud::from_bytes(bytes);
  EXPECT_EQ(again.to_bytes(), bytes);
  EXPECT_EQ(again.points(), source.points());
  EXPECT_EQ(again.voxel_size(), 0.06);
  const CloudMatches matches = match_clouds(again, target, pair.frontend);
  EXPECT_FALSE(has_stage(matches, "features"));
  expect_equal(matches, match_clouds(source, target, pair.frontend));
  // the other side of the normals, whose neighbourhoods the file does not hold
  FrontendOptions outward = pair.frontend;
  outward.orientation = NormalOrientation::Outward;
  expect_equal(match_clouds(again, target, outward), match_clouds(source, target, outward));
}

TEST(PreparedCloud, OfAFileThatDoesNotFitIsRefused) {
  FrontendOptions frontend;
  frontend.voxel_size = 0.3;
  frontend.source_viewpoint = {1, -2, 0.1};
  const std::string bytes = PreparedCloud(bumpy_sphere(200, 3), frontend).to_bytes();
  EXPECT_EQ(PreparedCloud::from_bytes(bytes).viewpoint(), frontend.source_viewpoint);
  const auto reason = [](const std::string& changed) -> std::string {
    try {
      PreparedCloud::from_bytes(changed);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  std::string newer = bytes;
  newer.replace(newer.find("cloud 1\n"), 7, "cloud 2");
  EXPECT_NE(reason(newer).find("version 2"), std::string::npos) << reason(newer);
  EXPECT_TRUE(PreparedCloud::is_prepared(newer));
  EXPECT_NE(reason("ply\n").find("it is none"), std::string::npos);
  EXPECT_NE(reason(bytes + "x").find("more follows"), std::string::npos);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 7) {
    EXPECT_NE(reason(bytes.substr(0, size)), "none") << size;
  }
  for (std::size_t place = 0; place < bytes.size(); place += 1 + bytes.size() / 500) {
    std::string changed = bytes;
    changed[place] = static_cast<char>(changed[place] ^ 1);
    EXPECT_NE(reason(changed), "none") << place;
  }
}

TEST(PreparedCloud, RefusesOptionsOfAnother) {
  const Pair pair;
  const PreparedCloud source(pair.source, pair.frontend);
  FrontendOptions wide = pair.frontend;
  wide.feature_radius = 6;
  EXPECT_THROW(match_clouds(source, source, wide), std::invalid_argument);
  EXPECT_THROW(match_clouds(source, PreparedCloud(pair.target, wide)), std::invalid_argument);
  // what is not said is that of the clouds
  const PreparedCloud wide_source(pair.source, wide), wide_target(pair.target, wide);
  expect_equal(match_clouds(wide_source, wide_target),
               match_clouds(pair.source, pair.target, wide));
  FrontendOptions seen = pair.frontend;
  seen.source_viewpoint = {0, 0, 5};
  EXPECT_THROW(register_clouds(source, source, seen), std::invalid_argument);
  Options bounds;
  bounds.noise_bounds = {1, 2};
  EXPECT_THROW(register_clouds(source, source, pair.frontend, bounds), std::invalid_argument);
  EXPECT_THROW(PreparedCloud(Points::Constant(3, 4, NAN)), std::invalid_argument);
}

TEST(PreparedCloud, OfRepeatedPointsKeepsOne) {
  Points points = bumpy_sphere(1000, 4);
  points.leftCols(700).setZero();
  EXPECT_EQ(PreparedCloud(points).points().cols(), 301);
}

TEST(PreparedCloud, CanBeSharedByThreads) {
  const Pair pair;
  const PreparedCloud source(pair.source, pair.frontend), target(pair.target, pair.frontend);
  FrontendOptions coarse = pair.frontend;
  coarse.voxel_size = 0.08;
  std::vector<CloudMatches> matches(4);
  std::vector<std::thread> threads;
  for (CloudMatches& slot : matches) {
    threads.emplace_back([&] { slot = match_clouds(source, target, coarse); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const CloudMatches& slot : matches) {
    expect_equal(slot, match_clouds(pair.source, pair.target, coarse));
  }
}

}  // namespace
}  // namespace gmcr::frontend
