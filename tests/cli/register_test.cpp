#include <Eigen/Geometry>
#include <cmath>

#include "cli/tool.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/io.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::run_json;
using test::TemporaryFolder;

/// A bumpy closed surface without symmetry, and the same under a known motion.
class Register : public testing::Test {
 protected:
  Register() {
    constexpr Index kNumPoints = 4000;
    Points source(3, kNumPoints);
    for (Index i = 0; i < kNumPoints; ++i) {
      // Fibonacci sphere
      const double height = 1 - 2 * (static_cast<double>(i) + 0.5) / kNumPoints;
      const double turn = 2.399963229728653 * static_cast<double>(i);
      const double ring = std::sqrt(1 - height * height);
      const Eigen::Vector3d direction(ring * std::cos(turn), ring * std::sin(turn), height);
      const double radius = 1 +
                            0.25 * std::sin(3 * direction.x() + 1) * std::cos(4 * direction.y()) +
                            0.2 * std::sin(5 * direction.z() + direction.x());
      source.col(i) = radius * direction;
    }
    truth_.rotation = Eigen::AngleAxisd(0.9, Eigen::Vector3d(1, 2, -1).normalized()).matrix();
    truth_.translation << 0.5, -2, 1;
    write_cloud(folder_ / "source.ply", source);
    write_cloud(folder_ / "target.ply", truth_.apply(source));
    write_transform(folder_ / "truth.txt", truth_);
  }

  std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }

  std::string command() const {
    return "register " + path("source.ply") + " " + path("target.ply") +
           " --orientation outward --voxel 0.08 ";
  }

  TemporaryFolder folder_;
  Similarity truth_;
};

TEST_F(Register, FindsThePoseAndKeepsTheContract) {
  const json result = run_json(command() + "--evidence count -o " + path("T.txt") + " --aligned " +
                               path("aligned.ply") + " --matches " + path("matches.csv"));
  EXPECT_EQ(result.at("status"), "ok");
  EXPECT_EQ(result.at("num_source_points"), 4000);
  EXPECT_EQ(result.at("num_target_points"), 4000);
  EXPECT_GT(result.at("fitness").get<double>(), 0.9);
  EXPECT_EQ(result.at("voxel_size"), 0.08);
  EXPECT_EQ(result.at("certificate").at("lower"), result.at("certificate").at("inliers").size());
  const Similarity pose = read_transform(folder_ / "T.txt");
  EXPECT_LT((pose.matrix() - truth_.matrix()).norm(), 0.05);
  const Points source = read_cloud(folder_ / "source.ply").points;
  EXPECT_LT((read_cloud(folder_ / "aligned.ply").points - pose.apply(source)).norm(), 1e-9);

  // inliers are those of the refined pose, and index the written matches
  const Matches matches = read_matches(folder_ / "matches.csv");
  const double bound = result.at("noise_bound");
  std::vector<Index> expected;
  Similarity printed;
  printed.scale = result.at("scale");
  for (Index i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(i);
    printed.translation(i) = result.at("translation").at(row);
    for (Index j = 0; j < 3; ++j) {
      printed.rotation(i, j) = result.at("rotation").at(row).at(static_cast<std::size_t>(j));
    }
  }
  for (Index i = 0; i < matches.source.cols(); ++i) {
    const Eigen::Vector3d image = printed * matches.source.col(i);
    if ((matches.target.col(i) - image).norm() <= bound) expected.push_back(i);
  }
  EXPECT_EQ(result.at("inliers").get<std::vector<Index>>(), expected);
}

TEST_F(Register, RefinesOnlyWhereAsked) {
  const json plain = run_json(command() + "--refine none");
  const json refined = run_json(command() + "--refine icp");
  EXPECT_EQ(plain.at("refinement").at("applied"), false);
  EXPECT_FALSE(plain.at("time_ms").contains("refinement"));
  EXPECT_TRUE(refined.at("time_ms").contains("refinement"));
  EXPECT_NE(plain.at("target_from_source"), refined.at("target_from_source"));
}

TEST_F(Register, NoiseBoundIsGivenOrFromTheVoxelsOrFromTheMatches) {
  EXPECT_EQ(run_json(command() + "--noise-bound 0.07").at("noise_bound"), 0.07);
  const json voxels = run_json(command());
  EXPECT_NEAR(voxels.at("noise_bound").get<double>(), 0.08 * FrontendOptions{}.noise_bound_voxels,
              1e-12);
  EXPECT_FALSE(voxels.contains("noise_estimate"));
  const json matches = run_json(command() + "--noise-bound auto");
  EXPECT_EQ(matches.at("noise_bound"), matches.at("noise_estimate").at("noise_bound"));
  EXPECT_NE(matches.at("noise_bound"), voxels.at("noise_bound"));
}

