#include <fmt/core.h>

#include "arguments/manual.hpp"
#include "commands/commands.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kManualExamples = R"(Examples:
  gmcr manual > ~/.local/share/man/man1/gmcr.1 && man gmcr
  gmcr manual | man -l -)";

constexpr const char* kCompletionExamples =
    R"(The installed tool brings it. For zsh, load bashcompinit first.

Examples:
  gmcr completion > ~/.local/share/bash-completion/completions/gmcr
  source <(gmcr completion))";

}  // namespace

void add_manual_command(CLI::App& app, Work& work) {
  CLI::App& command = *app.add_subcommand("manual", "Manual page of all commands, in roff");
  command.footer(kManualExamples);
  command.callback([&app, &work] {
    work = [&app] {
      fmt::print("{}", manual_page(app));
      return kPoseFound;
    };
  });
}

void add_completion_command(CLI::App& app, Work& work) {
  CLI::App& command = *app.add_subcommand("completion", "Script that completes gmcr in bash");
  command.footer(kCompletionExamples);
  command.callback([&app, &work] {
    work = [&app] {
      fmt::print("{}", bash_completion(app));
      return kPoseFound;
    };
  });
}

}  // namespace gmcr::cli
