#include "arguments/priors_arguments.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "arguments/option_flags.hpp"
#include "arguments/validators.hpp"
#include "input/read_pose.hpp"
#include "options/table.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kGroup = "Priors";
constexpr const char* kGravity = "--gravity";

/// At most pi, which 180 degrees may exceed by rounding.
double radians(double degrees) {
  return std::min(std::numbers::pi, degrees * std::numbers::pi / 180);
}

std::vector<double> parse_gravity(const CLI::results_t& given) {
  std::vector<double> values;
  for (const std::string& text : given) {
    const std::optional<double> value = to_number(text);
    if (!value || !std::isfinite(*value)) {
      throw CLI::ValidationError(kGravity, "'" + text +
                                               "' is no coordinate; it takes 3 or 6 of them, and "
                                               "files go before it");
    }
    values.push_back(*value);
  }
  if (values.size() != 3 && values.size() != 6) {
    throw CLI::ValidationError(
        kGravity,
        fmt::format("{} values, but a direction has 3 and one for each frame 6", values.size()));
  }
  for (std::size_t start = 0; start < values.size(); start += 3) {
    if (Eigen::Vector3d(&values[start]).isZero(0)) {
      throw CLI::ValidationError(kGravity, "(0, 0, 0) is no direction");
    }
  }
  return values;
}

/// What help says of an option whose unit on the command line is degrees, or as it is.
std::string help_in_degrees(options::About about, bool is_angle) {
  if (is_angle) about.unit = "degrees";
  if (is_angle) about.range = {nullptr, "in [0, 180]"};
  return options::describe(about);
}

/// Adds the option of a prior at `place`; an angle is given in degrees.
/// @param prefix  of its name.
template <class Prior>
CLI::Option* add_limit(CLI::App& command, const std::string& prefix, double Prior::*place,
                       std::optional<double>& value) {
  CLI::Option* flag = nullptr;
  options::for_each_option<Prior>([&](const auto& option) {
    if constexpr (std::is_same_v<decltype(option.place), double Prior::*>) {
      const options::About& about = option.about;
      if (option.place != place) return;
      const bool is_angle = about.unit == std::string("radians");
      flag = command
                 .add_option(flags_of(prefix + about.name, about.alias), value,
                             help_in_degrees(about, is_angle))
                 ->check(is_angle ? between(0, 180, "degrees") : at_least(0))
                 ->type_name(is_angle ? "DEG" : "M")
                 ->group(about.group);
    }
  });
  return flag;
}

}  // namespace

void PriorsArguments::add_to(CLI::App& command) {
  auto* gravity_option = command.add_option(
      kGravity,
      [this](const CLI::results_t& given) {
        gravity = parse_gravity(given);
        return true;
      },
      "Direction of gravity in the source frame and, where it differs, in the target frame");
  gravity_option->expected(3, 6)->type_name("X Y Z [X Y Z]")->group(kGroup);
  auto* pose_option = command
                          .add_option("--initial-pose", initial_pose,
                                      "Pose near which to look, T.txt or result.json")
                          ->type_name("T.txt")
                          ->group(kGroup);
  add_limit(command, "gravity.", &GravityPrior::max_tilt, max_tilt_deg)
      ->default_str("0")
      ->needs(gravity_option);
  add_limit(command, "initial_pose.", &InitialPose::max_rotation, max_rotation_error_deg)
      ->needs(pose_option);
  add_limit(command, "initial_pose.", &InitialPose::max_translation, max_translation_error)
      ->needs(pose_option);
}

void PriorsArguments::add_to(Options& options) const {
  if (!gravity.empty()) {
    GravityPrior& prior = options.gravity.emplace();
    prior.source = Eigen::Vector3d(gravity.data());
    prior.target = Eigen::Vector3d(gravity.data() + gravity.size() - 3);
    if (max_tilt_deg) prior.max_tilt = radians(*max_tilt_deg);
  }
  if (initial_pose.empty()) return;
  if (!max_rotation_error_deg && !max_translation_error) {
    throw std::invalid_argument(
        "--initial-pose needs --max-rotation-error, --max-translation-error or both");
  }
  InitialPose& prior = options.initial_pose.emplace();
  prior.target_from_source = read_pose(initial_pose);
  prior.max_rotation = radians(max_rotation_error_deg.value_or(180));
  prior.max_translation = max_translation_error.value_or(prior.max_translation);
}

}  // namespace gmcr::cli