TEST_F(Register, TakesPriorsAndHypotheses) {
  const json result = run_json(command() + "--initial-pose " + path("truth.txt") +
                               " --max-rotation-error 5 --hypotheses 2");
  EXPECT_EQ(result.at("status"), "ok");
  EXPECT_TRUE(result.at("alternatives").is_array());
  write_transform(folder_ / "truth.txt", Similarity{});
  const auto elsewhere = test::run_tool(command() + "--initial-pose " + path("truth.txt") +
                                        " --max-translation-error 0.1 --refine none --json");
  EXPECT_LT(json::parse(elsewhere.out, nullptr, false).at("num_inliers"), result.at("num_inliers"));
}

TEST_F(Register, RefinesOnlyWithinThePriors) {
  Similarity initial = truth_;
  initial.rotation = Eigen::AngleAxisd(0.035, Eigen::Vector3d::UnitX()).matrix() * truth_.rotation;
  write_transform(folder_ / "initial.txt", initial);
  const auto run = test::run_tool(command() + "--initial-pose " + path("initial.txt") +
                                  " --max-rotation-error 1 --json");
  const json result = json::parse(run.out);
  ASSERT_EQ(result.at("status"), "ok");
  Eigen::Matrix3d rotation;
  for (Index i = 0; i < 3; ++i) {
    for (Index j = 0; j < 3; ++j) {
      rotation(i, j) =
          result.at("rotation").at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j));
    }
  }
  EXPECT_LE(rotation_error_deg(rotation, initial.rotation), 1 + 1e-6);
}

TEST_F(Register, MatchWritesWhatSolveReads) {
  const json matched = run_json("match " + path("source.ply") + " " + path("target.ply") +
                                " --orientation outward --voxel 0.08 -o " + path("m.csv"));
  EXPECT_EQ(matched.at("voxel_size"), 0.08);
  const json solved = run_json("solve " + path("m.csv") + " --noise-bound " +
                               std::to_string(matched.at("noise_bound").get<double>()));
  EXPECT_EQ(solved.at("num_correspondences"), matched.at("num_correspondences"));
  EXPECT_EQ(solved.at("status"), "ok");
}

TEST_F(Register, WarnsOfDroppedPointsOnStderrOnly) {
  Points source = read_cloud(folder_ / "source.ply").points;
  source(0, 7) = std::nan("");
  write_cloud(folder_ / "source.ply", source);
  const auto output = test::run_tool(command() + "--json");
  EXPECT_NE(output.err.find("dropped 1 points"), std::string::npos) << output.err;
  const json result = json::parse(output.out, nullptr, false);
  EXPECT_EQ(result.at("num_source_points"), 3999);
}

TEST(RegisterOfTooFewPoints, ExitsWithOne) {
  const TemporaryFolder folder;
  const auto path = folder.write("c.xyz", "0 0 0\n1 0 0\n").string();
  EXPECT_EQ(run_json("register '" + path + "' '" + path + "' --voxel 0.1", 1).at("status"),
            "too_few_correspondences");
}

TEST_F(Register, OfPreparedCloudsGivesThePoseOfTheClouds) {
  const json expected = run_json(command());
  const auto prepare = [&](const std::string& name) {
    return run_json("prepare " + path(name + ".ply") + " -o " + path(name + ".prepared.ply") +
                    " --orientation outward --voxel 0.08");
  };
  const json prepared = prepare("source");
  EXPECT_EQ(prepared.at("num_points"), 4000);
  EXPECT_EQ(prepared.at("voxel_size"), 0.08);
  prepare("target");
  const std::string source = path("source.prepared.ply"), target = path("target.prepared.ply");
  for (const std::string& pair : {source + " " + target, path("source.ply") + " " + target,
                                  source + " " + path("target.ply")}) {
    const json result = run_json("register " + pair + " --orientation outward --voxel 0.08");
    EXPECT_EQ(result.at("target_from_source"), expected.at("target_from_source")) << pair;
    EXPECT_EQ(result.at("num_source_points"), 4000);
  }
  // where points are all that counts, it is a cloud like others
  EXPECT_EQ(read_cloud(folder_ / "source.prepared.ply").points,
            read_cloud(folder_ / "source.ply").points);
  const json matched = run_json("match " + source + " " + target + " --orientation outward -o " +
                                path("matches.csv"));
  EXPECT_EQ(matched.at("voxel_size"), 0.08);
  EXPECT_FALSE(matched.at("time_ms").contains("features"));
}

TEST_F(Register, OfAPreparedCloudThatDoesNotFitIsRefused) {
  run_json("prepare " + path("source.ply") + " -o " + path("p.ply") + " --voxel 0.08");
  std::string content = test::content_of(folder_ / "p.ply");
  content.back() = static_cast<char>(content.back() ^ 1);
  write_text(folder_ / "changed.ply", content);
  test::expect_failure("register " + path("changed.ply") + " " + path("target.ply"), 3,
                       "the checksum differs");
  test::expect_failure(
      "register " + path("p.ply") + " " + path("target.ply") + " --feature-radius 7", 2,
      "feature-radius");
  test::expect_failure("prepare " + path("source.ply") + " -o " + path("no/such/folder.ply"), 3,
                       "folder");
}

}  // namespace
}  // namespace gmcr
