#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gmcr::cli {

/// "-o,--output", "--mutual,--no-mutual", or the name of what has no dashes.
std::string names_of(const CLI::Option& option);

/// What it takes, such as "M", "MIN MAX" or "icp|none"; empty for a switch.
std::string metavar_of(const CLI::Option& option);

/// Its description with its default, and the options that it needs.
std::string help_of(const CLI::Option& option);

/// Help in the words of the field: "--scale X" and "(default: 1)", where CLI11 writes
/// "--scale FLOAT=1", "{false}" and "x 3".
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();

  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace gmcr::cli
