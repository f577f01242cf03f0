#include "arguments/arguments.hpp"

#include <stdexcept>

#include "arguments/choice.hpp"
#include "arguments/validators.hpp"

namespace gmcr::cli {

void add_scale(CLI::App& command, Options& options) {
  constexpr const char* kGroup = "Scale";
  add_flags(command, options,
            [](const std::string& name) { return name == "scale_mode" || name == "scale"; });
  command
      .add_flag_callback(
          "--estimate-scale", [&options] { options.scale_mode = ScaleMode::Estimated; },
          "Search for the scale too: --scale-mode estimated")
      ->excludes(command.get_option("--scale"))
      ->group(kGroup);
}

void add_required_verdict(CLI::App& command, Verdict& required) {
  add_choice(command, "--require", required,
             "Least verdict that counts as a pose: exit with 1 below it")
      ->group("Answers");
}

void InstanceArguments::add_to(CLI::App& command) {
  add_flags(command, limits);
  CLI::Option* wanted = command.get_option("--max-instances");
  wanted->type_name("K")->default_str("");
  for (const char* name : {"--min-instance-inliers", "--min-instance-share"}) {
    command.get_option(name)->needs(wanted);
  }
}

void SolverArguments::add_to(CLI::App& command) {
  add_scale(command, options);
  priors.add_to(command);
  add_flags(command, options, [](const std::string& name) {
    return !name.starts_with("noise") && name != "scale_mode" && name != "scale";
  });
}

Options SolverArguments::resolved() const {
  Options resolved = options;
  resolved.noise_mode = noise.mode;
  resolved.noise_bound = noise.bound.value_or(resolved.noise_bound);
  priors.add_to(resolved);
  Options checked = resolved;  // 0 comes from the clouds or from the file of matches
  if (noise.mode == NoiseMode::Given && resolved.noise_bound == 0) checked.noise_bound = 1;
  checked.validate();
  return resolved;
}

CloudFiles::CloudFiles(const CloudArguments& clouds)
    : source(clouds.source == "-" && clouds.target == "-"
                 ? throw std::invalid_argument("SOURCE, TARGET: only one can be stdin")
                 : clouds.source),
      target(clouds.target) {}

void add_reading(CLI::App& command, CloudOptions& reading) {
  constexpr const char* kGroup = "Files";
  command
      .add_option("--mesh-points", reading.mesh_points,
                  "Points spread over the surface of a mesh; 0: its vertices")
      ->capture_default_str()
      ->check(at_least(0))
      ->type_name("N")
      ->group(kGroup);
  command
      .add_option("--bin-columns", reading.bin_columns,
                  "Float32 numbers of a point in .bin files; 0: told by size and content")
      ->capture_default_str()
      ->check(at_least(0))
      ->type_name("N")
      ->group(kGroup);
}

void CloudArguments::add_to(CLI::App& command, const Selection& selection) {
  command.add_option("SOURCE", source, "Cloud to move, or - for stdin")->required();
  command.add_option("TARGET", target, "Cloud to move it onto, or - for stdin")->required();
  add_reading(command, reading);
  add_flags(command, frontend, selection);
}

}  // namespace gmcr::cli
