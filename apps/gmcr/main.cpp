#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include "arguments/option_flags.hpp"
#include "commands/commands.hpp"
#include "gmcr/invalid_option.hpp"
#include "gmcr/io.hpp"
#include "gmcr/version.hpp"
#include "help/help.hpp"
#include "help/spelling.hpp"
#include "output/stderr_text.hpp"
#include "output/terminal.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kExamples = R"(Examples:
  gmcr register scan2.ply scan1.ply -o T.txt --aligned scan2_aligned.ply
  gmcr solve matches.csv --noise-bound 0.05
  gmcr solve --help

Exit codes: 0 pose found, 1 no pose, 2 bad usage or input, 3 file cannot be read or written.)";

/// Reports the error on one line of stderr.
ExitCode fail(ExitCode code, std::string message) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  print_to_stderr("gmcr: " + message + "\n");
  return code;
}

/// "noise_bound: -1 ..." of the library names its option; here it is a flag of the command.
std::string with_flag(const InvalidOption& error, const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands()) {
    // of "gravity.source" the tool may know only --gravity
    for (std::string name = error.option(); !name.empty();) {
      if (command->get_option_no_throw(flag_of(name))) {
        return flag_of(name) + ": " + error.problem();
      }
      const std::size_t dot = name.rfind('.');
      name = dot == std::string::npos ? "" : name.substr(0, dot);
    }
  }
  return error.what();
}

/// "gmcr solve --help" where the command line names a command.
std::string help_command(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? "gmcr --help"
                          : fmt::format("gmcr {} --help", commands.front()->get_name());
}

void log_to_stderr() {
  const auto logger =
      spdlog::stderr_color_mt("gmcr", takes_colours(STDERR_FILENO) ? spdlog::color_mode::automatic
                                                                   : spdlog::color_mode::never);
  logger->set_pattern("gmcr: %^%l%$: %v");
  spdlog::set_default_logger(logger);
}

int run(int argc, char** argv) {
  CLI::App app(
      "Robust registration of 3-D point sets: which transform aligns them, which\n"
      "correspondences agree with it, and how far that is from the best possible.",
      "gmcr");
  app.set_version_flag("--version", kVersion);
  app.require_subcommand(0, 1);
  app.footer(kExamples);
  app.formatter(std::make_shared<HelpFormatter>());
  Work work;
  add_register_command(app, work);
  add_localise_command(app, work);
  add_solve_command(app, work);
  add_match_command(app, work);
  add_prepare_command(app, work);
  add_clique_command(app, work);
  add_synth_command(app, work);
  add_eval_command(app, work);
  add_info_command(app, work);
  add_manual_command(app, work);
  add_completion_command(app, work);
  for (CLI::App* command : app.get_subcommands(nullptr)) command->group("Commands");
  try {
    app.parse(argc, argv);
    // not left to CLI11, which would not name a command that it does not know
    if (!work) throw CLI::RequiredError("A command");
    const ExitCode code = work();
    // what is buffered may be what a full disk refuses
    if (std::fflush(stdout) != 0) throw IoError("standard output", 0, std::strerror(errno));
    return code;
  } catch (const CLI::Success& request) {
    const int code = app.exit(request);  // --help or --version
    if (!std::cout.flush()) return fail(kBadFile, "standard output: cannot be written");
    return code;
  } catch (const CLI::ParseError& error) {
    const std::optional<std::string> unknown = unknown_word(app, argc, argv);
    return fail(kBadInput, unknown.value_or(as_written(error.what(), app, argc, argv)) +
                               fmt::format(" (see {})", help_command(app)));
  } catch (const IoError& error) {
    return fail(kBadFile, error.what());
  } catch (const InvalidOption& error) {
    return fail(kBadInput, as_written(with_flag(error, app), app, argc, argv));
  } catch (const std::invalid_argument& error) {
    return fail(kBadInput, error.what());
  } catch (const std::system_error& error) {  // of fmt::print
    return fail(kBadFile, std::string("standard output: ") + error.what());
  } catch (const std::bad_alloc&) {
    return fail(kBadInput, "not enough memory; try a smaller --memory-limit or fewer points");
  } catch (const std::exception& error) {
    return fail(kBadInput, std::string("unexpected error: ") + error.what());
  }
}

}  // namespace
}  // namespace gmcr::cli

int main(int argc, char** argv) {
  gmcr::cli::log_to_stderr();
  return gmcr::cli::run(argc, argv);
}
