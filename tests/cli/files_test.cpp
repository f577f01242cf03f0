#include <gtest/gtest.h>

#include <cmath>

#include "cli/tool.hpp"
#include "gmcr/io.hpp"

namespace gmcr {
namespace {

using test::expect_failure;
using test::TemporaryFolder;

/// A bumpy patch, as rows of text.
std::string patch(double shift, const std::string& more) {
  std::string text;
  for (int i = 0; i < 60 * 60; ++i) {
    const double x = i % 60 * 0.02 + shift, y = i / 60 * 0.02;
    const double z = 2 + 0.1 * std::sin(9 * x * x + 3 * y) + 0.08 * std::cos(11 * y * y - 4 * x);
    text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + more + "\n";
  }
  return text;
}

const std::string kTwoTriangles = "OFF\n4 2 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n3 0 1 2\n3 0 2 3\n";

TEST(Outputs, ThatCannotBeWrittenEndTheToolBeforeItReads) {
  const TemporaryFolder folder;
  const std::string none = (folder / "none.ply").string();  // which would be the next error
  const std::string clouds = "register " + none + " " + none;
  for (const char* flag : {"-o", "--aligned", "--matches", "--json-file"}) {
    expect_failure(clouds + " " + flag + " /nowhere/a.csv", 3,
                   "/nowhere/a.csv: cannot be written: folder /nowhere: No such file");
  }
  expect_failure(clouds + " --aligned a.foo", 3, "a.foo: unknown extension");
  expect_failure(clouds + " --matches a.ply", 3, "a.ply: unknown extension");
  expect_failure("match " + none + " " + none + " -o /nowhere/m.csv", 3, "/nowhere/m.csv");
  expect_failure("solve " + none + " --noise-bound 1 --inliers /nowhere/i.txt", 3,
                 "/nowhere/i.txt");
  expect_failure("synth -o m.foo", 3, "m.foo: unknown extension");
}

TEST(Outputs, ThatWouldBeLostOrAreNotMeantAreRefusedBeforeTheToolReads) {
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder / name).string(); };
  const std::string a = folder.write("a.ply", "").string(), b = folder.write("b.ply", "").string();
  const std::string clouds = "register " + a + " " + b;
  std::filesystem::create_symlink(a, path("link.ply"));
  for (const char* name : {"a.ply", "b.ply", "link.ply", "./a.ply"}) {
    expect_failure(clouds + " --aligned " + path(name), 2, "written over a file that is read");
  }
  expect_failure(clouds + " -o x.txt --json-file x.txt", 2, "over another file that is written");
  expect_failure(clouds + " --aligned x.csv --matches ./x.csv", 2, "over another file");
  expect_failure("localise " + a + " " + b + " --aligned " + b, 2, "a file that is read");
  expect_failure("prepare " + a + " -o " + a, 2, "a file that is read");
  expect_failure("match " + a + " m.csv -o m.csv", 2, "a file that is read");
  expect_failure("solve m.csv --noise-bound 1 --inliers m.csv", 2, "a file that is read");
  expect_failure("synth -o m.csv --truth m.csv", 2, "another file that is written");
  for (const char* name : {"T.ply", "T.PCD", "T.xyz", "T.las", "T.npy"}) {
    expect_failure(clouds + " -o " + name, 2,
                   "--aligned of register and localise writes the moved");
  }
  for (const char* flag : {"-o", "--aligned", "--matches", "--json-file"}) {
    expect_failure(clouds + " " + flag + " ''", 2, "'' is no file");
  }
  expect_failure("synth -o ''", 2, "'' is no file");
  const auto output =
      test::run_tool("synth -o " + path("m.csv") + " --truth /dev/null --inliers /dev/null");
  EXPECT_EQ(output.exit_code, 0) << output.err;
}

TEST(StandardOutput, ThatIsFullIsAnError) {
  const char* binary = std::getenv("GMCR_BIN");
  for (const char* arguments : {"info", "info --json", "--help"}) {
    const std::string command =
        "'" + std::string(binary ? binary : "gmcr") + "' " + arguments + " >/dev/full 2>/dev/null";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 3) << arguments;
  }
}

TEST(Pipe, IsReadOnceWhateverItHolds) {
  const TemporaryFolder folder;
  const std::string cloud = folder.write("a.xyz", patch(0, "")).string();
  const Points points = read_cloud(cloud).points;
  const std::string rest = " " + cloud + " --voxel 0.1 -o " + (folder / "m.csv").string();
  for (const auto& [pipe, of] : {std::pair{"p.ply", "a.ply"},
                                 {"p.pcd", "a.pcd"},
                                 {"p.npy", "a.npy"},
                                 {"p.csv", "a.csv"},
                                 {"p.txt", "a.txt"},
                                 {"p", "a.ply"},
                                 {"q", "a.csv"}}) {
    write_cloud(folder / of, points);
    const std::string path = (folder / pipe).string();
    const std::string fill = "mkfifo " + path + "; cat " + (folder / of).string() + " > " + path;
    ASSERT_EQ(std::system((fill + " &").c_str()), 0);
    EXPECT_EQ(test::run_json("match " + path + rest).at("num_source_points"), points.cols())
        << pipe;
  }
  expect_failure("solve /dev/null --noise-bound 1", 3, "/dev/null: file is empty");
}

