#include <sched.h>

#include "cli/tool.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::run_json;
using test::TemporaryFolder;

TEST(CliqueContract, CountsVerticesAsTheFile) {
  const TemporaryFolder folder;
  const auto path = folder.write("g.clq", "p edge 5 4\ne 2 3\ne 3 5\ne 2 5\ne 1 2\n");
  const json result = run_json("clique '" + path.string() + "'");
  EXPECT_EQ(result.at("vertices"), json({2, 3, 5}));
  EXPECT_EQ(result.at("clique_size"), 3);
  EXPECT_EQ(result.at("upper_bound"), 3);
  EXPECT_EQ(result.at("proven_optimal"), true);
  EXPECT_EQ(result.at("num_edges"), 4);
}

TEST(InfoContract, SaysVersionAndDefaults) {
  const json result = run_json("info");
  EXPECT_TRUE(result.at("version").is_string());
  EXPECT_EQ(result.at("defaults").at("num_hypotheses"), Options{}.num_hypotheses);
  EXPECT_EQ(result.at("defaults").at("hypotheses"), Options{}.num_hypotheses);
  EXPECT_EQ(result.at("defaults").at("attempts"), FrontendOptions{}.max_attempts);
  EXPECT_EQ(result.at("defaults").at("min_instance_inliers"), 8);
  EXPECT_EQ(result.at("defaults").at("orientation"), "automatic");
  EXPECT_EQ(result.at("defaults").at("time_limit"), Options{}.time_limit);
}

TEST(InfoContract, CountsTheThreadsThatTheProcessMayUse) {
  cpu_set_t all;
  ASSERT_EQ(sched_getaffinity(0, sizeof(all), &all), 0);
  EXPECT_EQ(run_json("info").at("threads"), CPU_COUNT(&all));
  cpu_set_t one;
  CPU_ZERO(&one);
  for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu) {
    if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &one);
  }
  ASSERT_EQ(sched_setaffinity(0, sizeof(one), &one), 0);
  const json restricted = run_json("info");
  ASSERT_EQ(sched_setaffinity(0, sizeof(all), &all), 0);
  EXPECT_EQ(restricted.at("threads"), 1);
}

}  // namespace
}  // namespace gmcr
