#include <sstream>

#include "cli/tool.hpp"
#include "gmcr/io.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr {
namespace {

using test::expect_failure;
using test::run_tool;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

TEST(Spelling, OfACommandOrAnOptionIsAnsweredWithTheRightOne) {
  expect_failure("registr a b", 2, "no command 'registr'; did you mean register?");
  expect_failure("sovle m.csv", 2, "did you mean solve?");
  expect_failure("--halp", 2, "--halp: gmcr has no such option; did you mean --help?");
  expect_failure("help", 2, "no command 'help'; write gmcr --help");
  expect_failure("solve m.csv --noise-bond 1", 2,
                 "--noise-bond: gmcr solve has no such option; did you mean --noise-bound?");
  expect_failure("solve m.csv --noise-bond=1", 2, "did you mean --noise-bound?");
  expect_failure("register a b -voxel 1", 2, "did you mean --voxel?");
  expect_failure("register a b --max-rot 1", 2, "did you mean --max-rotation-error?");
  const auto far = run_tool("solve m.csv --qwertyuiop");
  EXPECT_EQ(far.exit_code, 2);
  EXPECT_EQ(far.err.find("did you mean"), std::string::npos) << far.err;
  EXPECT_NE(far.err.find("see gmcr solve --help"), std::string::npos) << far.err;
}

TEST(Help, SaysUnitsAndDefaultsInWords) {
  EXPECT_NE(run_tool("--help").out.find("Commands:\n  register"), std::string::npos);
  for (const char* command : {"register", "solve", "match", "clique", "synth", "eval", "info"}) {
    const std::string help = run_tool(std::string(command) + " --help").out;
    for (const char* noise : {"{false}", " x 3", "18446744073709551615", "inf;", "REQUIRED",
                              "FLOAT", "UINT", "INT", ":SIZE", "4294967296"}) {
      EXPECT_EQ(help.find(noise), std::string::npos) << command << " " << noise << "\n" << help;
    }
  }
  const std::string help = run_tool("register --help").out;
  for (const char* words : {"--max-tilt DEG", "(degrees, in [0, 180])", "default: no limit",
                            "--scale X", "--memory-limit BYTES"}) {
    EXPECT_NE(help.find(words), std::string::npos) << words << "\n" << help;
  }
  // whoever gives a length is told its unit
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" M  ") == std::string::npos && !line.ends_with(" M")) continue;
    std::string more;
    if (line.find("metres") == std::string::npos) std::getline(lines, more);
    EXPECT_NE((line + more).find("metres"), std::string::npos) << line;
  }
}

class StandardInput : public testing::Test {
 protected:
  StandardInput() {
    SyntheticOptions options;
    options.num_correspondences = 100;
    problem_ = make_synthetic(options);
    for (const char* name : {"m.csv", "m.npy"}) {
      write_matches(folder_ / name, problem_.source, problem_.target);
    }
    write_cloud(folder_ / "a.ply", problem_.source);
    write_cloud(folder_ / "b.pcd", problem_.target);
    write_transform(folder_ / "T.txt", problem_.target_from_source);
  }

  std::string file(const std::string& name) const { return quoted(folder_ / name); }

  TemporaryFolder folder_;
  SyntheticProblem problem_;
};

TEST_F(StandardInput, IsReadWhereAFileIsADash) {
  const auto pose = [](const std::string& arguments) {
    return test::run_json(arguments).at("target_from_source");
  };
  const auto expected = pose("solve " + file("m.csv") + " --noise-bound 0.01");
  EXPECT_EQ(pose("solve - --noise-bound 0.01 < " + file("m.csv")), expected);
  EXPECT_EQ(pose("solve - --noise-bound 0.01 < " + file("m.npy")), expected);
  const std::string match = " -o " + file("o.csv") + " --voxel 0.2";
  for (const std::string& clouds :
       {"- " + file("b.pcd") + " < " + file("a.ply"), file("a.ply") + " - < " + file("b.pcd")}) {
    EXPECT_EQ(run_tool("match " + clouds + match).exit_code, 0) << clouds;
  }
  EXPECT_EQ(run_tool("eval - " + file("T.txt") + " < " + file("T.txt")).exit_code, 0);
  folder_.write("g.clq", "p edge 3 2\ne 1 2\ne 2 3\n");
  EXPECT_EQ(test::run_json("clique - < " + file("g.clq")).at("clique_size"), 2);
}

TEST_F(StandardInput, IsCalledSoWhereItIsWrong) {
  folder_.write("bad.csv", "1,2,3,4,5,6\n1,2,3,4,5,nan\n");
  expect_failure("solve - --noise-bound 1 < " + file("bad.csv"), 3, "standard input:2: ");
  expect_failure("solve - --noise-bound 1 < /dev/null", 3, "standard input: empty");
  expect_failure("match - - -o x.csv < " + file("a.ply"), 2, "only one can be stdin");
}

TEST_F(StandardInput, OfAQuietCommandLeavesTheExitCodeAndTheFiles) {
  const std::string solve = "solve " + file("m.csv") + " --noise-bound 0.01 ";
  const auto quiet = run_tool(solve + "--quiet -o " + file("Q.txt"));
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "Q.txt"));
  EXPECT_NE(run_tool(solve).out, "");
  EXPECT_NE(run_tool(solve + "-q --json").out, "") << "what is asked for is printed";
  expect_failure("solve none.csv --noise-bound 1 -q", 3, "none.csv");
}

}  // namespace
}  // namespace gmcr
