#include "arguments/manual.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "arguments/help.hpp"
#include "gmcr/version.hpp"

namespace gmcr::cli {
namespace {

/// Text that roff takes as it is.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    if (letter == '\\') {
      safe += "\\e";
    } else if (letter == '-') {
      safe += "\\-";
    } else {
      safe += letter;
    }
  }
  // a line that starts with a dot or a quote would be a request
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

std::string lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::string lines;
  for (std::string line; std::getline(stream, line);) lines += escaped(line) + "\n";
  return lines;
}

void add_option(std::string& page, const CLI::Option& option) {
  std::string names = "\\fB" + escaped(names_of(option)) + "\\fR";
  const std::string metavar = metavar_of(option);
  if (!metavar.empty()) names += " \\fI" + escaped(metavar) + "\\fR";
  page += ".TP\n" + names + "\n" + escaped(help_of(option)) + "\n";
}

void add_command(std::string& page, const CLI::App& command) {
  page +=
      fmt::format(".SS \"gmcr {}\"\n{}.\n", command.get_name(), escaped(command.get_description()));
  for (const CLI::Option* option : command.get_options()) add_option(page, *option);
  page += ".PP\n.nf\n" + lines_of(command.get_footer()) + ".fi\n";
}

/// Words such as "gmcr|paper" of what an option takes, separated by spaces; empty where it takes
/// something else.
std::string words_of(const CLI::Option& option) {
  std::string words = metavar_of(option);
  if (words.find('|') == std::string::npos) return "";
  std::replace(words.begin(), words.end(), '|', ' ');
  return words == "B auto" ? "auto" : words;
}

/// Cases of the shell that complete the values of the options of a command.
std::string value_cases(const CLI::App& command) {
  std::string cases;
  for (const CLI::Option* option : command.get_options()) {
    const std::string words = words_of(*option);
    if (words.empty()) continue;
    std::vector<std::string> flags;
    for (const std::string& name : option->get_lnames()) {
      flags.push_back(command.get_name() + ":--" + name);
    }
    cases += fmt::format("    {}) words=\"{}\" ;;\n", fmt::join(flags, "|"), words);
  }
  return cases;
}

std::string flags_of_command(const CLI::App& command) {
  std::string flags;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      flags += (flags.empty() ? "--" : " --") + name;
    }
  }
  return flags;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = fmt::format(
      ".TH GMCR 1 \"\" \"gmcr {}\" \"User Commands\"\n"
      ".SH NAME\ngmcr \\- registration of 3\\-D point sets by maximum consensus\n"
      ".SH SYNOPSIS\n.B gmcr\n\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n{}",
      kVersion, lines_of(app.get_description()));
  page +=
      ".PP\nA file that is read may be \\fB\\-\\fR: it then comes from standard input. The options "
      "of a command are those that \\fBgmcr\\fR \\fICOMMAND\\fR \\fB\\-\\-help\\fR names.\n"
      ".SH COMMANDS\n";
  for (const CLI::App* command : app.get_subcommands(nullptr)) add_command(page, *command);
  page +=
      ".SH EXIT STATUS\n.TP\n0\nA pose was found, or what was asked for is done.\n"
      ".TP\n1\nNo pose was found, or none of the verdict that \\fB\\-\\-require\\fR asks for.\n"
      ".TP\n2\nThe command line or an option is wrong.\n"
      ".TP\n3\nA file cannot be read or written.\n"
      ".SH ENVIRONMENT\n.TP\nNO_COLOR\nSet and not empty: no colours.\n"
      ".TP\nTERM\n\\fBdumb\\fR: no colours, and progress on lines of their own.\n"
      ".TP\nGMCR_PYTHON\nThe Python that makes reports; else \\fBpython3\\fR.\n";
  return page;
}

std::string bash_completion(const CLI::App& app) {
  std::string commands, option_cases, cases;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    commands += (commands.empty() ? "" : " ") + command->get_name();
    option_cases +=
        fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), flags_of_command(*command));
    cases += value_cases(*command);
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

}  // namespace gmcr::cli
