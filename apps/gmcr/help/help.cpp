#include "help/help.hpp"

#include <fmt/ranges.h>

#include <utility>
#include <vector>

namespace gmcr::cli {
namespace {

constexpr std::size_t kColumnWidth = 34;

}  // namespace

std::string names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names.empty() ? option.get_name(true, false) : fmt::format("{}", fmt::join(names, ","));
}

std::string metavar_of(const CLI::Option& option) {
  if (option.get_type_size() == 0 || option.get_positional()) return "";
  const std::string name = option.get_type_name();
  return name.substr(0, name.find(':'));  // a validator adds what it takes
}

std::string help_of(const CLI::Option& option) {
  std::string help = option.get_description();
  if (option.get_required() && !option.get_positional()) help += "; required";
  const std::string& value = option.get_default_str();
  if (option.get_type_size() != 0 && !value.empty()) help += fmt::format("; default: {}", value);
  for (const CLI::Option* needed : option.get_needs()) {
    help += fmt::format("; needs --{}", needed->get_lnames().front());
  }
  return help;
}

HelpFormatter::HelpFormatter() { column_width(kColumnWidth); }

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  std::string usage = "Usage: " + (name.empty() ? app->get_name() : name);
  if (!app->get_subcommands(nullptr).empty()) return usage + " COMMAND [OPTIONS]\n";
  for (const CLI::Option* option : app->get_options()) {
    if (option->get_positional()) usage += " " + names_of(*option);
  }
  for (const CLI::Option* option : app->get_options()) {
    if (!option->get_positional() && option->get_required()) {
      usage += fmt::format(" --{} {}", option->get_lnames().front(), metavar_of(*option));
    }
  }
  return usage + " [OPTIONS]\n";
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
  for (std::size_t at = help.find("\n\n\n"); at != std::string::npos;
       at = help.find("\n\n\n", at)) {
    help.erase(at, 1);
  }
  return help;
}

std::string HelpFormatter::make_option_name(const CLI::Option* option, bool) const {
  return names_of(*option);
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  const std::string metavar = metavar_of(*option);
  return metavar.empty() ? "" : " " + metavar;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return help_of(*option);
}

}  // namespace gmcr::cli
