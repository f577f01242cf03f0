// What the world does to a program: kills, full disks, readers that go away.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>

#include "cli/tool.hpp"

namespace gmcr {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::TemporaryFolder;

/// Whether a sanitizer takes all address space, and does what valgrind does.
constexpr bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return true;
#else
  return false;
#endif
}

/// How a command of bash ended; `$GMCR_BIN` is the tool.
int status_of(const std::string& script, const fs::path& folder) {
  const std::string command = "cd '" + folder.string() + "' && exec bash -c '" + script + "'";
  return std::system(command.c_str());
}

std::size_t num_files(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A folder with an older `m.csv`, which a command is about to replace by a longer one.
class Replaced : public ::testing::Test {
 protected:
  void SetUp() override { folder_.write("m.csv", "old"); }

  static constexpr const char* kSynth = "\"$GMCR_BIN\" synth --num 20000 -o m.csv >/dev/null 2>err";

  void expect_as_it_was(std::size_t num_others) const {
    EXPECT_EQ(content_of(folder_ / "m.csv"), "old");
    EXPECT_EQ(num_files(folder_ / ""), 1 + num_others);
  }

  TemporaryFolder folder_;
};

TEST_F(Replaced, FileStaysWholeWhereTheToolIsKilledInMidWrite) {
  // the kernel ends a program whose file grows beyond the limit, wherever that is
  const int status = status_of(std::string("ulimit -f 100; exec ") + kSynth, folder_ / "");
  ASSERT_TRUE(WIFSIGNALED(status)) << status;
  EXPECT_EQ(WTERMSIG(status), SIGXFSZ);
  expect_as_it_was(1);  // err
}

TEST_F(Replaced, FileStaysWholeWhereTheDiskIsFull) {
  const int status =
      status_of(std::string("trap \"\" XFSZ; ulimit -f 100; exec ") + kSynth, folder_ / "");
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_NE(content_of(folder_ / "err").find("m.csv: cannot be written: File too large"),
            std::string::npos);
  expect_as_it_was(1);
}

TEST_F(Replaced, FileStaysWholeWhereTheToolIsInterrupted) {
  // in the middle of a search that takes minutes, or before
  const std::string script =
      std::string("\"$GMCR_BIN\" synth --num 3000 --outliers 0.95 -o in.csv ") +
      ">/dev/null 2>&1; \"$GMCR_BIN\" solve in.csv --noise-bound 1 " +
      "--certify --time-limit 100 -o m.csv >/dev/null 2>err & " +
      "sleep 0.5; kill -INT $!; wait $!";
  // bash starts what runs beside it deaf to SIGINT, but for job control
  const int status = status_of("set -m; " + script, folder_ / "");
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 128 + SIGINT);
  expect_as_it_was(2);  // in.csv, err
}

TEST_F(Replaced, FileIsReplacedWhereNothingGoesWrong) {
  ASSERT_EQ(status_of(kSynth, folder_ / ""), 0);
  EXPECT_GT(content_of(folder_ / "m.csv").size(), 100U * 1024U);
  EXPECT_EQ(num_files(folder_ / ""), 2U);
}

TEST(Report, ThatIsInterruptedLeavesNeitherItsFolderNorItsPython) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "tmp");
  folder.write("python",
               "#!/bin/sh\n"
               "case \"$*\" in *check) exit 0 ;; esac\n"
               "echo $$ > started; exec sleep 60\n");
  fs::permissions(folder / "python", fs::perms::owner_all);
  ASSERT_EQ(status_of("\"$GMCR_BIN\" synth --num 100 -o m.csv >/dev/null 2>&1", folder / ""), 0);
  for (const char* signal : {"INT", "TERM"}) {
    fs::remove(folder / "started");
    const std::string script =
        std::string("set -m; export TMPDIR=$PWD/tmp GMCR_PYTHON=$PWD/python; \"$GMCR_BIN\" ") +
        "solve m.csv --noise-bound 0.01 --report r.html >out 2>err & " +
        "for i in $(seq 200); do [ -s started ] && break; sleep 0.05; done; " +
        "[ \"$(ls tmp | wc -l)\" = 1 ] || exit 5; kill -" + signal + " $!; wait $!";
    const int status = status_of(script, folder / "");
    ASSERT_TRUE(WIFEXITED(status)) << status;
    EXPECT_EQ(WEXITSTATUS(status), 128 + (signal[0] == 'I' ? SIGINT : SIGTERM));
    EXPECT_EQ(num_files(folder / "tmp"), 0U);
    EXPECT_NE(status_of("kill -0 $(cat started) 2>/dev/null", folder / ""), 0);
    EXPECT_FALSE(fs::exists(folder / "r.html"));
  }
}

