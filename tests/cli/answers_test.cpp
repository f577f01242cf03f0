#include <algorithm>

#include "cli/two_motions.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::expect_failure;
using test::run_json;
using test::run_tool;

using AnswerOption = test::TwoMotions;

bool shows(const test::Output& output, const std::string& words) {
  return output.out.find(words) != std::string::npos;
}

TEST_F(AnswerOption, HypothesesListTheAlternatives) {
  const json one = solve("");
  EXPECT_FALSE(one.contains("alternatives"));
  EXPECT_FALSE(one.contains("runner_up_ratio"));

  const json two = solve("--hypotheses 2");
  EXPECT_EQ(two.at("num_inliers"), kNumTipped);
  ASSERT_EQ(two.at("alternatives").size(), 1u);
  const json& other = two.at("alternatives").at(0);
  EXPECT_EQ(other.at("num_inliers"), kNumUpright);
  EXPECT_EQ(other.at("inliers").size(), static_cast<std::size_t>(kNumUpright));
  EXPECT_EQ(other.at("inliers").at(0), 0);
  EXPECT_EQ(other.at("scale"), 1);
  EXPECT_NEAR(other.at("translation").at(1).get<double>(), 0.4, 1e-3);
  EXPECT_NEAR(other.at("rotation").at(0).at(1).get<double>(), upright_.rotation(0, 1), 1e-3);
  EXPECT_EQ(other.at("target_from_source").at(3), json({0.0, 0.0, 0.0, 1.0}));
  EXPECT_LT(other.at("evidence"), two.at("evidence"));
  EXPECT_DOUBLE_EQ(two.at("runner_up_ratio").get<double>(),
                   other.at("evidence").get<double>() / two.at("evidence").get<double>());
}

TEST_F(AnswerOption, HypothesesThatAreNearlyAsGoodAreReportedAsAmbiguous) {
  const auto output = run_tool(command("--hypotheses 2 --evidence count"));
  EXPECT_TRUE(shows(output, "alternatives  90 % of the evidence, 36 inliers: ")) << output.out;
  EXPECT_TRUE(shows(output, "ambiguous     another pose has 90 %")) << output.out;
  EXPECT_FALSE(shows(run_tool(command("")), "ambiguous"));
}

TEST_F(AnswerOption, InstancesAreListedBestFirst) {
  const json result = solve("--instances 5");
  const json& instances = result.at("instances");
  ASSERT_EQ(instances.size(), 2u);
  EXPECT_EQ(instances.at(0).at("num_inliers"), kNumTipped);
  EXPECT_EQ(instances.at(1).at("num_inliers"), kNumUpright);
  EXPECT_EQ(instances.at(1).at("inliers").at(0), 0) << "indices into the input";
  EXPECT_NEAR(instances.at(1).at("translation").at(0).get<double>(), 0.3, 1e-3);
  for (const char* name : {"status", "scale", "rotation", "translation", "target_from_source",
                           "num_inliers", "inliers", "evidence", "certificate"}) {
    EXPECT_EQ(result.at(name), instances.at(0).at(name)) << name;
    EXPECT_TRUE(instances.at(1).contains(name)) << name;
  }
  EXPECT_FALSE(solve("").contains("instances"));
}

TEST_F(AnswerOption, InstancesEndWhereTheOptionsSay) {
  const auto count = [&](const std::string& options) {
    return solve("--evidence count " + options).at("instances").size();
  };
  EXPECT_EQ(count("--instances 1"), 1u);
  EXPECT_EQ(count("--instances 2"), 2u);
  EXPECT_EQ(count("--instances 2 --min-instance-inliers 36"), 2u);
  EXPECT_EQ(count("--instances 2 --min-instance-inliers 37"), 1u);
  EXPECT_EQ(count("--instances 2 --min-instance-share 0.85"), 2u);
  EXPECT_EQ(count("--instances 2 --min-instance-share 0.95"), 1u);
}

