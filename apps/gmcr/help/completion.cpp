#include "help/completion.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "help/help.hpp"

namespace gmcr::cli {
namespace {

/// Words such as "gmcr|paper" of what an option takes, separated by spaces; empty where it takes
/// something else.
std::string words_of(const CLI::Option& option) {
  std::string words = metavar_of(option);
  if (words.find('|') == std::string::npos) return "";
  std::replace(words.begin(), words.end(), '|', ' ');
  return words == "B auto" ? "auto" : words;
}

/// The same of an argument without a flag: `gmcr completion bash|zsh|fish`.
std::string words_of_argument(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    std::string words = option->get_positional() ? option->get_type_name() : "";
    if (words.find('|') == std::string::npos) continue;
    std::replace(words.begin(), words.end(), '|', ' ');
    return words;
  }
  return "";
}

std::string first_sentence(const std::string& text) { return text.substr(0, text.find(';')); }

/// Between single quotes: of zsh and bash a quote ends the string and is written outside of it, of
/// fish it is escaped.
std::string quoted(const std::string& text, const std::string& quote) {
  std::string safe = "'";
  for (const char letter : text) safe += letter == '\'' ? quote : std::string(1, letter);
  return safe + "'";
}

std::string zsh_item(const std::string& word, const std::string& help) {
  return "    " + quoted(word + ":" + first_sentence(help), "'\\''") + "\n";
}

/// Cases of bash and zsh that complete the values of the options of a command.
std::string value_cases(const CLI::App& command, const char* pattern) {
  std::string cases;
  for (const CLI::Option* option : command.get_options()) {
    const std::string words = words_of(*option);
    if (words.empty()) continue;
    std::vector<std::string> flags;
    for (const std::string& name : option->get_lnames()) {
      flags.push_back(command.get_name() + ":--" + name);
    }
    cases += fmt::format(fmt::runtime(pattern), fmt::join(flags, "|"), words);
  }
  const std::string words = words_of_argument(command);
  const std::string& name = command.get_name();
  return words.empty() ? cases
                       : cases + fmt::format(fmt::runtime(pattern), name + ":" + name, words);
}

std::string flag_words_of(const CLI::App& command) {
  std::string flags;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      flags += (flags.empty() ? "--" : " --") + name;
    }
  }
  return flags;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string commands, option_cases, cases;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    option_cases +=
        fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), flag_words_of(*command));
    cases += value_cases(*command, "    {}) words=\"{}\" ;;\n");
  }
  return fmt::format(R"(# bash completion of gmcr
_gmcr() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" previous="${{COMP_WORDS[COMP_CWORD-1]}}" words=""
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{} --help --version" -- "$current"))
    return
  fi
  case "${{COMP_WORDS[1]}}:$previous" in
{}  esac
  if [ -z "$words" ] && [ "${{current:0:1}}" = "-" ]; then
    case "${{COMP_WORDS[1]}}" in
{}    esac
  fi
  if [ -n "$words" ]; then
    COMPREPLY=($(compgen -W "$words" -- "$current"))
  fi
}}
complete -o default -F _gmcr gmcr
)",
                     commands, cases, option_cases);
}

std::string zsh_completion(const CLI::App& app) {
  std::string commands, option_cases, cases;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    commands += zsh_item(command->get_name(), command->get_description());
    std::string items;
    for (const CLI::Option* option : command->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        items += "  " + zsh_item("--" + name, help_of(*option));
      }
    }
    option_cases += fmt::format("    {}) items=(\n{}    ) ;;\n", command->get_name(), items);
    cases += value_cases(*command, "    {}) compadd -- {}; return ;;\n");
  }
  return fmt::format(R"(#compdef gmcr
_gmcr() {{
  local -a items
  if (( CURRENT == 2 )); then
    items=(
{}    )
    _describe command items
    return
  fi
  case "$words[2]:$words[CURRENT-1]" in
{}  esac
  if [[ "$words[CURRENT]" != -* ]]; then
    _files
    return
  fi
  case "$words[2]" in
{}  esac
  _describe -o option items
}}
if [ "$funcstack[1]" = _gmcr ]; then
  _gmcr "$@"
elif (( $+functions[compdef] )); then
  compdef _gmcr gmcr
fi
)",
                     commands, cases, option_cases);
}

std::string fish_completion(const CLI::App& app) {
  std::string script = "# fish completion of gmcr\n";
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    const std::string& name = command->get_name();
    const auto help = [](const std::string& text) { return quoted(first_sentence(text), "\\'"); };
    script += fmt::format("complete -c gmcr -f -n __fish_use_subcommand -a {} -d {}\n", name,
                          help(command->get_description()));
    const std::string given =
        fmt::format("complete -c gmcr -n '__fish_seen_subcommand_from {}'", name);
    const std::string argument = words_of_argument(*command);
    if (!argument.empty()) script += fmt::format("{} -f -a '{}'\n", given, argument);
    for (const CLI::Option* option : command->get_options()) {
      const std::string words = words_of(*option);
      std::string takes = metavar_of(*option).empty() ? "" : " -r";
      if (!words.empty()) takes = fmt::format(" -x -a '{}'", words);
      for (const std::string& flag : option->get_lnames()) {
        script += fmt::format("{} -l {}{} -d {}\n", given, flag, takes, help(help_of(*option)));
      }
    }
  }
  return script;
}

}  // namespace gmcr::cli
