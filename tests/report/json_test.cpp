#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "gmcr/isa.hpp"
#include "gmcr/report.hpp"
#include "gmcr/version.hpp"
#include "report/results.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::make_cloud_result;
using test::make_result;

TEST(ResultJson, HoldsEachFieldUnderItsOwnName) {
  const json fields = json::parse(to_json(make_result()));
  EXPECT_EQ(fields.at("status"), "ok");
  EXPECT_EQ(fields.at("status_reason"), "");
  EXPECT_EQ(fields.at("scale"), 2);
  EXPECT_EQ(fields.at("rotation"), json({{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(fields.at("translation"), json({1, 2, 3}));
  EXPECT_EQ(fields.at("target_from_source"),
            json({{0, -2, 0, 1}, {2, 0, 0, 2}, {0, 0, 2, 3}, {0, 0, 0, 1}}));
  EXPECT_EQ(fields.at("num_correspondences"), 10);
  EXPECT_EQ(fields.at("num_used"), 9);
  EXPECT_EQ(fields.at("num_inliers"), 3);
  EXPECT_EQ(fields.at("inliers"), json({1, 4, 7}));
  EXPECT_EQ(fields.at("evidence"), 2.5);
  EXPECT_EQ(fields.at("certificate"), json::parse(R"({"lower": 4, "upper": 5, "certified": false,
    "evidence": {"lower": 3.25, "upper": 4.5, "certified": false},
    "target_from_source": [[0, -2, 0, 1.5], [2, 0, 0, 2], [0, 0, 2, 3], [0, 0, 0, 1]],
    "inliers": [1, 4, 6, 7]})"));
  EXPECT_EQ(fields.at("consistent_scales"), json({1.9, 2.1}));
  EXPECT_EQ(fields.at("covariance").at("matrix").size(), 7u);
  EXPECT_EQ(fields.at("covariance").at("eigenvalues").at(6), 1e-3);
  EXPECT_EQ(fields.at("time_ms"), json({{"total", 2000}, {"graph", 250}, {"clique", 1500}}));
  EXPECT_EQ(fields.at("scale_range"), json({0.5, 4}));
  EXPECT_EQ(fields.at("num_candidates"), 11);
  EXPECT_EQ(fields.at("num_scale_ranges"), 12);
  EXPECT_EQ(fields.at("num_clique_nodes"), 13);
  EXPECT_EQ(fields.at("threads"), 14);
  EXPECT_EQ(fields.at("isa"), active_isa());
  EXPECT_EQ(fields.at("version"), kVersion);
  EXPECT_EQ(fields.at("alternatives").at(0).at("inliers"), json({0, 2}));
  EXPECT_EQ(fields.at("runner_up_ratio"), 0.6);
  EXPECT_FALSE(fields.contains("noise_bound")) << "not known without the options";
  EXPECT_FALSE(fields.contains("options"));
}

TEST(ResultJson, HasACodeForEachLimitBesideItsSentence) {
  const json fields = json::parse(to_json(make_result()));
  EXPECT_EQ(fields.at("limits_hit"),
            json({"the time budget ended the search", "a clique search ended before its proof"}));
  EXPECT_EQ(fields.at("limit_codes"), json({"time", "clique_search"}));
  std::set<std::string> codes;
  for (const Limit limit : kLimits) codes.insert(to_string(limit));
  EXPECT_EQ(codes.size(), std::size(kLimits)) << "two limits share a code";
  EXPECT_FALSE(codes.contains("unknown"));
}

TEST(ResultJson, SaysWhatTheOptionsDecideWhereTheyAreKnown) {
  Options options;
  options.noise_bound = 0.125;
  ReportContext context;
  context.options = &options;
  context.total_seconds = 3;
  Result result = make_result();
  json fields = json::parse(to_json(result, context));
  EXPECT_EQ(fields.at("noise_bound"), 0.125);
  EXPECT_EQ(fields.at("options").at("noise_bound"), 0.125);
  EXPECT_EQ(fields.at("options").at("evidence"), "distinct");
  EXPECT_EQ(fields.at("time_ms").at("total"), 3000);
  result.alternatives.clear();
  EXPECT_FALSE(json::parse(to_json(result, context)).contains("alternatives"));
  options.num_hypotheses = 2;
  fields = json::parse(to_json(result, context));
  EXPECT_EQ(fields.at("alternatives"), json::array());
  EXPECT_EQ(fields.at("runner_up_ratio"), 0);
  options.noise_bounds.assign(10, 0.5);
  EXPECT_FALSE(json::parse(to_json(result, context)).contains("noise_bound"));
  result.noise_estimate = NoiseEstimate{0.5, 0.25, 0.75, -12};
  fields = json::parse(to_json(result, context));
  EXPECT_EQ(fields.at("noise_bound"), 0.5);
  EXPECT_EQ(fields.at("noise_estimate"), json({{"noise_bound", 0.5},
                                               {"stable_min", 0.25},
                                               {"stable_max", 0.75},
                                               {"log10_false_alarms", -12}}));
}

TEST(ResultJson, WritesNullForWhatIsNotFiniteOrNotThere) {
  Result result = make_result();
  result.consistent_scales.max = std::numeric_limits<double>::infinity();
  result.covariance.reset();
  const json fields = json::parse(to_json(result));
  EXPECT_EQ(fields.at("consistent_scales"), json({1.9, nullptr}));
  EXPECT_EQ(fields.at("covariance"), nullptr);
}

TEST(ResultJson, IndentsOnlyWhereAsked) {
  EXPECT_EQ(to_json(make_result()).find('\n'), std::string::npos);
  EXPECT_NE(to_json(make_result(), {}, 2).find("\n  \"status\": \"ok\""), std::string::npos);
  EXPECT_EQ(json::parse(to_json(make_result())), json::parse(to_json(make_result(), {}, 2)));
}

TEST(ResultJson, SurvivesTextThatIsNoUtf8) {
  Result result = make_result();
  result.status_reason = "caf\xe9";
  EXPECT_EQ(json::parse(to_json(result)).at("status_reason"), "caf\xef\xbf\xbd");
}

TEST(ResultJson, SumsTheStagesOfInstancesAndListsEach) {
  Result second = make_result();
  second.inliers = {2, 3};
  const json fields = json::parse(to_json({make_result(), second}));
  EXPECT_EQ(fields.at("inliers"), json({1, 4, 7}));
  EXPECT_EQ(fields.at("time_ms"), json({{"total", 2000}, {"graph", 500}, {"clique", 3000}}));
  ASSERT_EQ(fields.at("instances").size(), 2u);
  EXPECT_EQ(fields.at("instances").at(1).at("inliers"), json({2, 3}));
  EXPECT_EQ(fields.at("instances").at(1).at("limit_codes"), json({"time", "clique_search"}));
  EXPECT_THROW(to_json(std::vector<Result>()), std::invalid_argument);
}

TEST(CloudResultJson, ListsInstancesWithTheirOwnVerdicts) {
  CloudResult second = make_cloud_result();
  second.verdict = Verdict::Untrusted;
  second.verdict_reason = "nothing meets";
  const json fields = json::parse(to_json(std::vector{make_cloud_result(), second}));
  EXPECT_EQ(fields.at("verdict"), "doubtful");
  EXPECT_EQ(fields.at("num_target_points"), 300);
  EXPECT_EQ(fields.at("time_ms").at("graph"), 500);
  ASSERT_EQ(fields.at("instances").size(), 2u);
  EXPECT_EQ(fields.at("instances").at(0).at("verdict"), "doubtful");
  EXPECT_EQ(fields.at("instances").at(1).at("verdict"), "untrusted");
  EXPECT_EQ(fields.at("instances").at(1).at("verdict_reason"), "nothing meets");
  const auto last_line = fields.at("report").back().at("text").get<std::string>();
  EXPECT_NE(last_line.find("untrusted"), std::string::npos) << last_line;
  EXPECT_THROW(to_json(std::vector<CloudResult>()), std::invalid_argument);
}

TEST(CloudResultJson, AddsWhatTwoCloudsSay) {
  const json fields = json::parse(to_json(make_cloud_result()));
  EXPECT_EQ(fields.at("num_inliers"), 3);
  EXPECT_EQ(fields.at("noise_bound"), 0.75);
  EXPECT_EQ(fields.at("num_source_points"), 200);
  EXPECT_EQ(fields.at("num_target_points"), 300);
  EXPECT_EQ(fields.at("num_source_voxels"), 20);
  EXPECT_EQ(fields.at("num_target_voxels"), 30);
  EXPECT_EQ(fields.at("fitness"), 0.6);
  EXPECT_EQ(fields.at("target_fitness"), 0.7);
  EXPECT_EQ(fields.at("overlap_rmse"), 0.1);
  EXPECT_EQ(fields.at("verdict"), "doubtful");
  EXPECT_EQ(fields.at("verdict_reason"), "few matches agree");
  EXPECT_EQ(fields.at("voxel_size"), 0.5);
  EXPECT_EQ(fields.at("source_voxel_size"), 0.25);
  EXPECT_EQ(fields.at("num_attempts"), 3);
  EXPECT_EQ(fields.at("refinement"), json({{"method", "icp"},
                                           {"applied", true},
                                           {"note", "ICP turned the pose"},
                                           {"noise", 0.02}}));
  const json& surfaces = fields.at("surfaces");
  EXPECT_EQ(surfaces.at("source_share"), 0.5);
  EXPECT_EQ(surfaces.at("target_share"), 0.4);
  EXPECT_EQ(surfaces.at("agreement"), 0.9);
  EXPECT_EQ(surfaces.at("noise"), 0.03);
  EXPECT_EQ(
      surfaces.at("weak_directions"),
      json::array({{{"kind", "shift"}, {"direction", {0.0, 1.0, 0.0}}, {"stiffness", 0.001}}}));
  EXPECT_EQ(fields.at("ambiguous"), true);
  EXPECT_EQ(fields.at("rivals").at(0).at("overlap"), 0.95);
  EXPECT_EQ(fields.at("rivals").at(0).at("is_symmetry"), true);
  EXPECT_EQ(fields.at("rivals").at(0).at("scale"), 1);
  EXPECT_EQ(fields.at("notes"), json::array({"the source is far away"}));
}

}  // namespace
}  // namespace gmcr