TEST_F(AnswerOption, InstancesAreATableForPeople) {
  const auto output = run_tool(command("--instances 5 -o " + path("T.txt")));
  EXPECT_TRUE(shows(output, "instances     2 found")) << output.out;
  EXPECT_TRUE(shows(output, "120.000 deg about (1.0000")) << output.out;
  EXPECT_NEAR(read_transform(folder_ / "T.txt").translation.z(), 4, 1e-3) << "that of the first";
}

TEST(CertifyOption, TightensTheUpperBound) {
  const test::TemporaryFolder folder;
  const std::string matches = "'" + (folder / "m.csv").string() + "'";
  int plain = 0, certified = 0;
  // pairs agree more often than poses do where the noise is large; few matches are proven unasked
  for (const char* problem :
       {"--outliers 0.7 --noise 0.1 --seed 1", "--outliers 0.7 --noise 0.2 --seed 2",
        "--outliers 0.9 --noise 0.05 --seed 3"}) {
    const json made = run_json("synth -o " + matches + " --num 270 " + problem);
    const std::string solve = "solve " + matches + " --evidence count --noise-bound " +
                              std::to_string(made.at("noise_bound").get<double>());
    plain += run_json(solve).at("certificate").at("upper").get<int>();
    certified +=
        run_json(solve + " --certify --time-limit 2").at("certificate").at("upper").get<int>();
  }
  EXPECT_LT(certified, plain);
}

TEST_F(AnswerOption, OutOfRangeIsRefusedByItsName) {
  const auto fails = [&](const std::string& options, const std::string& words) {
    expect_failure(command(options), 2, words);
  };
  fails("--hypotheses 0", "--hypotheses: 0 is not at least 1");
  fails("--hypotheses 1.5", "--hypotheses");
  fails("--hypotheses some", "--hypotheses = some");
  fails("--instances 0", "--instances: 0 is not at least 1");
  fails("--instances all", "--instances = all");
  fails("--instances 2 --min-instance-inliers 2", "--min-instance-inliers: 2 is not at least 3");
  fails("--instances 2 --min-instance-share 1.1", "--min-instance-share: 1.1 is not in [0, 1]");
  fails("--min-instance-inliers 9", "--min-instance-inliers requires --max-instances");
  fails("--min-instance-share 0.5", "--min-instance-share requires --max-instances");
  expect_failure("register a.ply b.ply --hypotheses 0", 2, "--hypotheses");
  expect_failure("register a.ply b.ply --instances 0", 2, "--instances: 0 is not at least 1");
}

TEST_F(AnswerOption, OneToOneCountsMatchesThatShareAPointOnce) {
  constexpr Index kHalf = kNumTipped / 2;
  source_.middleCols(kNumUpright + kHalf, kHalf) = source_.middleCols(kNumUpright, kHalf);
  target_.middleCols(kNumUpright + kHalf, kHalf) = target_.middleCols(kNumUpright, kHalf);
  write_matches(folder_ / "m.csv", source_, target_);
  EXPECT_EQ(solve("--evidence count").at("num_inliers"), kNumTipped);
  EXPECT_EQ(solve("--evidence count --one-to-one").at("num_inliers"), kNumUpright);
}

TEST_F(AnswerOption, TheCertificateGivesThePoseThatHoldsTheMost) {
  target_(0, kNumUpright) += 0.0105;  // within the bound of a pose, not of that of the others
  write_matches(folder_ / "m.csv", source_, target_);
  const json result = solve("--evidence count");
  EXPECT_EQ(result.at("num_inliers"), kNumTipped - 1);
  EXPECT_NEAR(result.at("translation").at(2).get<double>(), 4, 1e-4);
  const json& certificate = result.at("certificate");
  EXPECT_EQ(certificate.at("lower"), kNumTipped);
  EXPECT_EQ(certificate.at("inliers").size(), static_cast<std::size_t>(kNumTipped));
  EXPECT_GT(std::abs(certificate.at("target_from_source").at(2).at(3).get<double>() - 4), 1e-4);
}

