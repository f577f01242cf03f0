#include "cli/two_motions.hpp"

namespace gmcr {
namespace {

using test::expect_failure;

class PriorOption : public test::TwoMotions {
 protected:
  /// Inliers of the pose that the tool finds, if any.
  Index num_inliers(const std::string& options) const {
    const auto output = test::run_tool(command(options) + " --json");
    EXPECT_LE(output.exit_code, 1) << options << "\n" << output.err;
    return nlohmann::json::parse(output.out, nullptr, false).at("num_inliers").get<Index>();
  }
};

TEST_F(PriorOption, NoneFindsTheMotionOfMostMatches) { EXPECT_EQ(num_inliers(""), kNumTipped); }

TEST_F(PriorOption, GravityWithItsTiltLeavesTheUprightMotion) {
  EXPECT_EQ(num_inliers("--gravity 0 0 -9.81 --max-tilt 5"), kNumUpright);
  EXPECT_EQ(num_inliers("--gravity 0 0 1 --max-tilt 130"), kNumTipped);
  EXPECT_LT(num_inliers("--gravity 0 0 1 --max-tilt 1"), kNumUpright);
  EXPECT_LT(num_inliers("--gravity 0 0 1"), kNumUpright) << "no tilt is the default";
}

TEST_F(PriorOption, GravityTakesADirectionForEachFrame) {
  // the tipped motion turns (0, 0, 1) to (0, -0.866, -0.5)
  EXPECT_EQ(num_inliers("--gravity 0 0 1 0 -0.866 -0.5 --max-tilt 1"), kNumTipped);
  EXPECT_LT(num_inliers("--gravity 0 -0.866 -0.5 0 0 1 --max-tilt 1"), kNumUpright)
      << "source first, then target";
}

TEST_F(PriorOption, MaxTranslationLeavesTheNearMotion) {
  EXPECT_EQ(num_inliers("--max-translation 1"), kNumUpright);
  EXPECT_EQ(num_inliers("--max-translation 6"), kNumTipped);
  EXPECT_LT(num_inliers("--max-translation 0.1"), kNumUpright);
}

TEST_F(PriorOption, InitialPoseLeavesTheMotionNearIt) {
  const std::string pose = "--initial-pose " + path("upright.txt");
  EXPECT_EQ(num_inliers(pose + " --max-rotation-error 5"), kNumUpright);
  EXPECT_EQ(num_inliers(pose + " --max-rotation-error 180"), kNumTipped);
  EXPECT_EQ(num_inliers(pose + " --max-translation-error 0.5"), kNumUpright);
  EXPECT_EQ(num_inliers(pose + " --max-translation-error 9"), kNumTipped);
  EXPECT_EQ(num_inliers(pose + " --max-translation-error 9 --max-rotation-error 5"), kNumUpright);
}

TEST_F(PriorOption, AreNamedByTheReport) {
  const auto output = test::run_tool(command("--max-translation 1"));
  EXPECT_NE(output.out.find("no pose that the priors admit"), std::string::npos) << output.out;
  EXPECT_EQ(test::run_tool(command("")).out.find("priors"), std::string::npos);
}

TEST_F(PriorOption, OutOfRangeIsRefusedByItsName) {
  const std::string pose = "--initial-pose " + path("upright.txt");
  const auto fails = [&](const std::string& options, const std::string& words) {
    expect_failure(command(options), 2, words);
  };
  fails("--gravity 0 0 0", "--gravity: (0, 0, 0) is no direction");
  fails("--gravity 0 0 1 0 0 0", "--gravity: (0, 0, 0) is no direction");
  fails("--gravity 0 0", "--gravity");
  fails("--gravity 0 0 1 1", "--gravity: 4 values");
  fails("--gravity 0 0 down", "--gravity: 'down' is no coordinate");
  fails("--gravity 0 0 nan", "--gravity: 'nan' is no coordinate");
  fails("--max-tilt 5", "--max-tilt requires --gravity");
  fails("--gravity 0 0 1 --max-tilt -1", "--max-tilt: -1 is not between 0 and 180 degrees");
  fails("--gravity 0 0 1 --max-tilt 181", "--max-tilt: 181 is not between");
  fails("--gravity 0 0 1 --max-tilt nan", "--max-tilt: nan is not between");
  fails("--gravity 0 0 1 --max-tilt some", "--max-tilt: 'some' is no number");
  fails("--max-translation 0", "--max-translation: 0 is not positive");
  fails("--max-translation -1", "--max-translation: -1 is not positive");
  fails(pose, "--initial-pose needs --max-rotation-error, --max-translation-error or both");
  fails("--max-rotation-error 5", "--max-rotation-error requires --initial-pose");
  fails("--max-translation-error 5", "--max-translation-error requires --initial-pose");
  fails(pose + " --max-rotation-error -5", "--max-rotation-error: -5 is not between 0 and 180");
  fails(pose + " --max-translation-error -5", "--max-translation-error: -5 is not at least 0");
  expect_failure(command("--initial-pose none.txt --max-rotation-error 5"), 3, "none.txt");
  expect_failure("register a.ply b.ply --gravity 0 0 0", 2, "--gravity");
  expect_failure("register a.ply b.ply --initial-pose x.txt", 2, "--max-rotation-error");
}

}  // namespace
}  // namespace gmcr
