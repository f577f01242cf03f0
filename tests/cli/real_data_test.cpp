#include <filesystem>

#include "cli/tool.hpp"
#include "data_folder.hpp"

namespace gmcr {
namespace {

using testing::data_folder;

TEST(SolveRealData, FindsTheKittiPoseAmongTwoPerCentOfRightMatches) {
  const auto pair = data_folder() / "kitti_fpfh/kitti_000";
  if (!std::filesystem::exists(pair)) {
    GTEST_SKIP() << "no data at " << data_folder() << "; set GMCR_DATA";
  }
  const test::TemporaryFolder folder;
  const std::string transform = "'" + (folder / "T.txt").string() + "'";
  const auto result = test::run_json("solve '" + (pair / "correspondences.csv").string() +
                                     "' --noise-bound 0.6 -o " + transform);
  EXPECT_EQ(result.at("num_correspondences"), 5344);
  const auto errors =
      test::run_json("eval " + transform + " '" + (pair / "T_target_source.txt").string() + "'");
  EXPECT_LT(errors.at("rotation_error_deg").get<double>(), 5);
  EXPECT_LT(errors.at("translation_error").get<double>(), 0.6);
}

}  // namespace
}  // namespace gmcr
