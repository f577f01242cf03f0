#include <Eigen/LU>

#include "cli/tool.hpp"
#include "gmcr/io.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::run_json;
using test::run_tool;
using test::TemporaryFolder;

/// A problem on disk: matches.csv with its truth.
class SolveContract : public testing::Test {
 protected:
  SolveContract() {
    SyntheticOptions options;
    options.num_correspondences = 200;
    options.outlier_rate = 0.7;
    options.seed = 5;
    problem_ = make_synthetic(options);
    write_matches(folder_ / "matches.csv", problem_.source, problem_.target);
    write_matches(folder_ / "matches.npy", problem_.source, problem_.target);
    write_transform(folder_ / "T.txt", problem_.target_from_source);
  }

  std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }

  TemporaryFolder folder_;
  SyntheticProblem problem_;
};

Similarity pose_of(const json& result) {
  Similarity pose;
  pose.scale = result.at("scale");
  for (Index i = 0; i < 3; ++i) {
    pose.translation(i) = result.at("translation").at(static_cast<std::size_t>(i));
    for (Index j = 0; j < 3; ++j) {
      pose.rotation(i, j) =
          result.at("rotation").at(static_cast<std::size_t>(i)).at(static_cast<std::size_t>(j));
    }
  }
  return pose;
}

void expect_contract_fields(const json& result) {
  for (const char* name :
       {"status", "scale", "rotation", "translation", "target_from_source", "num_correspondences",
        "num_inliers", "inliers", "certificate", "time_ms", "threads", "isa", "version",
        "limits_hit", "limit_codes", "options", "report"}) {
    EXPECT_TRUE(result.contains(name)) << name;
  }
  EXPECT_EQ(result.at("rotation").size(), 3u);
  EXPECT_EQ(result.at("target_from_source").size(), 4u);
  EXPECT_EQ(result.at("num_inliers"), result.at("inliers").size());
  EXPECT_TRUE(result.at("certificate").at("certified").is_boolean());
  EXPECT_LE(result.at("certificate").at("lower"), result.at("certificate").at("upper"));
  EXPECT_GT(result.at("time_ms").at("total").get<double>(), 0);
  EXPECT_GE(result.at("threads").get<int>(), 1);
  EXPECT_EQ(result.at("limits_hit").size(), result.at("limit_codes").size());
}

TEST_F(SolveContract, HoldsForAPose) {
  const json result =
      run_json("solve " + path("matches.csv") + " --noise-bound 0.01 --evidence count");
  expect_contract_fields(result);
  EXPECT_EQ(result.at("status"), "ok");
  EXPECT_EQ(result.at("num_correspondences"), 200);
  EXPECT_EQ(result.at("certificate").at("lower"), result.at("certificate").at("inliers").size());
  EXPECT_EQ(result.at("certificate").at("certified").get<bool>(),
            result.at("certificate").at("lower") == result.at("certificate").at("upper"));
  EXPECT_GT(result.at("time_ms").size(), 1u) << "one time for each stage";
  const Similarity pose = pose_of(result);
  EXPECT_LT((pose.matrix() - problem_.target_from_source.matrix()).norm(), 0.05);
  const Eigen::Matrix4d matrix = pose.matrix();
  for (Index i = 0; i < 4; ++i) {
    for (Index j = 0; j < 4; ++j) {
      EXPECT_NEAR(
          result["target_from_source"][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]
              .get<double>(),
          matrix(i, j), 1e-12);
    }
  }
}

TEST_F(SolveContract, ListsExactlyTheInliersOfThePrintedPose) {
  for (const char* evidence : {"count", "distinct"}) {
    const json result =
        run_json("solve " + path("matches.csv") + " --noise-bound 0.01 --evidence " + evidence);
    const Similarity pose = pose_of(result);
    std::vector<Index> expected;
    for (Index i = 0; i < problem_.source.cols(); ++i) {
      const Eigen::Vector3d image = pose * problem_.source.col(i);
      if ((problem_.target.col(i) - image).norm() <= 0.01) expected.push_back(i);
    }
    EXPECT_EQ(result.at("inliers").get<std::vector<Index>>(), expected) << evidence;
  }
}

TEST_F(SolveContract, HoldsWithoutAPose) {
  folder_.write("two.csv", "0,0,0,1,1,1\n1,0,0,2,1,1\n");
  const json two = run_json("solve " + path("two.csv") + " --noise-bound 0.01", 1);
  expect_contract_fields(two);
  EXPECT_EQ(two.at("status"), "too_few_correspondences");
  folder_.write("none.csv", "ax,ay,az,bx,by,bz\n");
  EXPECT_EQ(run_json("solve " + path("none.csv") + " --noise-bound 0.01", 1).at("status"),
            "too_few_correspondences");
  folder_.write("apart.csv", "0,0,0,0,0,0\n1,0,0,50,0,0\n0,2,0,0,700,0\n0,0,3,0,0,9000\n");
  const json apart = run_json("solve " + path("apart.csv") + " --noise-bound 0.01", 1);
  expect_contract_fields(apart);
  EXPECT_EQ(apart.at("status"), "no_consensus");
  folder_.write("line.csv", "0,0,0,0,0,0\n1,0,0,1,0,0\n2,0,0,2,0,0\n5,0,0,5,0,0\n");
  const json line = run_json("solve " + path("line.csv") + " --noise-bound 0.01", 1);
  expect_contract_fields(line);
  EXPECT_EQ(line.at("status"), "degenerate");
}

