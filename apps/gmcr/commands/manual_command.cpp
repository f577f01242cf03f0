#include <fmt/core.h>

#include <memory>
#include <string>

#include "commands/commands.hpp"
#include "help/completion.hpp"
#include "help/manual.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kManualExamples = R"(Examples:
  gmcr manual > ~/.local/share/man/man1/gmcr.1 && man gmcr
  gmcr manual | man -l -)";

constexpr const char* kCompletionExamples =
    R"(The installed tool brings these scripts.

Examples:
  gmcr completion bash > ~/.local/share/bash-completion/completions/gmcr
  gmcr completion zsh > ~/.zfunc/_gmcr  # of a folder in $fpath
  gmcr completion fish > ~/.config/fish/completions/gmcr.fish
  source <(gmcr completion bash))";

struct Shell {
  const char* name;
  std::string (*script)(const CLI::App&);
};

constexpr Shell kShells[] = {
    {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

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
  CLI::App& command =
      *app.add_subcommand("completion", "Script that completes gmcr in bash, zsh or fish");
  const auto chosen = std::make_shared<Shell>(kShells[0]);
  std::string names;
  for (const Shell& shell : kShells) names += (names.empty() ? "" : "|") + std::string(shell.name);
  const auto parse = [chosen, names](const CLI::results_t& given) {
    for (const Shell& shell : kShells) {
      if (given.front() != shell.name) continue;
      *chosen = shell;
      return true;
    }
    throw CLI::ValidationError("SHELL", "'" + given.front() + "' is none of " + names);
  };
  command.add_option("SHELL", parse, "Shell to complete in: " + names)
      ->type_name(names)
      ->default_str(chosen->name)
      ->expected(1);
  command.footer(kCompletionExamples);
  command.callback([&app, &work, chosen] {
    work = [&app, chosen] {
      fmt::print("{}", chosen->script(app));
      return kPoseFound;
    };
  });
}

}  // namespace gmcr::cli
