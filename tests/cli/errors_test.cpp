#include "cli/tool.hpp"

namespace gmcr {
namespace {

using test::expect_failure;
using test::run_tool;
using test::TemporaryFolder;

const char* const kCommands[] = {"register", "localise", "solve", "match",  "prepare",   "clique",
                                 "synth",    "eval",     "info",  "manual", "completion"};

TEST(Help, OfEveryCommandHasAnExample) {
  for (const char* command : kCommands) {
    const auto output = run_tool(std::string(command) + " --help");
    EXPECT_EQ(output.exit_code, 0) << command;
    EXPECT_NE(output.out.find("Examples:\n  gmcr "), std::string::npos) << output.out;
    EXPECT_EQ(output.err, "");
  }
  EXPECT_NE(run_tool("--help").out.find("Examples:"), std::string::npos);
  EXPECT_EQ(run_tool("--version").exit_code, 0);
}

TEST(Help, GivesEachOptionItsNameAndItsAlias) {
  const std::string solve = run_tool("solve --help").out;
  for (const char* flags :
       {"--num-threads,--threads", "--num-hypotheses,--hypotheses", "--max-instances,--instances",
        "--gravity-max-tilt,--max-tilt", "--initial-pose-max-rotation,--max-rotation-error",
        "--estimate-scale", "--scale-mode", "--one-to-one", "--time-limit", "--memory-limit"}) {
    EXPECT_NE(solve.find(flags), std::string::npos) << flags;
  }
  const std::string clouds = run_tool("register --help").out;
  for (const char* flags : {"--voxel-size,--voxel", "--source-voxel-size,--source-voxel",
                            "--max-attempts,--attempts", "--no-mutual"}) {
    EXPECT_NE(clouds.find(flags), std::string::npos) << flags;
  }
}

TEST(Usage, ThatIsWrongIsRefusedOnOneLine) {
  expect_failure("", 2, "A command is required");
  expect_failure("frobnicate", 2, "frobnicate");
  expect_failure("info --wrong", 2, "--wrong");
  expect_failure("solve", 2, "MATCHES");
  expect_failure("solve m.csv --noise-bound 1 --wrong", 2, "--wrong");
  expect_failure("solve m.csv --noise-bound wide", 2, "--noise-bound");
  expect_failure("solve m.csv --noise-bound 1 --method best", 2, "'best' is none of gmcr|paper");
  expect_failure("solve m.csv --noise-bound 1 --evidence all", 2, "--evidence");
  expect_failure("solve m.csv --noise-bound 1 --scale 2 --estimate-scale", 2, "--scale");
  expect_failure("solve m.csv --noise-bound 1 --scale-range 1 2", 2, "--scale-range");
  expect_failure("register a.ply", 2, "TARGET");
  expect_failure("match a.ply b.ply", 2, "--output");
  expect_failure("synth", 2, "--output");
  expect_failure("eval T.txt", 2, "TRUTH");
  expect_failure("clique", 2, "GRAPH");
}

TEST(OptionValue, OutOfRangeIsRefusedByItsName) {
  const TemporaryFolder folder;
  const std::string matches =
      folder.write("m.csv", "0,0,0,0,0,0\n1,0,0,1,0,0\n0,2,0,0,2,0\n0,0,3,0,0,3\n").string();
  const std::string cloud = folder.write("c.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n").string();
  const std::string solve = "solve '" + matches + "' --noise-bound ";
  expect_failure(solve + "-1", 2, "--noise-bound");
  expect_failure(solve + "nan", 2, "--noise-bound");
  expect_failure(solve + "1 --threshold 1", 2, "--threshold");
  expect_failure(solve + "1 --scale -2", 2, "--scale");
  expect_failure(solve + "1 --threads -1", 2, "gmcr: --threads: -1 is not in [0, 1024]");
  expect_failure(solve + "1 --threads=-1", 2, "gmcr: --threads: -1 is not in [0, 1024]");
  expect_failure(solve + "1 --num-threads -1", 2, "gmcr: --num-threads: -1 is not");
  expect_failure(solve + "1 --threads some", 2, "--threads");
  expect_failure(solve + "1 --hypotheses 0", 2, "gmcr: --hypotheses: 0 is not at least 1");
  expect_failure(solve + "1 --instances 0", 2, "gmcr: --instances: 0 is not at least 1");
  expect_failure(solve + "1 --min-instance-share 0.5", 2, "--min-instance-share requires");
  expect_failure(solve + "1 --time-limit 0", 2, "--time-limit");
  expect_failure(solve + "1 --memory-limit 0", 2, "--memory-limit");
  expect_failure(solve + "1 --estimate-scale --scale-range 2 1", 2, "--scale-range");
  const std::string clouds = " '" + cloud + "' '" + cloud + "' ";
  expect_failure("register" + clouds + "--voxel -1", 2, "gmcr: --voxel: -1 is not at least 0");
  expect_failure("register" + clouds + "--voxel-size -1", 2, "gmcr: --voxel-size: -1");
  expect_failure("register" + clouds + "--max-ratio 2", 2, "--max-ratio");
  expect_failure("register" + clouds + "--attempts 0", 2, "gmcr: --attempts: 0 is not");
  expect_failure("register" + clouds + "--refine magic", 2, "--refine");
  expect_failure("match" + clouds + "--feature-radius 0 -o x.csv", 2, "--feature-radius");
  expect_failure("synth -o x.csv --outliers 2", 2, "gmcr: --outliers: 2, must be in [0, 1]");
  expect_failure("synth -o x.csv --kind cube", 2, "--kind");
}

TEST(File, ThatCannotBeReadOrWrittenIsNamed) {
  const TemporaryFolder folder;
  const auto path = [&](const std::string& name) { return (folder / name).string(); };
  const std::string cloud = folder.write("c.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n").string();
  const std::string truth = folder.write("T.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n").string();
  const std::string matches =
      folder.write("m.csv", "0,0,0,0,0,0\n1,0,0,1,0,0\n0,2,0,0,2,0\n0,0,3,0,0,3\n").string();
  expect_failure("solve " + path("none.csv") + " --noise-bound 1", 3, "none.csv: No such file");
  expect_failure("solve " + path("none.csv") + " --noise-bound 1 --json", 3, "none.csv");
  folder.write("bad.csv", "1,2,3,4,5,6\n1,2,3,4,5,nan\n");
  expect_failure("solve " + path("bad.csv") + " --noise-bound 1", 3, "bad.csv:2: ");
  expect_failure("solve " + matches + " --noise-bound 1 -o /nowhere/T.txt", 3, "/nowhere/T.txt");
  expect_failure("register " + cloud + " " + path("none.ply"), 3, "none.ply");
  expect_failure("register " + folder.write("e.ply", "").string() + " " + cloud, 3, "empty");
  expect_failure("match " + cloud + " " + path("a.foo") + " -o x.csv", 3, "unknown extension");
  expect_failure("clique " + path("g.clq"), 3, "g.clq");
  expect_failure(
      "clique " + folder.write("e.clq", "p edge 2 1\ne 1 2\n").string() + " --threads -1", 2,
      "--threads");
  expect_failure("clique " + folder.write("h.clq", "p edge 9999999 1\n").string(), 3, "bytes");
  expect_failure("eval " + path("none.txt") + " " + truth, 3, "none.txt");
  expect_failure("eval " + folder.write("r.json", "{").string() + " " + truth, 3, "no JSON");
  expect_failure("eval " + folder.write("r", " {").string() + " " + truth, 3, "no JSON");
  expect_failure("eval " + folder.write("s.json", "{}").string() + " " + truth, 3,
                 "target_from_source");
  expect_failure("synth -o /nowhere/m.csv", 3, "/nowhere/m.csv");
  expect_failure("synth -o m.csv --model " + path("none.ply"), 3, "none.ply");
}

TEST(Eval, OfAResultWithoutAPoseExitsWithOne) {
  const TemporaryFolder folder;
  const std::string truth = folder.write("T.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n").string();
  const std::string result = folder
                                 .write("r.json",
                                        R"({"status": "no_consensus",
                     "target_from_source": [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]})")
                                 .string();
  EXPECT_EQ(test::run_json("eval " + result + " " + truth, 1).at("status"), "no_consensus");
}

}  // namespace
}  // namespace gmcr
