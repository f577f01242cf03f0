#include "cli/tool.hpp"
#include "gmcr/io.hpp"
#include "gmcr/metrics.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::expect_failure;
using test::run_json;
using test::TemporaryFolder;

class NoiseOption : public testing::Test {
 protected:
  NoiseOption() {
    SyntheticOptions options;
    options.num_correspondences = 200;
    options.seed = 8;
    problem_ = make_synthetic(options);
    write_matches(folder_ / "m.csv", problem_.source, problem_.target);
  }

  std::string command(const std::string& options) const {
    return "solve '" + (folder_ / "m.csv").string() + "' " + options;
  }

  void write_bounds(const std::vector<double>& bounds) const {
    write_matches(folder_ / "m.csv", problem_.source, problem_.target, bounds);
  }

  TemporaryFolder folder_;
  SyntheticProblem problem_;
};

TEST_F(NoiseOption, IsTheBoundThatTheJsonNames) {
  const json result = run_json(command("--noise-bound 0.01"));
  EXPECT_EQ(result.at("noise_bound"), 0.01);
  EXPECT_FALSE(result.contains("noise_estimate"));
}

TEST_F(NoiseOption, MayComeFromASeventhColumn) {
  const json one_for_all = run_json(command("--noise-bound 0.01"));
  write_bounds(std::vector<double>(200, 0.01));
  const json same = run_json(command(""));
  EXPECT_EQ(same.at("inliers"), one_for_all.at("inliers"));
  EXPECT_FALSE(same.contains("noise_bound"));

  std::vector<double> bounds(200, 0.01);
  for (std::size_t i = 0; i < 100; ++i) bounds[i] = 0.003;
  write_bounds(bounds);
  const json tighter = run_json(command("-o '" + (folder_ / "T.txt").string() + "'"));
  const Similarity pose = read_transform(folder_ / "T.txt");
  std::vector<Index> expected;
  for (Index i = 0; i < 200; ++i) {
    const double residual = (problem_.target.col(i) - pose * problem_.source.col(i)).norm();
    if (residual <= bounds[static_cast<std::size_t>(i)]) expected.push_back(i);
  }
  EXPECT_EQ(tighter.at("inliers").get<std::vector<Index>>(), expected);
  EXPECT_LT(tighter.at("num_inliers"), same.at("num_inliers"));
}

TEST_F(NoiseOption, GivenTwiceOrNotAtAllIsRefused) {
  for (const char* way : {"--noise-bound B", "--noise-bound auto", "7th column"}) {
    expect_failure(command(""), 2, way);
  }
  write_bounds(std::vector<double>(200, 0.01));
  expect_failure(command("--noise-bound 0.01"), 2, "--noise-bound: the matches have");
  expect_failure(command("--noise-bound auto"), 2, "--noise-bound: the matches have");
}

TEST_F(NoiseOption, ThatIsNoBoundIsRefused) {
  expect_failure(command("--noise-bound wide"), 2,
                 "--noise-bound: 'wide' is neither a number nor auto");
  expect_failure(command("--noise-bound 0"), 2, "--noise-bound");
  expect_failure(command("--noise-bound 1cm"), 2, "'1cm' is neither");
  expect_failure("register a.ply b.ply --noise-bound wide", 2, "'wide' is neither");
}

TEST_F(NoiseOption, AutoChoosesTheBoundFromTheMatches) {
  const json result =
      run_json(command("--noise-bound auto -o '" + (folder_ / "T.txt").string() + "'"));
  const json& estimate = result.at("noise_estimate");
  EXPECT_EQ(result.at("noise_bound"), estimate.at("noise_bound"));
  EXPECT_GT(estimate.at("noise_bound").get<double>(), 0.002);
  EXPECT_LT(estimate.at("noise_bound").get<double>(), 0.1);
  EXPECT_GT(estimate.at("stable_min").get<double>(), 0);
  EXPECT_LE(estimate.at("stable_min"), estimate.at("stable_max"));
  EXPECT_LT(estimate.at("log10_false_alarms").get<double>(), -3);
  EXPECT_LT(translation_error(read_transform(folder_ / "T.txt").translation,
                              problem_.target_from_source.translation),
            0.05);
}

TEST_F(NoiseOption, AutoSaysInWordsHowSureItIs) {
  const auto output = test::run_tool(command("--noise-bound auto"));
  EXPECT_NE(output.out.find("chosen from the matches: chance would give this once in 10^"),
            std::string::npos)
      << output.out;
}

}  // namespace
}  // namespace gmcr