TEST(ClosedPipe, EndsTheToolQuietly) {
  const TemporaryFolder folder;
  const std::string read_nothing =
      "(sleep 0.2; \"$GMCR_BIN\" solve --help 2>err; "
      "echo $? >code) | true";
  ASSERT_EQ(status_of(read_nothing, folder / ""), 0);
  EXPECT_EQ(content_of(folder / "err"), "");
  EXPECT_EQ(content_of(folder / "code"), std::to_string(128 + SIGPIPE) + "\n");
  // a parent that ignores the signal, as servers do, is told by the exit code
  const std::string deaf = "trap \"\" PIPE; " + read_nothing;
  ASSERT_EQ(status_of(deaf, folder / ""), 0);
  EXPECT_NE(content_of(folder / "err").find("standard output"), std::string::npos);
  EXPECT_EQ(content_of(folder / "code"), "3\n");
}

TEST(StandardError, ThatIsFullChangesNoExitCode) {
  const TemporaryFolder folder;
  for (const char* stream : {"/dev/full", "&-"}) {
    const std::string redirected = std::string(" 2>") + stream;
    const int status = status_of("exec \"$GMCR_BIN\" frobnicate" + redirected, folder / "");
    ASSERT_TRUE(WIFEXITED(status)) << stream;
    EXPECT_EQ(WEXITSTATUS(status), 2) << stream;
    const int fine = status_of("exec \"$GMCR_BIN\" info >out" + redirected, folder / "");
    EXPECT_EQ(fine, 0) << stream;
  }
}

TEST(Memory, ThatIsRefusedIsAClearError) {
  if (is_sanitized()) GTEST_SKIP() << "an allocator of its own";
  const TemporaryFolder folder;
  // what is allowed holds the tool, but not a file of 30 MB and its points
  ASSERT_EQ(status_of("\"$GMCR_BIN\" synth --num 300000 -o m.csv >/dev/null 2>&1", folder / ""), 0);
  const int status =
      status_of("ulimit -v 90000; \"$GMCR_BIN\" solve m.csv --noise-bound 1 --threads 1 >out 2>err",
                folder / "");
  ASSERT_TRUE(WIFEXITED(status)) << status;
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_NE(content_of(folder / "err").find("not enough memory"), std::string::npos);
  EXPECT_EQ(content_of(folder / "out"), "");
}

TEST(Valgrind, FindsNothingInASolveOrARegistration) {
  const TemporaryFolder folder;
  if (is_sanitized()) GTEST_SKIP() << "the sanitizer looks";
  if (status_of("command -v valgrind >/dev/null", folder / "") != 0) GTEST_SKIP() << "no valgrind";
  std::string cloud;
  for (int i = 0; i < 400; ++i) {
    const double x = 0.1 * (i % 20), y = 0.1 * (i / 20);
    cloud += std::to_string(x) + " " + std::to_string(y) + " " +
             std::to_string(0.2 * x * x - 0.1 * x * y + 0.3 * y) + "\n";
  }
  folder.write("a.xyz", cloud);
  ASSERT_EQ(status_of("\"$GMCR_BIN\" synth --num 60 -o m.csv >/dev/null 2>&1", folder / ""), 0);
  const std::string checked =
      "valgrind --quiet --error-exitcode=9 --leak-check=full --show-leak-kinds=definite "
      "--errors-for-leak-kinds=definite "
      "\"$GMCR_BIN\" ";
  for (const std::string arguments :
       {"solve m.csv --noise-bound 0.01 --estimate-scale --certify --hypotheses 2 -o T.txt",
        "solve m.csv --noise-bound auto --json",
        "register a.xyz a.xyz --voxel 0.12 --attempts 1"}) {
    const int status = status_of(checked + arguments + " --threads 2 >out 2>err", folder / "");
    ASSERT_TRUE(WIFEXITED(status)) << arguments;
    EXPECT_LT(WEXITSTATUS(status), 2) << arguments << "\n" << content_of(folder / "err");
    EXPECT_EQ(content_of(folder / "err").find("=="), std::string::npos)
        << content_of(folder / "err");
  }
}

}  // namespace
}  // namespace gmcr
