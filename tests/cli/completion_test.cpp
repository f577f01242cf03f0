// The scripts that complete the tool, run by their shells, and the manual.
#include <sstream>

#include "cli/tool.hpp"

namespace gmcr {
namespace {

using test::run_tool;
using test::TemporaryFolder;

std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

bool has(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

/// What `shell` prints that runs `script` after it loaded its completion.
std::string in_shell(const std::string& shell, const std::string& script) {
  const TemporaryFolder folder;
  const auto loaded = folder.write("loaded", run_tool("completion " + shell).out);
  const auto path = folder.write("run", "source " + quoted(loaded) + "\n" + script);
  const std::string flags = shell == "bash"  ? " --norc "
                            : shell == "zsh" ? " -f "
                                             : " --no-config ";
  const std::string command =
      shell + flags + quoted(path) + " > " + quoted(folder / "out") + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << test::content_of(folder / "out");
  return test::content_of(folder / "out");
}

/// Words that bash offers for the last of those on the line, one a line.
std::string offered(const std::string& words, int last) {
  return in_shell("bash", "COMP_WORDS=(" + words + ")\nCOMP_CWORD=" + std::to_string(last) +
                              "\n_gmcr\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
}

/// What zsh is given to choose from for the last of the words; files are "(files)".
std::string offered_by_zsh(const std::string& words) {
  return in_shell("zsh", R"(
    compadd() { shift; print -l -- $@ }
    _describe() { print -l -- ${(P)@[-1]} }
    _files() { print '(files)' }
    words=()" + words + R"()
    CURRENT=$#words
    _gmcr)");
}

TEST(Completion, OffersCommandsOptionsAndWords) {
  EXPECT_EQ(offered("gmcr reg", 1), "register\n");
  EXPECT_EQ(offered("gmcr solve --noise-b", 2), "--noise-bound\n");
  EXPECT_EQ(offered("gmcr solve m.csv --method ''", 4), "gmcr\npaper\n");
  EXPECT_EQ(offered("gmcr register a.ply b.ply --refine n", 5), "none\n");
  EXPECT_EQ(offered("gmcr completion f", 2), "fish\n");
  EXPECT_EQ(offered("gmcr solve m", 2), "\n") << "files are left to the shell";
}

TEST(Completion, OfZshOffersTheSameWithWhatItIs) {
  if (!has("zsh")) GTEST_SKIP() << "no zsh";
  const std::string commands = offered_by_zsh("gmcr ''");
  EXPECT_NE(commands.find("register:"), std::string::npos) << commands;
  EXPECT_NE(offered_by_zsh("gmcr solve --").find("\n--noise-bound:Largest error of a right match"),
            std::string::npos);
  EXPECT_EQ(offered_by_zsh("gmcr solve m.csv --method ''"), "gmcr\npaper\n");
  EXPECT_EQ(offered_by_zsh("gmcr completion ''"), "bash\nzsh\nfish\n");
  EXPECT_EQ(offered_by_zsh("gmcr solve m"), "(files)\n");
}

TEST(Completion, OfFishOffersTheSameWithWhatItIs) {
  if (!has("fish")) GTEST_SKIP() << "no fish";
  const auto offered_by_fish = [](const std::string& line) {
    return in_shell("fish", "complete -C '" + line + "'\n");
  };
  EXPECT_NE(offered_by_fish("gmcr reg").find("register\t"), std::string::npos);
  EXPECT_NE(offered_by_fish("gmcr solve --noise-b").find("--noise-bound\tLargest error"),
            std::string::npos);
  EXPECT_EQ(offered_by_fish("gmcr solve --method p").substr(0, 5), "paper");
  EXPECT_EQ(offered_by_fish("gmcr completion z").substr(0, 3), "zsh");
  EXPECT_EQ(offered_by_fish("gmcr register --refine ").find("bash"), std::string::npos);
}

TEST(Completion, KnowsEveryOptionInEachShell) {
  const std::string zsh = run_tool("completion zsh").out, fish = run_tool("completion fish").out;
  std::istringstream words(offered("gmcr register --", 2));
  int count = 0;
  for (std::string word; words >> word; ++count) {
    EXPECT_NE(zsh.find("'" + word + ":"), std::string::npos) << word;
    EXPECT_NE(fish.find("from register' -l " + word.substr(2) + " "), std::string::npos) << word;
  }
  EXPECT_GT(count, 30);
  test::expect_failure("completion tcsh", 2, "'tcsh' is none of bash|zsh|fish");
}

TEST(Manual, NamesEveryOptionOfEveryCommand) {
  const std::string manual = run_tool("manual").out;
  for (const char* command : {"register", "solve", "match", "clique", "synth", "eval", "info"}) {
    EXPECT_NE(manual.find(".SS \"gmcr " + std::string(command) + "\""), std::string::npos);
    std::istringstream words(offered("gmcr " + std::string(command) + " --", 2));
    int count = 0;
    for (std::string word; words >> word; ++count) {
      std::string escaped;
      for (const char letter : word)
        escaped += letter == '-' ? std::string("\\-") : std::string(1, letter);
      EXPECT_NE(manual.find(escaped), std::string::npos) << command << " " << word;
    }
    EXPECT_GE(count, 2) << command;
  }
}

}  // namespace
}  // namespace gmcr
