#include <fmt/core.h>
#include <fmt/ranges.h>

#include "commands/commands.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/isa.hpp"
#include "gmcr/options.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/version.hpp"
#include "output/options_json.hpp"
#include "output/report.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kInfoExamples = R"(Examples:
  gmcr info
  gmcr info --json)";

Json defaults() {
  Json json = to_json(Options{});
  json.update(to_json(FrontendOptions{}));
  json.update(to_json(InstanceOptions{}));
  return json;
}

/// Threads that the solver uses where it may use all; it says so of no matches at all too.
int num_threads() {
  Options options;
  options.noise_bound = 1;
  const Points none(3, 0);
  return register_correspondences(none, none, options).diagnostics.num_threads;
}

ExitCode run_info(const OutputArguments& output) {
  Json json;
  json["version"] = kVersion;
  json["isa"] = active_isa();
  json["supported_isas"] = supported_isas();
  json["threads"] = num_threads();
  json["build_type"] = GMCR_BUILD_TYPE;
  json["compiler"] = __VERSION__;
  json["defaults"] = defaults();
  // as they were called at first, for programs that read them so
  json["defaults"]["hypotheses"] = Options{}.num_hypotheses;
  json["defaults"]["attempts"] = FrontendOptions{}.max_attempts;
  if (output.json) {
    print(json);
    return kPoseFound;
  }
  Report report(output);
  report.line("gmcr", kVersion);
  report.line("isa", fmt::format("{}, of {}", active_isa(), fmt::join(supported_isas(), " ")));
  report.line("threads", json["threads"].dump());
  report.line("build", fmt::format("{}, {}", GMCR_BUILD_TYPE, __VERSION__));
  std::string title = "defaults";
  const Json values = defaults();  // items() of a temporary would outlive it
  for (const auto& [name, value] : values.items()) {
    report.line(title, fmt::format("{:<20} {}", name,
                                   value.is_string() ? value.get<std::string>() : value.dump()));
    title.clear();
  }
  report.print();
  return kPoseFound;
}

}  // namespace

void add_info_command(CLI::App& app, Work& work) {
  const auto output = std::make_shared<OutputArguments>();
  CLI::App& command = *app.add_subcommand("info", "Version, instruction set, threads, defaults");
  output->add_to(command);
  command.footer(kInfoExamples);
  command.callback([output, &work] { work = [output] { return run_info(*output); }; });
}

}  // namespace gmcr::cli