TEST_F(SolveContract, GivesTheSamePoseFromCsvAndNpy) {
  const json csv = run_json("solve " + path("matches.csv") + " --noise-bound 0.01");
  const json npy = run_json("solve " + path("matches.npy") + " --noise-bound 0.01");
  EXPECT_EQ(csv.at("target_from_source"), npy.at("target_from_source"));
}

TEST_F(SolveContract, PrintsAReportForPeople) {
  const auto output = run_tool("solve " + path("matches.csv") + " --noise-bound 0.01");
  EXPECT_EQ(output.exit_code, 0);
  for (const char* words :
       {"pose found", "rotation", "translation", "inliers", "of 200", "certificate"}) {
    EXPECT_NE(output.out.find(words), std::string::npos) << words << "\n" << output.out;
  }
  EXPECT_EQ(output.out.find('\033'), std::string::npos) << "colour although this is no terminal";
}

TEST_F(SolveContract, TheJsonHoldsTheWordsThatAreReported) {
  const std::string command = "solve " + path("matches.csv") + " --noise-bound 0.01 --threads 1";
  const std::string printed = run_tool(command).out;
  const json result = run_json(command);
  int count = 0;
  for (const json& line : result.at("report")) {
    const std::string text = line.at("text");
    if (text.find(" ms") != std::string::npos) continue;  // times differ from run to run
    EXPECT_NE(printed.find(text + "\n"), std::string::npos) << text << "\n" << printed;
    ++count;
  }
  EXPECT_GE(count, 9);
}

TEST_F(SolveContract, TheJsonHoldsTheOptions) {
  const json options =
      run_json("solve " + path("matches.csv") + " --noise-bound 0.01 --evidence count")
          .at("options");
  EXPECT_EQ(options.at("noise_bound"), 0.01);
  EXPECT_EQ(options.at("evidence"), "count");
}

TEST_F(SolveContract, FilesAgreeWithTheJson) {
  const json result = run_json("solve " + path("matches.csv") + " --noise-bound 0.01 -o " +
                               path("out.txt") + " --inliers " + path("inliers.txt"));
  EXPECT_LT((read_transform(folder_ / "out.txt").matrix() - pose_of(result).matrix()).norm(),
            1e-12);
  std::string expected;
  for (const Index index : result.at("inliers")) expected += std::to_string(index) + "\n";
  EXPECT_EQ(test::content_of(folder_ / "inliers.txt"), expected);
}

TEST_F(SolveContract, EvalReadsTheTransformAndTheJson) {
  const auto result =
      run_tool("solve " + path("matches.csv") + " --noise-bound 0.01 --json -o " + path("out.txt"));
  folder_.write("result.json", result.out);
  const json from_text = run_json("eval " + path("out.txt") + " " + path("T.txt"));
  const json from_json = run_json("eval " + path("result.json") + " " + path("T.txt"));
  EXPECT_LT(from_text.at("rotation_error_deg").get<double>(), 2);
  EXPECT_NEAR(from_text.at("rotation_error_deg").get<double>(),
              from_json.at("rotation_error_deg").get<double>(), 1e-9);
  EXPECT_FALSE(from_text.contains("mean_point_error"));
  folder_.write("result", "\n " + result.out);
  EXPECT_EQ(run_json("eval " + path("result") + " " + path("T.txt")), from_json)
      << "the content says what it is, not the name";
  folder_.write("transform.json", test::content_of(folder_ / "out.txt"));
  EXPECT_EQ(run_json("eval " + path("transform.json") + " " + path("T.txt")), from_text);
  write_cloud(folder_ / "points.ply", problem_.source);
  const json with_points =
      run_json("eval " + path("out.txt") + " " + path("T.txt") + " --points " + path("points.ply"));
  EXPECT_LT(with_points.at("mean_point_error").get<double>(), 0.02);
}

TEST_F(SolveContract, SynthWritesWhatTheLibraryMakes) {
  const json made = run_json("synth -o " + path("made.npy") + " --truth " + path("made.txt") +
                             " --num 200 --outliers 0.7 --seed 5");
  EXPECT_EQ(read_matches(folder_ / "made.npy").target, problem_.target);
  EXPECT_EQ(made.at("noise_bound"), problem_.noise_bound);
  EXPECT_EQ(read_transform(folder_ / "made.txt").translation,
            problem_.target_from_source.translation);
}

}  // namespace
}  // namespace gmcr
