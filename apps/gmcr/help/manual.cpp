#include "help/manual.hpp"

#include <fmt/core.h>

#include <sstream>

#include "gmcr/version.hpp"
#include "help/help.hpp"

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

}  // namespace gmcr::cli
