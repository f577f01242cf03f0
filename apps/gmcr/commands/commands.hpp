#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "gmcr/result.hpp"

namespace gmcr::cli {

/// What the process returns.
enum ExitCode : int {
  kPoseFound = 0,  ///< or, for commands that look for no pose: done
  kNoPose = 1,
  kBadInput = 2,
  kBadFile = 3,
};

/// That of an answer, where a verdict is required of it.
inline ExitCode exit_code_of(const Result& result, Verdict verdict, Verdict required) {
  return result.status == Status::Ok && verdict <= required ? kPoseFound : kNoPose;
}

/// The work that the command line asks for; set by the command that was named.
using Work = std::function<ExitCode()>;

// Each adds one command to `app`, which sets `work` when it is named.
void add_register_command(CLI::App& app, Work& work);
void add_localise_command(CLI::App& app, Work& work);
void add_solve_command(CLI::App& app, Work& work);
void add_match_command(CLI::App& app, Work& work);
void add_prepare_command(CLI::App& app, Work& work);
void add_clique_command(CLI::App& app, Work& work);
void add_synth_command(CLI::App& app, Work& work);
void add_eval_command(CLI::App& app, Work& work);
void add_info_command(CLI::App& app, Work& work);
void add_manual_command(CLI::App& app, Work& work);
void add_completion_command(CLI::App& app, Work& work);

}  // namespace gmcr::cli
