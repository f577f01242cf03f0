#include "output/html_report.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "output/json_text.hpp"
#include "output/scratch_folder.hpp"

namespace gmcr::cli {
namespace {

namespace fs = std::filesystem;

/// Where the stderr of the Python program goes; its stdout never reaches that of the tool.
enum class Errors { Shown, Dropped };

/// What `-m gmcr.viz` does, but for packages of the working directory, whoever put them there.
constexpr const char* kRunViz =
    "import sys; sys.path[:] = [p for p in sys.path if p]; "  // "": the working directory
    "import runpy; runpy.run_module('gmcr.viz', run_name='__main__', alter_sys=True)";

/// Runs `python -m gmcr.viz ARGUMENTS`.
/// @return its exit code, or -1 where it could not be run or was killed.
int run_python(const std::vector<std::string>& arguments, Errors errors) {
  const char* python = std::getenv("GMCR_PYTHON");
  std::vector<std::string> words = {python != nullptr && *python != '\0' ? python : "python3", "-c",
                                    kRunViz};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (errors == Errors::Dropped) {
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  }
  posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return -1;
  HeldSignals::pass_to(child);
  int status = 0;
  pid_t ended = 0;
  do ended = waitpid(child, &status, 0);
  while (ended < 0 && errno == EINTR);
  HeldSignals::pass_to(0);
  if (ended < 0) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

void require_html_reports() {
  if (run_python({"check"}, Errors::Dropped) != 0) {
    throw std::invalid_argument(
        "--report needs the Python package gmcr with its viz extra: pip install '.[viz]' in its "
        "sources");
  }
}

void write_html_report(const fs::path& path, const std::string& result, const ReportInput& input) {
  check_output(path);
  const ScratchFolder folder;
  const fs::path result_path = folder / "result.json";
  const fs::path matches_path = folder / "matches.npy";
  write_json(result_path, result);
  write_matches(matches_path, input.matches.source, input.matches.target,
                input.matches.noise_bounds);
  std::vector<std::string> arguments = {"report", result_path.string(), "--matches",
                                        matches_path.string(), "--title=" + input.title};
  if (input.source && input.target) {
    const fs::path source_path = folder / "source.npy";
    const fs::path target_path = folder / "target.npy";
    write_cloud(source_path, *input.source);
    write_cloud(target_path, *input.target);
    arguments.insert(arguments.end(), {"--clouds", source_path.string(), target_path.string()});
  }
  // written aside too: it replaces an older report only when it is whole
  const fs::path page_path = folder / "report.html";
  arguments.insert(arguments.end(), {"--output", page_path.string()});
  const int exit_code = run_python(arguments, Errors::Shown);
  if (HeldSignals::came()) return;  // and ends the program with the folder
  if (exit_code != 0) {
    throw IoError(path, 0, fmt::format("no report: gmcr.viz ended with {}", exit_code));
  }
  std::ifstream page(page_path, std::ios::binary);
  write_text(path, std::string(std::istreambuf_iterator<char>(page), {}));
}

}  // namespace gmcr::cli
