#include <fstream>
#include <string>

#include "cli/tool.hpp"

namespace gmcr {
namespace {

using test::expect_failure;
using test::run_json;

/// A tetrahedron and its image under the identity, with a fifth match to be chosen.
class NumbersOfMatches : public testing::Test {
 protected:
  std::string with_fifth(const std::string& match) const {
    std::ofstream(folder_ / "m.csv") << "0,0,0,0,0,0\n1,0,0,1,0,0\n0,1,0,0,1,0\n0,0,1,0,0,1\n"
                                     << match << "\n";
    return "solve '" + (folder_ / "m.csv").string() + "' --noise-bound 0.01 ";
  }

  /// The matches alone that are given.
  std::string of(const std::string& matches) const {
    std::ofstream(folder_ / "m.csv") << matches;
    return "solve '" + (folder_ / "m.csv").string() + "' --noise-bound 0.01 ";
  }

  test::TemporaryFolder folder_;
};

TEST_F(NumbersOfMatches, OutOfRangeAreRefusedByName) {
  expect_failure(with_fifth("1e160,0,0,0,0,0"), 2, "source: point 4");
  expect_failure(with_fifth("0,0,0,0,-1e51,0"), 2, "target: point 4");
  expect_failure(with_fifth("1e-310,0,0,0,0,0"), 2, "source: point 4");
  expect_failure(with_fifth("2,2,2,2,2,2") + "--scale 1e60", 2, "--scale: 1e+60");
  expect_failure(with_fifth("2,2,2,2,2,2") + "--max-translation 1e60", 2, "--max-translation");
  const std::string matches = with_fifth("2,2,2,2,2,2");
  expect_failure(matches.substr(0, matches.find(" --noise-bound")) +
                     " --noise-bound 1e158 --estimate-scale --time-limit 1",
                 2, "--noise-bound: 1e+158");
}

TEST_F(NumbersOfMatches, FarOutTakeNothingFromTheOthers) {
  for (const std::string match :
       {"1e20,0,0,0,0,0", "3.4028235e38,0,0,3.4028235e38,0,1", "0,0,7,-1e50,1e50,1e50"}) {
    for (const std::string scale : {"", "--estimate-scale", "--certify"}) {
      const auto result = run_json(with_fifth(match) + scale);
      EXPECT_EQ(result.at("status"), "ok") << match << scale;
      EXPECT_EQ(result.at("num_inliers"), 4) << match << scale;
    }
  }
}

TEST_F(NumbersOfMatches, AreAsFewAsThePriorsAllow) {
  // turned by 90 degrees about the vertical and moved by (1, 2, 3)
  const std::string pair = "1,0,0,1,3,3\n0,2,1,-1,2,4\n";
  EXPECT_EQ(run_json(of(pair) + "--gravity 0 0 -1 --max-tilt 0").at("status"), "ok");
  EXPECT_EQ(run_json(of(pair), 1).at("status"), "too_few_correspondences");
  std::ofstream(folder_ / "T.txt") << "0 -1 0 0\n1 0 0 0\n0 0 1 0\n0 0 0 1\n";
  const auto shift = run_json(of("1,0,0,1,3,3\n") + "--max-rotation-error 0 --initial-pose '" +
                              (folder_ / "T.txt").string() + "'");
  EXPECT_EQ(shift.at("status"), "ok");
  EXPECT_NEAR(shift.at("translation").at(2).get<double>(), 3, 1e-9);
}

}  // namespace
}  // namespace gmcr
