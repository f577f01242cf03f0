#include <random>

#include "cli/tool.hpp"
#include "gmcr/io.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::run_json;
using test::TemporaryFolder;

class SolveOption : public testing::Test {
 protected:
  SolveOption() {
    SyntheticOptions options;
    options.num_correspondences = 150;
    options.scale_range = {2, 2};
    problem_ = make_synthetic(options);
    write_matches(folder_ / "m.csv", problem_.source, problem_.target);
  }

  json solve(const std::string& options, int exit_code = 0) const {
    return run_json("solve '" + (folder_ / "m.csv").string() + "' " + options, exit_code);
  }

  TemporaryFolder folder_;
  SyntheticProblem problem_;
};

TEST_F(SolveOption, ScaleIsTheScaleOfThePose) {
  const json result = solve("--noise-bound 0.01 --scale 2");
  EXPECT_EQ(result.at("scale"), 2);
  EXPECT_GE(result.at("certificate").at("lower"), 75);
  EXPECT_LT(solve("--noise-bound 0.01 --scale 1", 1).at("num_inliers").get<int>(), 75);
}

TEST_F(SolveOption, EstimateScaleFindsTheScaleInsideTheRange) {
  EXPECT_NEAR(solve("--noise-bound 0.01 --estimate-scale").at("scale").get<double>(), 2, 0.05);
  EXPECT_NEAR(
      solve("--noise-bound 0.01 --estimate-scale --scale-range 1.5 3").at("scale").get<double>(), 2,
      0.05);
  const json elsewhere = run_json("solve '" + (folder_ / "m.csv").string() +
                                      "' --noise-bound 0.01 --estimate-scale --scale-range 10 20",
                                  1);
  EXPECT_LT(elsewhere.at("num_inliers").get<int>(), 20);
}

TEST_F(SolveOption, IsTheSameByItsNameAndByItsAlias) {
  const auto pose = [&](const std::string& options) {
    return solve("--noise-bound 0.01 " + options).at("target_from_source");
  };
  EXPECT_EQ(pose("--scale-mode estimated"), pose("--estimate-scale"));
  EXPECT_EQ(pose("--scale 2 --num-threads 1"), pose("--scale 2 --threads 1"));
  const auto chosen = [&](const std::string& noise) {
    return solve(noise + " --scale 2").at("noise_estimate");
  };
  EXPECT_EQ(chosen("--noise-mode estimated"), chosen("--noise-bound auto"));
}

TEST_F(SolveOption, MethodChangesTheStages) {
  const json ours = solve("--noise-bound 0.01 --scale 2 --method gmcr");
  const json paper = solve("--noise-bound 0.01 --scale 2 --method paper");
  EXPECT_NE(ours.at("num_candidates"), paper.at("num_candidates"));
}

TEST_F(SolveOption, ThreadsAreReportedAndChangeNoBit) {
  const json one = solve("--noise-bound 0.01 --scale 2 --threads 1");
  const json two = solve("--noise-bound 0.01 --scale 2 --threads 2");
  EXPECT_EQ(one.at("threads"), 1);
  EXPECT_EQ(two.at("threads"), 2);
  EXPECT_EQ(one.at("target_from_source"), two.at("target_from_source"));
}

TEST_F(SolveOption, LimitsAreReportedWhereTheyBind) {
  EXPECT_TRUE(solve("--noise-bound 0.01 --scale 2").at("limits_hit").empty());
  const auto output = test::run_tool("solve '" + (folder_ / "m.csv").string() +
                                     "' --noise-bound 0.01 --scale 2 --time-limit 1e-9 --json");
  EXPECT_NE(output.out.find("\"limit_codes\": [\n    \"time\""), std::string::npos) << output.out;
}

TEST(CliqueOption, MaxNodesLeavesTheProofOpen) {
  const TemporaryFolder folder;
  // a random graph, dense enough that no bound at the root is tight
  std::mt19937 random(7);
  std::string edges;
  int count = 0;
  constexpr int kVertices = 120;
  for (int u = 1; u <= kVertices; ++u) {
    for (int v = u + 1; v <= kVertices; ++v) {
      if (random() % 10 >= 7) continue;
      edges += "e " + std::to_string(u) + " " + std::to_string(v) + "\n";
      ++count;
    }
  }
  const auto path = folder.write("g.clq", "p edge 120 " + std::to_string(count) + "\n" + edges);
  const json all = run_json("clique '" + path.string() + "'");
  EXPECT_EQ(all.at("proven_optimal"), true);
  const json few = run_json("clique '" + path.string() + "' --max-nodes 1");
  EXPECT_EQ(few.at("proven_optimal"), false);
  EXPECT_GT(few.at("upper_bound"), all.at("clique_size"));
  const json threads = run_json("clique '" + path.string() + "' --threads 3");
  EXPECT_EQ(threads.at("vertices"), all.at("vertices"));
}

TEST(SynthOption, EachChangesTheProblem) {
  const TemporaryFolder folder;
  const auto made = [&](const std::string& options) {
    run_json("synth -o '" + (folder / "m.csv").string() + "' --truth '" +
             (folder / "T.txt").string() + "' " + options);
    return test::content_of(folder / "m.csv") + test::content_of(folder / "T.txt");
  };
  const std::string base = made("--num 60");
  EXPECT_EQ(made("--num 60"), base);
  for (const char* options :
       {"--num 61", "--num 60 --seed 1", "--num 60 --outliers 0.1", "--num 60 --noise 0.05",
        "--num 60 --scale-range 2 3", "--num 60 --max-translation 9", "--num 60 --kind random",
        "--num 60 --kind structured", "--num 60 --noise-bound 0.5",
        "--num 60 --noise-shape gaussian"}) {
    EXPECT_NE(made(options), base) << options;
  }
}

}  // namespace
}  // namespace gmcr