TEST_F(AnswerOption, EvidenceIsReportedWithItsBound) {
  const json distinct = solve("");
  const json& bound = distinct.at("certificate").at("evidence");
  EXPECT_EQ(bound.at("lower"), distinct.at("evidence"));
  EXPECT_GE(bound.at("upper"), bound.at("lower"));
  EXPECT_TRUE(bound.at("certified").is_boolean());
  const json count = solve("--evidence count").at("certificate");
  EXPECT_EQ(count.at("evidence").at("lower"), static_cast<double>(kNumTipped));
  EXPECT_EQ(count.at("evidence").at("upper").get<double>(), count.at("upper").get<double>());
  EXPECT_EQ(count.at("evidence").at("certified"), count.at("certified"));
  EXPECT_TRUE(shows(run_tool(command("")), "\nevidence "));
  EXPECT_FALSE(shows(run_tool(command("--evidence count")), "\nevidence "));
}

TEST_F(AnswerOption, CovarianceHasARowForEachUnknown) {
  const json rigid = solve("").at("covariance");
  ASSERT_EQ(rigid.at("matrix").size(), 6u);
  EXPECT_EQ(rigid.at("matrix").at(5).size(), 6u);
  const auto variances = rigid.at("eigenvalues").get<std::vector<double>>();
  EXPECT_EQ(variances.size(), 6u);
  EXPECT_TRUE(std::is_sorted(variances.begin(), variances.end()));
  EXPECT_GT(variances.front(), 0);
  EXPECT_GT(rigid.at("matrix").at(0).at(0), 0);
  EXPECT_TRUE(shows(run_tool(command("")), "\nuncertainty   rotation ")) << "for people";

  const json similarity = solve("--estimate-scale");
  EXPECT_EQ(similarity.at("covariance").at("matrix").size(), 7u);
  EXPECT_TRUE(shows(run_tool(command("--estimate-scale")), ", scale "));
}

TEST_F(AnswerOption, ConsistentScalesHoldTheScale) {
  EXPECT_EQ(solve("").at("consistent_scales"), json({1.0, 1.0}));
  const json result = solve("--estimate-scale");
  const json& scales = result.at("consistent_scales");
  EXPECT_LT(scales.at(0), scales.at(1));
  EXPECT_LE(scales.at(0), result.at("scale"));
  EXPECT_GE(scales.at(1), result.at("scale"));
}

TEST(Covariance, IsNullWithoutAPose) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("two.csv", "0,0,0,1,1,1\n1,0,0,2,1,1\n");
  const json result = run_json("solve '" + path.string() + "' --noise-bound 0.01", 1);
  EXPECT_TRUE(result.at("covariance").is_null());
}

TEST_F(AnswerOption, RequiredVerdictDecidesOnTheExitCode) {
  const json result = solve("--require trusted");
  EXPECT_EQ(result.at("verdict"), "trusted");
  EXPECT_LT(result.at("log10_false_alarms").get<double>(), -6);
  EXPECT_TRUE(shows(run_tool(command("")), "verdict       trusted: chance"));

  // three matches agree with many poses
  const test::TemporaryFolder folder;
  const auto few =
      folder.write("few.csv", "ax,ay,az,bx,by,bz\n0,0,0,0,0,0\n1,0,0,1,0,0\n0,2,0,0,2,0\n");
  const std::string solve_few = "solve '" + few.string() + "' --noise-bound 0.01";
  EXPECT_EQ(run_json(solve_few).at("verdict"), "untrusted");
  EXPECT_EQ(run_json(solve_few + " --require trusted", 1).at("status"), "ok");
  EXPECT_EQ(run_json(solve_few + " --require doubtful", 1).at("status"), "ok");
  EXPECT_EQ(run_json(solve_few + " --require untrusted").at("status"), "ok");
  expect_failure(solve_few + " --require sure", 2, "'sure' is none of trusted|doubtful|untrusted");
}

}  // namespace
}  // namespace gmcr