TEST(Gzip, IsSaidToBeSo) {
  const TemporaryFolder folder;
  const std::string bytes = "\x1F\x8B\x08 and more";
  for (const char* name : {"a.ply", "a.csv", "a.bin", "a.xyz.gz"}) {
    const std::string path = folder.write(name, bytes).string();
    expect_failure("match " + path + " " + path + " -o m.csv", 3, "compressed by gzip: unpack it");
  }
}

TEST(Pose, MayBeTheJsonOfAResult) {
  const TemporaryFolder folder;
  const auto matches = folder / "m.csv";
  Points source(3, 30);
  for (Index i = 0; i < 30; ++i) source.col(i) << i % 5, i * i % 7, i * 3 % 11;
  write_matches(matches, source, source);
  const std::string solve = "solve " + matches.string() + " --noise-bound 0.1";
  const std::string result = folder.write("r.json", test::run_json(solve).dump()).string();
  EXPECT_LT(test::run_json("eval " + result + " " + result).at("rotation_error_deg"), 1e-9);
  test::run_json(solve + " --max-rotation-error 5 --initial-pose " + result);
  const std::string far = folder.write("far.txt", "1 0 0 99\n0 1 0 0\n0 0 1 0\n0 0 0 1\n").string();
  const auto no_pose =
      test::run_json(solve + " --max-translation-error 0.01 --initial-pose " + far, 1);
  const std::string none = folder.write("none.json", no_pose.dump()).string();
  expect_failure("eval " + result + " " + none, 3, "has no pose");
}

TEST(Aligned, KeepsTheFieldsOfTheSource) {
  const TemporaryFolder folder;
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3600\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nproperty float nx\nproperty float ny\n"
      "property float nz\nend_header\n";
  const auto source = folder.write("a.ply", header + patch(0, " 200 0 0 1"));
  const auto target = folder.write("b.xyz", patch(0.1, ""));
  const auto aligned = folder / "c.ply";
  const auto output = test::run_tool("register " + source.string() + " " + target.string() +
                                     " --aligned " + aligned.string());
  ASSERT_EQ(output.exit_code, 0) << output.err;
  const std::string bytes = test::content_of(aligned);
  EXPECT_NE(bytes.find("element vertex 3600\n"), std::string::npos);
  EXPECT_NE(bytes.find("property uchar red\n"), std::string::npos);
  EXPECT_NE(bytes.find("property double nz\n"), std::string::npos);
  EXPECT_EQ(read_cloud(aligned).points.cols(), 3600);
}

TEST(Mesh, IsSampledWithAWordAndAsTheFlagSays) {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("a.off", kTwoTriangles).string();
  const std::string match =
      "match " + mesh + " " + mesh + " --voxel 0.1 -o " + (folder / "m.csv").string();
  const auto output = test::run_tool(match + " --mesh-points 500 --json");
  ASSERT_EQ(output.exit_code, 0) << output.err;
  EXPECT_NE(output.err.find("500 points are spread over its surface"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(output.out).at("num_source_points"), 500);
  const auto vertices = test::run_tool(match + " --mesh-points 0 --json");
  EXPECT_EQ(nlohmann::json::parse(vertices.out).at("num_source_points"), 4);
  expect_failure(match + " --mesh-points -1", 2, "--mesh-points");
}

TEST(BinaryScan, IsReadAsTheFlagSays) {
  const TemporaryFolder folder;
  const std::string scan = folder.write("a.bin", std::string(480, '@')).string();
  const std::string match =
      "match " + scan + " " + scan + " --voxel 1 -o " + (folder / "m.csv").string() + " --json";
  for (const int columns : {3, 4, 5}) {
    const auto output = test::run_tool(match + " --bin-columns " + std::to_string(columns));
    EXPECT_EQ(nlohmann::json::parse(output.out).at("num_source_points"), 480 / 4 / columns);
  }
  expect_failure(match + " --bin-columns 2", 2, "bin_columns");
  expect_failure(match + " --bin-columns 7", 3, "multiple of 28");
}

TEST(SeventhColumn, ThatMayBeAScoreIsNotTakenForMetres) {
  const TemporaryFolder folder;
  std::string rows;
  for (int i = 0; i < 20; ++i) {
    const std::string point =
        std::to_string(i % 5) + "," + std::to_string(i * i % 7) + "," + std::to_string(i * 3 % 11);
    rows += point + "," + point + ",0." + std::to_string(95 - i) + "\n";
  }
  const std::string bare = folder.write("a.csv", rows).string();
  expect_failure("solve " + bare, 3, "noise bounds in metres, or scores?");
  expect_failure("solve " + bare + " --noise-bound 0.1", 3, "or scores?");
  const std::string named = folder.write("b.csv", "x1,y1,z1,x2,y2,z2,score\n" + rows).string();
  const auto output = test::run_tool("solve " + named + " --noise-bound 0.1");
  EXPECT_EQ(output.exit_code, 0) << output.err;
  EXPECT_NE(output.err.find("not used: column 'score'"), std::string::npos) << output.err;
}

}  // namespace
}  // namespace gmcr
