#include "arguments/output_arguments.hpp"

#include <spdlog/spdlog.h>

namespace gmcr::cli {

void OutputArguments::add_to(CLI::App& command) {
  constexpr const char* kGroup = "Output";
  command.add_flag("--json", json, "Print one JSON object")->group(kGroup);
  command
      .add_flag_callback(
          "-q,--quiet",
          [this] {
            quiet = true;
            spdlog::set_level(spdlog::level::err);
          },
          "Print neither a report nor progress nor notes; errors are said")
      ->group(kGroup);
}

}  // namespace gmcr::cli
