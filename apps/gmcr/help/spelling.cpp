#include "help/spelling.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <limits>

namespace gmcr::cli {
namespace {

/// Insertions, deletions, replacements and swaps of neighbours that lead from a to b.
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = edits[i][j];
      if (i == 0 || j == 0) {
        least = i + j;
        continue;
      }
      least = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1,
                        edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        least = std::min(least, edits[i - 2][j - 2] + 1);
      }
    }
  }
  return edits[a.size()][b.size()];
}

std::string with_suggestion(const std::string& problem, const std::string& word,
                            const std::vector<std::string>& known) {
  const std::optional<std::string> meant = nearest_word(word, known);
  return meant ? fmt::format("{}; did you mean {}?", problem, *meant) : problem;
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> flags_of_command(const CLI::App& command) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    for (const std::string& name : option->get_snames()) flags.push_back("-" + name);
  }
  return flags;
}

/// Whether a word is written as an option: "-5" and "-" are not.
bool looks_like_flag(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         (word[1] == '-' || std::isalpha(static_cast<unsigned char>(word[1])) != 0);
}

/// Whether it starts with a short option and goes on with its value, such as "-oT.txt".
bool is_short(const std::string& word, const std::vector<std::string>& flags) {
  return word[1] != '-' && std::find(flags.begin(), flags.end(), word.substr(0, 2)) != flags.end();
}

}  // namespace

std::optional<std::string> nearest_word(const std::string& word,
                                        const std::vector<std::string>& known) {
  constexpr std::size_t kShortest = 4;  // letters and dashes of a start that names one word
  std::optional<std::string> nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string& candidate : known) {
    std::size_t edits = edits_between(word, candidate);
    const bool is_start = word.size() >= kShortest && candidate.starts_with(word);
    if (is_start) edits = std::min<std::size_t>(edits, 1);
    if (edits > std::max<std::size_t>(1, word.size() / 3) || edits >= least) continue;
    least = edits;
    nearest = candidate;
  }
  return nearest;
}

std::optional<std::string> unknown_word(const CLI::App& app, int argc, char** argv) {
  if (argc < 2) return std::nullopt;
  const std::string name = argv[1];
  if (looks_like_flag(name)) {
    const std::vector<std::string> flags = flags_of_command(app);
    const bool is_known = std::find(flags.begin(), flags.end(), name) != flags.end();
    if (is_known || is_short(name, flags)) return std::nullopt;
    return with_suggestion(fmt::format("{}: gmcr has no such option", name), name, flags);
  }
  const std::vector<std::string> commands = names_of_commands(app);
  if (nearest_word(name, {"help"})) {
    return fmt::format("there is no command '{}'; write gmcr --help, or gmcr COMMAND --help", name);
  }
  if (std::find(commands.begin(), commands.end(), name) == commands.end()) {
    return with_suggestion(fmt::format("there is no command '{}'", name), name, commands);
  }
  const std::vector<std::string> flags = flags_of_command(*app.get_subcommand(name));
  for (int i = 2; i < argc; ++i) {
    const std::string word = std::string(argv[i]).substr(0, std::string(argv[i]).find('='));
    if (word == "--") break;
    if (!looks_like_flag(word) || is_short(word, flags)) continue;
    if (std::find(flags.begin(), flags.end(), word) != flags.end()) continue;
    const std::string dashes = word[1] == '-' ? "" : "-";  // "-voxel" for "--voxel"
    return with_suggestion(fmt::format("{}: gmcr {} has no such option", word, name), dashes + word,
                           flags);
  }
  return std::nullopt;
}

}  // namespace gmcr::cli
